#!/usr/bin/env bash
# Builds and runs the benchmark of scaling; arguments go to it.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
cd "$here"

scripts/install_dependencies.sh
cmake -S . -B build/benchmark -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUBBLE_RELAXATION_2_TESTS=OFF \
  -DBUBBLE_RELAXATION_2_EXAMPLES=OFF -DBUBBLE_RELAXATION_2_BENCHMARKS=ON > /dev/null
cmake --build build/benchmark
build/benchmark/benchmark/Bubble_relaxation_2/scaling "$@"
