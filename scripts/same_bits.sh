#!/usr/bin/env bash
# Makes meshes of all kinds by programs that are compiled in several ways, for this machine and for others, prints the
# hashes of all their bits, and compares them with those that are stored in test/Bubble_relaxation_2/same_bits/meshes.h.
#   scripts/same_bits.sh [NAME...]    of gcc-O0 gcc-O3-native clang-O2 i686 aarch64; by default all
# Those of this machine have the options of CMake's target. The others are emulated: i686 has 32 bits and SSE2, aarch64
# fused operations and other vectors. A program takes one or two minutes to compile.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
cd "$here"
names=("$@")
[ ${#names[@]} -gt 0 ] || names=(gcc-O0 gcc-O3-native clang-O2 i686 aarch64)

scripts/install_dependencies.sh
out=build/same_bits
mkdir -p "$out/include"

for_this_machine() { # NAME COMPILER OPTIONS
  cmake -S . -B "$out/$1.build" -G Ninja -DCMAKE_CXX_COMPILER="$2" -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_FLAGS_RELEASE="$3 -DNDEBUG" -DBUBBLE_RELAXATION_2_EXAMPLES=OFF -DBUBBLE_RELAXATION_2_DEMOS=OFF \
    -DBUBBLE_RELAXATION_2_TEST_FILTER=print_hashes > "$out/$1.log" 2>&1 &&
    cmake --build "$out/$1.build" --target print_hashes >> "$out/$1.log" 2>&1 ||
    { cat "$out/$1.log"; return 1; }
  ln -sf "../../$out/$1.build/test/Bubble_relaxation_2/print_hashes" "$out/$1"
}

for_another() { # NAME COMPILER OPTION...
  # the headers of CGAL and Boost, without the others that are in their folder; there is no GMP of other machines, so
  # CGAL takes Boost's numbers, which are as exact
  ln -sfn /usr/include/CGAL "$out/include/CGAL"
  ln -sfn /usr/include/boost "$out/include/boost"
  local name=$1 compiler=$2 vectors=()
  shift 2
  case $("$compiler" -dumpfullversion) in
  12.[0-2].*) vectors=(-fno-tree-slp-vectorize) ;; # as in CMakeLists.txt
  esac
  ccache "$compiler" -std=c++17 -ffp-contract=off -DCGAL_BUBBLE_RELAXATION_2_NO_CONTRACTION "${vectors[@]}" "$@" \
    -DNDEBUG -DCGAL_DISABLE_GMP=1 -Iinclude -isystem "$out/include" -w -Wno-psabi \
    -c test/Bubble_relaxation_2/same_bits/print_hashes.cpp -o "$out/$name.o"
  "$compiler" -static "$out/$name.o" -o "$out/$name"
}

status=0
for name in "${names[@]}"; do
  echo "==== $name"
  run=()
  start=$SECONDS
  case "$name" in
  gcc-O0) for_this_machine "$name" g++ -O0 ;;
  gcc-O3-native) for_this_machine "$name" g++ "-O3 -march=native" ;;
  clang-O2)
    scripts/install_dependencies.sh clang
    for_this_machine "$name" clang++ -O2
    ;;
  i686)
    scripts/install_dependencies.sh g++-i686-linux-gnu qemu-user
    for_another "$name" i686-linux-gnu-g++ -O2 -msse2 -mfpmath=sse
    run=(qemu-i386) # some kernels run no programs of 32 bits
    ;;
  aarch64)
    scripts/install_dependencies.sh g++-aarch64-linux-gnu qemu-user
    for_another "$name" aarch64-linux-gnu-g++ -O2
    run=(qemu-aarch64)
    ;;
  *)
    echo "scripts/same_bits.sh: there is no $name" >&2
    exit 2
    ;;
  esac
  compiled=$SECONDS
  "${run[@]}" "$out/$name" || status=1
  echo "($((compiled - start)) s to compile, $((SECONDS - compiled)) s to run)"
done
if [ "$status" -eq 0 ]; then
  echo "the same bits: ${names[*]}"
else
  echo "not the same bits" >&2
fi
exit "$status"
