#!/usr/bin/env bash
# Builds the manual and the reference without a checkout of CGAL: build/doc/html/index.html
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
cd "$here"

scripts/install_dependencies.sh doxygen
mkdir -p build/doc
doxygen doc/Bubble_relaxation_2/standalone/Doxyfile
echo "build/doc/html/index.html"
