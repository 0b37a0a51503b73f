#!/usr/bin/env bash
# Prints which lines of include/ the tests run, file by file and in total; fails under 90 %.
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
cd "$here"

scripts/install_dependencies.sh
scripts/install_dependencies.sh gcovr
cmake -S . -B build/coverage -G Ninja -DCMAKE_BUILD_TYPE=Debug -DBUBBLE_RELAXATION_2_COVERAGE=ON \
  -DBUBBLE_RELAXATION_2_EXAMPLES=OFF -DBUBBLE_RELAXATION_2_DEMOS=OFF > /dev/null
cmake --build build/coverage
find build/coverage -name '*.gcda' -delete
ctest --test-dir build/coverage -j 2 --output-on-failure -E packaging
gcovr --root . --filter include/ --exclude-throw-branches --fail-under-line 90 build/coverage
