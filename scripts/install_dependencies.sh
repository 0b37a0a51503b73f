#!/usr/bin/env bash
# Installs what is missing of the given packages, on Debian; without arguments, of those that the package,
# its examples, its demos and its tests need:
#   install_dependencies.sh [PACKAGE ...]
set -euo pipefail

packages=("$@")
[ ${#packages[@]} -gt 0 ] ||
  packages=(g++ cmake ninja-build ccache libcgal-dev libgmp-dev libmpfr-dev libboost-dev
            libboost-program-options-dev libmuparser-dev libtbb-dev libgtest-dev
            libopenmpi-dev openmpi-bin libeigen3-dev dpkg-dev)
missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' ||
    missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

echo "installing: ${missing[*]}"
as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
"${as_root[@]}" apt-get update -qq
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
  apt-get install -y -qq --no-install-recommends "${missing[@]}" > /dev/null
