#!/usr/bin/env bash
# Makes the pictures of the manual anew, in doc/Bubble_relaxation_2/fig.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
cd "$here"

scripts/install_dependencies.sh
command -v rsvg-convert > /dev/null || { echo "rsvg-convert is missing: apt-get install librsvg2-bin" >&2; exit 1; }
cmake -S . -B build/release -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUBBLE_RELAXATION_2_TESTS=OFF > /dev/null
cmake --build build/release
mkdir -p build/figures
cd build/figures
for example in relax_a_square_with_hole refine_an_existing_mesh node_placement paper_figures; do
  ../release/examples/Bubble_relaxation_2/$example
done
for picture in *.svg; do
  rsvg-convert --width 1000 "$picture" -o "$here/doc/Bubble_relaxation_2/fig/${picture%.svg}.png"
done
