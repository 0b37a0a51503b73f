#!/usr/bin/env bash
# Copyright (c) 2026 The Bubble_relaxation_2 authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Unpacks the CGAL headers of other Debian suites beside the system, nothing is installed:
#   fetch_cgal.sh DIRECTORY [SUITE ...]        (default: trixie forky)
# Prints a line "SUITE VERSION PATH" for each; PATH/usr/include holds CGAL's headers.
# Exits with 77 and a line "skipped: ..." when no suite can be reached.
set -euo pipefail

if [ $# -lt 1 ]; then
  echo "usage: $0 DIRECTORY [SUITE ...]" >&2
  exit 2
fi
mkdir -p "$1"
directory=$(cd "$1" && pwd)
shift
suites=("$@")
[ ${#suites[@]} -gt 0 ] || suites=(trixie forky)

# the first mirror of the system's own sources, in either format; a missing file is no error
first_mirror() { # SED-SCRIPT FILE...
  local script=$1 file
  shift
  for file in "$@"; do
    [ ! -r "$file" ] || sed -n "$script" "$file"
  done | sed -n 1p
}
mirror=$(first_mirror 's/^URIs:[[:space:]]*\([^[:space:]]*\).*/\1/p' \
           /etc/apt/sources.list.d/*.sources)
[ -n "$mirror" ] ||
  mirror=$(first_mirror 's/^deb[[:space:]]\(\[[^]]*\][[:space:]]*\)\{0,1\}\([^[:space:]]*\).*/\2/p' \
             /etc/apt/sources.list /etc/apt/sources.list.d/*.list)
if [ -z "$mirror" ]; then
  echo "skipped: no package source is configured on this system"
  exit 77
fi

apt_home=$directory/apt
rm -rf "$apt_home"
mkdir -p "$apt_home"/{etc/apt.conf.d,etc/preferences.d,etc/sources.list.d} \
         "$apt_home"/{state/lists/partial,cache/archives/partial}
cp -a /etc/apt/apt.conf.d/. "$apt_home/etc/apt.conf.d/"
: > "$apt_home/state/status"
cat > "$apt_home/apt.conf" <<END
Dir::Etc "$apt_home/etc";
Dir::Etc::sourcelist "$apt_home/etc/sources.list";
Dir::Etc::sourceparts "$apt_home/etc/sources.list.d";
Dir::State "$apt_home/state";
Dir::State::status "$apt_home/state/status";
Dir::Cache "$apt_home/cache";
Acquire::Languages "none";
Acquire::Retries "2";
END
export APT_CONFIG=$apt_home/apt.conf

got=0
for suite in "${suites[@]}"; do
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $suite main" \
    > "$apt_home/etc/sources.list"
  target=$directory/cgal-$suite
  if apt-get update > "$directory/$suite.log" 2>&1 &&
     rm -rf "$target" && mkdir -p "$target" &&
     (cd "$target" && apt-get download "libcgal-dev/$suite") >> "$directory/$suite.log" 2>&1 &&
     dpkg-deb -x "$target"/libcgal-dev_*.deb "$target" >> "$directory/$suite.log" 2>&1; then
    version=$(sed -n 's/^#define CGAL_VERSION \([0-9.]*\).*/\1/p' "$target/usr/include/CGAL/version.h")
    rm -f "$target"/libcgal-dev_*.deb
    echo "$suite $version $target"
    got=1
  else
    echo "skipped: CGAL of Debian $suite cannot be reached, see $directory/$suite.log"
  fi
done
[ $got -eq 1 ] || exit 77
