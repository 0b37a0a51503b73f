#!/usr/bin/env bash
# Meshes the Aegean for a model of tides, from packages of Debian alone: GMT's coasts become an outline that GDAL reads,
# with a field that tells the coast, 1, from the open sea, 2. d is a share of the length of the tide's wave,
# T sqrt(g h) / n.
# No package has depths: those here are made up, of the distance to the coast; any raster that GDAL reads will do.
#   scripts/mesh_a_sea.sh [n]     elements in a wave length, by default 100
# The first time it takes some minutes: one for the distances, the rest to install and to compile.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
cd "$here"
n=${1-100}

scripts/install_dependencies.sh
scripts/install_dependencies.sh libgdal-dev gmt gmt-gshhg-low python3-shapely
mkdir -p build output
echo "the program"
cmake -S . -B build/release -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUBBLE_RELAXATION_2_TESTS=OFF \
  > build/configure.log 2>&1 ||
  { cat build/configure.log; exit 1; }
cmake --build build/release --target npbs_mesh
cd output

echo "the coast, and depths"
box=22.5/28.5/34.8/41.1
gmt coast "-R$box" -Dl -A0/0/1 -M -W --FORMAT_FLOAT_OUT=%.9g --GMT_HISTORY=false > coast.txt
# metres, of kilometres to the coast; beyond the box too, since outlines within a tolerance are there as well
gmt grdmath -R22/29/34.3/41.6 -I3m -Dl -A0/0/1 LDISTG 12 MUL 20 ADD = depth.nc --GMT_HISTORY=false
rm -f gmt.history # which gmt leaves all the same
# Debian's own python, which has Debian's modules
/usr/bin/python3 ../demo/Bubble_relaxation_2/data/make_sea.py "$box" 25 38.5 < coast.txt > sea.geojson
echo "the mesh"
size="44714*sqrt(9.81*max(raster, 1))/$n" # of the tide M2
../build/release/demo/Bubble_relaxation_2/npbs_mesh sea.geojson --field marker --raster depth.nc --size "$size" \
  --gradation 0.2 --tolerance 0.1 --min-island 5e6 --min-gap 3000 --depth raster --open 2 \
  --output aegean.14 --picture aegean.svg
echo "the mesh:    output/aegean.14 (for ADCIRC; SCHISM calls it hgrid.gr3)"
echo "its picture: output/aegean.svg"
