#!/usr/bin/env bash
# Builds the manual and the reference without a checkout of CGAL: build/doc/html/index.html
set -euo pipefail
here=$(cd "$(dirname "$0")/.." && pwd)
cd "$here"

command -v doxygen > /dev/null || { echo "doxygen is missing: apt-get install doxygen" >&2; exit 1; }
mkdir -p build/doc
doxygen doc/Bubble_relaxation_2/standalone/Doxyfile
echo "build/doc/html/index.html"
