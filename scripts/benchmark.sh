#!/usr/bin/env bash
# Installs what is missing, builds and runs a benchmark; arguments go to it, files land in output/:
#   benchmark.sh [scaling] [1e7] [--threads 2]    cost, memory and threads over the number of vertices
#   benchmark.sh compare [1000 ...]               this package, CGAL's 2D Meshes and Gmsh: table, JSON, SVG
#   benchmark.sh influence [1e4 1e6]              nodes of influence domains: this package, a grid, CGAL's searches, nanoflann
#   benchmark.sh transfer [1e4 1e6]               values carried over to another mesh: CPU time a vertex and a pair
#   benchmark.sh local [1e4 1e6]                  a part of a mesh meshed anew: time and memory over those of the part alone
#   benchmark.sh local drift [1000]               a mesh after so many local changes, against one made at once
#   benchmark.sh progress [1e6 ...]               what a callback is told: the longest time without a call, told progress over
#                                                 the share of time, and the time from a stop to the return, in each phase
#   benchmark.sh coasts [--size 3] [aegean ...]   real outlines of GSHHG, as they are and simplified: this package, CGAL's
#                                                 2D Meshes and Gmsh: table, SVG
#   benchmark.sh dual [1000 10000] [aegean ...]   Voronoi cells for finite volumes, of domains and simplified shores: obtuse
#                                                 triangles, negative and short faces
#   benchmark.sh compile [--runs 3]               the compiler's time and memory: README's program, compiled core, EFG
#   benchmark.sh distributed [speed [1e5 ...] [aegean ...]]   two MPI ranks against one: seconds, and whether the bits are
#                                                 equal
#   benchmark.sh distributed [counts [1e5] [aegean ...]]      what up to 64 ranks hold and send, and a model of their
#                                                 efficiency
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
cd "$here"

benchmark=scaling
case ${1-} in
  scaling | compare | coasts | influence | transfer | local | progress | dual | compile | distributed) benchmark=$1; shift ;;
esac
scripts/install_dependencies.sh
if [ "$benchmark" = compare ]; then
  scripts/install_dependencies.sh libgmsh-dev
  benchmark=compare_meshers
  set -- --json compare_meshers.json --svg compare_meshers.svg "$@"
fi
if [ "$benchmark" = coasts ] || [ "$benchmark" = dual ] || [ "$benchmark" = distributed ]; then
  scripts/install_dependencies.sh gmt gmt-gshhg-low gmt-gshhg-high
  mkdir -p output/coasts
  cp benchmark/Bubble_relaxation_2/coasts.txt output/coasts/
  while read -r name west east south north _; do
    for resolution in low intermediate high; do
      file=output/coasts/${name}_$resolution.txt
      # in the folder, since gmt leaves a file where it runs
      [ -s "$file" ] || (cd output/coasts && gmt coast "-R$west/$east/$south/$north" "-D${resolution:0:1}" -M -W \
        --FORMAT_FLOAT_OUT=%.9g --GMT_HISTORY=false) > "$file"
    done
  done < <(grep -v '^#' output/coasts/coasts.txt)
fi
if [ "$benchmark" = coasts ]; then
  scripts/install_dependencies.sh libgmsh-dev
  set -- coasts --svg coast.svg "$@"
fi
if [ "$benchmark" = dual ]; then
  set -- --coasts coasts "$@"
fi
if [ "$benchmark" = progress ]; then
  set -- "$here/demo/Bubble_relaxation_2/data/lake.poly" "$@"
fi
if [ "$benchmark" = influence ]; then
  scripts/install_dependencies.sh libnanoflann-dev
  benchmark=influence_search
fi
if [ "$benchmark" = compile ]; then
  scripts/install_dependencies.sh python3
  exec benchmark/Bubble_relaxation_2/compile_times.py "$@"
fi
cmake -S . -B build/benchmark -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUBBLE_RELAXATION_2_TESTS=OFF \
  -DBUBBLE_RELAXATION_2_EXAMPLES=OFF -DBUBBLE_RELAXATION_2_DEMOS=OFF -DBUBBLE_RELAXATION_2_BENCHMARKS=ON > /dev/null
cmake --build build/benchmark --target "$benchmark"
mkdir -p output
cd output
program=../build/benchmark/benchmark/Bubble_relaxation_2/$benchmark
if [ "$benchmark" != distributed ]; then
  "$program" "$@"
  exit
fi

# ranks that are timed have a core each and wait without giving it away; those that are counted share cores
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_btl_vader_single_copy_mechanism=none
command=${1-all}
shift $(($# > 0))
case $command in
  speed | counts | all) ;;
  *) echo "distributed: speed or counts, not $command" >&2; exit 2 ;;
esac
[[ " $* " =~ ' '[a-z] ]] || set -- "$@" norway_intermediate
set -- "$@" --coasts coasts
[ "$command" = counts ] || OMPI_MCA_mpi_yield_when_idle=0 mpirun -n 2 --bind-to core "$program" speed "$@"
[ "$command" = speed ] ||
  OMPI_MCA_mpi_yield_when_idle=1 mpirun -n 64 --oversubscribe --bind-to none "$program" counts "$@"
