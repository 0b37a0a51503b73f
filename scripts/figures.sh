#!/usr/bin/env bash
# Makes the pictures of the manual anew, in doc/Bubble_relaxation_2/fig.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
cd "$here"

scripts/install_dependencies.sh
scripts/install_dependencies.sh librsvg2-bin python3
cmake -S . -B build/release -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUBBLE_RELAXATION_2_TESTS=OFF \
  -DBUBBLE_RELAXATION_2_BENCHMARKS=ON > /dev/null
cmake --build build/release
mkdir -p build/figures
cd build/figures
for example in watch_the_bubbles relax_a_square_with_hole refine_an_existing_mesh node_placement adapt_to_values \
  influence_domains finite_volumes; do
  ../release/examples/Bubble_relaxation_2/$example
done
OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun -n 4 --oversubscribe \
  ../release/demo/Bubble_relaxation_2/distributed_ring
figures=$here/doc/Bubble_relaxation_2/fig
without_messages() { grep -v '^\[\|^ninja\|^installing'; } # of what installs and builds
cp bubbles.svg "$figures"
../release/demo/Bubble_relaxation_2/paper_figures | tee "$figures/figures.txt"
../release/demo/Bubble_relaxation_2/paper_figures --sizes | tee "$figures/sizes.txt"
../release/demo/Bubble_relaxation_2/adaptive_poisson | tee "$figures/adaptive_poisson.txt"
../release/demo/Bubble_relaxation_2/adaptive_cycles | tee "$figures/adaptive_cycles.txt"
../release/demo/Bubble_relaxation_2/efg_poisson | tee "$figures/efg_poisson.txt"
../release/examples/Bubble_relaxation_2/finite_volumes | sed -n 1,5p | tee "$figures/finite_volumes.txt"
../release/benchmark/Bubble_relaxation_2/gradients | tee "$figures/gradients.txt"
../release/benchmark/Bubble_relaxation_2/local 1e4 1e5 1e6 3e6 | tee "$figures/local.txt"
for seed in 1 2 3; do
  ../release/benchmark/Bubble_relaxation_2/local drift 1000 $seed
done | tee "$figures/local_drift.txt"
../release/benchmark/Bubble_relaxation_2/progress "$here/demo/Bubble_relaxation_2/data/lake.poly" 1e6 |
  tee "$figures/progress.txt"
../release/benchmark/Bubble_relaxation_2/transfer | tee "$figures/transfer.txt"
"$here/scripts/benchmark.sh" compare 10000 | without_messages | tee "$figures/compare_meshers.txt"
cp "$here/output/compare_meshers.svg" .
"$here/scripts/benchmark.sh" influence 1e4 1e6 | without_messages | tee "$figures/influence_domains.txt"
"$here/scripts/benchmark.sh" coasts --size 5 norway_low > /dev/null # for the picture
cp "$here/output/coast.svg" .
"$here/scripts/benchmark.sh" coasts {superior,aegean,norway,patagonia,finland}_intermediate |
  without_messages | tee "$figures/coasts.txt"
"$here/scripts/benchmark.sh" dual 1000 10000 {superior,aegean,norway,patagonia,finland}_intermediate |
  without_messages | tee "$figures/dual.txt"
"$here/scripts/same_bits.sh" | grep -v ' s to run' | tail -n 15 | tee "$figures/same_bits.txt" # those of the last one
"$here/doc/Bubble_relaxation_2/draw_rooms.py" rooms.svg
../release/demo/Bubble_relaxation_2/moving_body | tail -n 1 | tee "$figures/moving_body.txt"
cp moving_body.svg "$figures" # it moves
# those that the manual shows
for picture in $(grep -oh '[a-z0-9_]*\.png' "$here"/doc/Bubble_relaxation_2/*.txt | sort -u); do
  rsvg-convert --width 1000 "${picture%.png}.svg" -o "$figures/$picture"
done
