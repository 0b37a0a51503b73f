#!/usr/bin/env bash
# Installs what is missing, builds the mesher, and meshes a lake with its islands.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
cd "$here"

scripts/install_dependencies.sh
mkdir -p build
cmake -S . -B build/release -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUBBLE_RELAXATION_2_TESTS=OFF > build/configure.log 2>&1 ||
  { cat build/configure.log; exit 1; }
echo "building the mesher, which takes a minute or two"
cmake --build build/release --target npbs_mesh
mkdir -p output
build/release/demo/Bubble_relaxation_2/npbs_mesh demo/Bubble_relaxation_2/data/lake.poly \
  --size "min(0.03, 0.008+0.06*abs(sqrt((x-0.25)^2+(y-0.08)^2)-0.3))" --output output/lake.vtu --picture output/lake.svg
echo "the mesh:    output/lake.vtu (for ParaView)"
echo "its picture: output/lake.svg"
