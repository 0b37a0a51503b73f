#!/usr/bin/env bash
# Installs Debian's packages into an empty root that has nothing but what they depend on, and runs the program there.
# The files of the dependencies are those of this system, so no network is needed.
#   clean_root.sh ROOT DOMAIN.wkt PACKAGE.deb ...
# Exit code 77: who runs this may not change the root.
set -euo pipefail

if [ "$(id -u)" -ne 0 ]; then
  unshare --map-root-user true 2> /dev/null || { echo "neither root nor user namespaces"; exit 77; }
  exec unshare --map-root-user "$0" "$@"
fi

root=$1 domain=$2
shift 2
unset LD_LIBRARY_PATH LD_PRELOAD
PATH=$PATH:/usr/sbin:/sbin # where chroot is
rm -rf "$root"
mkdir -p "$root"/{usr,tmp} "$root"/var/lib/dpkg/{info,updates,triggers}
for folder in bin lib lib64 sbin; do # on a merged system these are links, and the dynamic linker is found by one
  [ ! -L "/$folder" ] || { mkdir -p "$root/usr/$folder" && ln -s "usr/$folder" "$root/$folder"; }
done
touch "$root/var/lib/dpkg/status"
declare -A is_registered is_visited

# the packages of a list of dependencies: of alternatives the one that is here, nothing virtual
names_in() {
  tr ',' '\n' <<< "$1" | while IFS='|' read -r -a alternatives; do
    for alternative in "${alternatives[@]}"; do
      name=$(sed -E 's/\(.*//; s/[[:space:]]//g; s/:any//' <<< "$alternative")
      if [ -n "$name" ] && dpkg-query -W -f='${Status}' "$name" 2> /dev/null | grep -q 'ok installed$'; then
        echo "$name"
        break
      fi
    done
  done
}

# takes a package of this system over, and all that it depends on: registers it, and copies its files on
# demand
adopt() { # NAME with_files|without_files
  [ -z "${is_visited[$*]:-}" ] || return 0
  is_visited[$*]=yes
  if [ -z "${is_registered[$1]:-}" ]; then
    is_registered[$1]=yes
    { dpkg-query -s "$1" && echo; } >> "$root/var/lib/dpkg/status"
    cp "$(dpkg-query -c "$1" md5sums | sed 's/md5sums$/list/')" "$root/var/lib/dpkg/info/"
  fi
  if [ "$2" = with_files ]; then
    dpkg-query -L "$1" | while read -r file; do
      [ -d "$file" ] && [ ! -L "$file" ] || echo "${file#/}"
    done | tar -C / --create --ignore-failed-read --files-from=- 2> /dev/null |
      tar -C "$root" --extract --keep-directory-symlink
  fi
  local name
  for name in $(names_in "$(dpkg-query -W -f='${Pre-Depends}, ${Depends}' "$1")"); do
    adopt "$name" "$2"
  done
}

# dpkg itself checks the dependencies, and refuses what misses one
for package in "$@"; do
  files=without_files
  [ "$(dpkg-deb -f "$package" Package)" != npbs-mesh ] || files=with_files
  for name in $(names_in "$(dpkg-deb -f "$package" Depends)"); do
    adopt "$name" "$files"
  done
  dpkg --root="$root" --force-script-chrootless --log=/dev/null --install "$package"
done

# the links that scripts of packages would have made, to the one of several libraries that serves
find /usr/lib -lname '/etc/alternatives/*' | while read -r link; do
  if [ -e "$root$(readlink -f "$link")" ]; then
    mkdir -p "$root/etc/alternatives"
    cp -P "$(readlink "$link")" "$root/etc/alternatives/"
    cp -P "$link" "$root$link"
  fi
done

if [ -x "$root/usr/bin/npbs_mesh" ]; then
  cp "$domain" "$root/domain.wkt"
  chroot "$root" /usr/bin/npbs_mesh --version
  chroot "$root" /usr/bin/npbs_mesh /domain.wkt --size 0.2 --output /mesh.vtu
  grep -q '<VTKFile' "$root/mesh.vtu"
fi
echo "installed in a clean root: $*"
