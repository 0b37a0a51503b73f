#!/usr/bin/env bash
# Installs what is missing, builds and runs a benchmark; arguments go to it, files land in output/:
#   benchmark.sh [scaling] [1e7] [--threads 2]    cost, memory and threads over the number of vertices
#   benchmark.sh compare [1000 ...]               this package, CGAL's 2D Meshes and Gmsh: table, JSON, SVG
#   benchmark.sh phases                           nanoseconds a node of each phase
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
cd "$here"

benchmark=scaling
case ${1-} in
  scaling | compare | phases) benchmark=$1; shift ;;
esac
scripts/install_dependencies.sh
if [ "$benchmark" = compare ]; then
  scripts/install_dependencies.sh libgmsh-dev
  benchmark=compare_meshers
  set -- --json compare_meshers.json --svg compare_meshers.svg "$@"
fi
cmake -S . -B build/benchmark -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUBBLE_RELAXATION_2_TESTS=OFF \
  -DBUBBLE_RELAXATION_2_EXAMPLES=OFF -DBUBBLE_RELAXATION_2_BENCHMARKS=ON > /dev/null
cmake --build build/benchmark --target "$benchmark"
mkdir -p output
cd output
"../build/benchmark/benchmark/Bubble_relaxation_2/$benchmark" "$@"
