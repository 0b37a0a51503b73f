#!/usr/bin/env bash
# Installs what is missing, builds everything with warnings as errors, and runs all tests: with the
# system's CGAL, part of them with sanitizers, and part of them with newer versions of CGAL.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
cd "$here"

scripts/install_dependencies.sh
# clang's warnings are others; npbs_mesh reads maps by GDAL; Gmsh and meshio read files that are written
scripts/install_dependencies.sh clang libgdal-dev gdal-bin gmsh python3-meshio
export CTEST_PARALLEL_LEVEL=2
export CCACHE_SLOPPINESS=pch_defines,time_macros # else it keeps nothing that uses precompiled headers
export CCACHE_DEPEND=true # else it preprocesses all that is compiled once more

build_and_test() { # NAME OPTION...
  local name=$1
  shift
  echo "==== $name"
  cmake -S . -B "build/$name" -G Ninja -DBUBBLE_RELAXATION_2_TESTS=ON \
    -DBUBBLE_RELAXATION_2_COMPILED_CORE=ON -DBUBBLE_RELAXATION_2_WARNINGS_AS_ERRORS=ON "$@"
  cmake --build "build/$name" -- -k 0
  ctest --test-dir "build/$name" --output-on-failure --no-tests=error
}

# meshes of another machine, which is emulated, have the same bits; scripts/same_bits.sh alone has more of them. This
# keeps one core busy for minutes, where others would wait for it
mkdir -p build
setsid scripts/same_bits.sh aarch64 > build/same_bits.log 2>&1 &
same_bits=$!
trap 'kill -- "-$same_bits" 2> /dev/null || true' EXIT # with all that it runs

# All tests, with CGAL's assertions: by clang++ without optimisation, since most of the time goes into compiling, but for
# the libraries, where they run most of the time. CGAL's exact numbers are GMP's own here, not those of Boost as below:
# what Boost's instantiate in each file takes seconds. The sanitizers have more of hostile input.
BUBBLE_RELAXATION_2_FUZZ_SECONDS=10 build_and_test test -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Release \
  -DBUBBLE_RELAXATION_2_CORE_OPTIONS=-O2 -DCMAKE_CXX_FLAGS_RELEASE="-O0 -DCGAL_DO_NOT_USE_BOOST_MP"

status=0
wait "$same_bits" || status=$?
trap - EXIT
cat build/same_bits.log
[ "$status" -eq 0 ] || exit "$status"

# what reads and writes the most, with sanitizers: without optimisation, since the compiler takes far
# longer with both, and g++ twice as long as clang++
build_and_test sanitize -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_CXX_FLAGS_DEBUG="-O0 -g1 -D_GLIBCXX_ASSERTIONS" \
  -DBUBBLE_RELAXATION_2_SANITIZE=ON -DBUBBLE_RELAXATION_2_EXAMPLES=OFF -DBUBBLE_RELAXATION_2_DEMOS=OFF \
  -DBUBBLE_RELAXATION_2_TEST_FILTER="test_(bad_input|domain|write_back|fuzz|element_free_galerkin_units)"

test_by_gcc() { # NAME CORE TESTS OPTION...
  local name=$1 core=$2 tests=$3
  shift 3
  build_and_test "$name" -DCMAKE_CXX_COMPILER=g++ -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE="-O0 -DNDEBUG" \
    -DBUBBLE_RELAXATION_2_COMPILED_CORE="$core" -DBUBBLE_RELAXATION_2_CORE_OPTIONS=-O2 \
    -DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON -DBUBBLE_RELAXATION_2_EXAMPLES=OFF -DBUBBLE_RELAXATION_2_DEMOS=OFF \
    -DBUBBLE_RELAXATION_2_TEST_FILTER="$tests" "$@" < /dev/null
}

# By g++, with newer versions of CGAL, where they can be had: what meets their named parameters, by the headers alone, and
# with the newest their triangulations and their Mesh_2 as well
few='test_named_parameters'
many="$few|test_(write_back|terrain|mesh_criteria|place_nodes)"
status=0
scripts/fetch_cgal.sh build/cgal > build/cgal.list || status=$?
if [ "$status" -eq 0 ]; then
  newest=$(grep -v '^skipped' build/cgal.list | cut -d ' ' -f 2 | sort -V | tail -n 1)
  grep -v '^skipped' build/cgal.list | while read -r suite version path; do
    echo "CGAL $version of $suite"
    cgal=-DCGAL_DIR="$(dirname "$(find "$path" -name CGALConfig.cmake | head -n 1)")"
    if [ "$version" = "$newest" ]; then
      test_by_gcc "cgal-$version" ON "$many" "$cgal"
    else
      test_by_gcc "cgal-$version" OFF "$few" "$cgal"
    fi
  done
elif [ "$status" -eq 77 ]; then
  test_by_gcc gcc ON "$many"
else
  cat build/cgal.list
  echo "scripts/fetch_cgal.sh failed with exit code $status" >&2
  exit "$status"
fi
grep '^skipped' build/cgal.list | sed 's/^/SKIPPED: /' || true
