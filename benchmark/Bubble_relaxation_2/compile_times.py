#!/usr/bin/env python3
"""What it costs to compile this package's headers: user time and memory of the compiler, at -O2, for

- the README's program that only inserts the outline into CGAL's triangulation (the unit of all ratios),
- the README's program, with headers alone and as a program of the compiled core,
- the compiled core,
- the example of the element-free Galerkin method, both ways.

Each is compiled several times, in turn, and the least is shown: ratios of one run can be compared, seconds cannot.

usage: compile_times.py [--runs N]
"""
import argparse
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
CORE = "-DCGAL_BUBBLE_RELAXATION_2_COMPILED"


def readme_program():
    with open(os.path.join(ROOT, "README.md")) as readme:
        blocks = re.findall(r"```cpp\n(.*?)```", readme.read(), re.S)
    programs = [block for block in blocks if "int main()" in block]
    if not programs:
        sys.exit("compile_times.py: README.md has no program")
    return programs[0]


def without_mesher(program):
    """the same program up to the call, without what it needs for it"""
    lines = [line for line in program.splitlines() if "npbs_relax" not in line and "report" not in line]
    return "\n".join(line for line in lines if "const auto d" not in line) + "\n"


def compile_once(source, options):
    """returns user seconds and MB of one call of the compiler"""
    command = [os.environ.get("CXX", "g++"), "-std=c++17", "-O2", "-I" + os.path.join(ROOT, "include"),
               "-I/usr/include/eigen3", *options, "-c", source, "-o", os.devnull]
    process = subprocess.Popen(command)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit("compile_times.py: " + " ".join(command) + " failed")
    return usage.ru_utime, usage.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description="user time and memory of the compiler, as ratios")
    parser.add_argument("--runs", type=int, default=3, help="how often each is compiled (default: 3)")
    runs = parser.parse_args().runs
    if runs < 1:
        parser.error("--runs must be positive")
    with tempfile.TemporaryDirectory() as folder:
        def write(name, text):
            path = os.path.join(folder, name)
            with open(path, "w") as file:
                file.write(text)
            return path

        program = write("readme.cpp", readme_program())
        galerkin = os.path.join(ROOT, "examples", "Bubble_relaxation_2", "element_free_galerkin.cpp")
        core = os.path.join(ROOT, "src", "Bubble_relaxation_2", "core.cpp")
        rows = [("outline only", write("outline.cpp", without_mesher(readme_program())), []),
                ("README, headers alone", program, []), ("README, compiled core", program, [CORE]),
                ("the core itself", core, [CORE]), ("EFG, headers alone", galerkin, []),
                ("EFG, compiled core", galerkin, [CORE])]
        figures = {name: [] for name, _, _ in rows}
        for _ in range(runs):
            for name, source, options in rows:
                figures[name].append(compile_once(source, options))
    unit = min(figures["outline only"])[0]
    print("%-24s %10s %8s %8s" % ("", "user s", "ratio", "MB"))
    for name, _, _ in rows:
        seconds, megabytes = min(figures[name])
        print("%-24s %10.1f %8.2f %8.0f" % (name, seconds, seconds / unit, megabytes))


if __name__ == "__main__":
    main()
