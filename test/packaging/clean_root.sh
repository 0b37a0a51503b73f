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
# what is installed here depends on (never nothing: there is a comma at least), and the names of its lists of files:
# dpkg is asked once for all, since it reads all of its database each time
declare -A depends list_of is_visited
native=$(dpkg --print-architecture)
while IFS=$'\t' read -r name list status architecture dependencies; do
  if [ "$status" = installed ] && { [ "$architecture" = all ] || [ "$architecture" = "$native" ]; }; then
    depends[$name]=$dependencies
    list_of[$name]=$list
  fi
done < <(dpkg-query -W \
  -f='${Package}\t${binary:Package}\t${db:Status-Status}\t${Architecture}\t${Pre-Depends}, ${Depends}\n')

# the packages of a list of dependencies: of alternatives the one that is here, nothing virtual
names_in() {
  local list needed alternatives alternative name
  IFS=',' read -r -a list <<< "$1"
  for needed in "${list[@]}"; do
    IFS='|' read -r -a alternatives <<< "$needed"
    for alternative in "${alternatives[@]}"; do
      name=${alternative%%(*}
      name=${name//[[:space:]]/}
      name=${name%%:*}
      if [ -n "$name" ] && [ -n "${depends[$name]:-}" ]; then
        echo "$name"
        break
      fi
    done
  done
}

# takes a package of this system over, and all that it depends on: for those that are to be registered, and for those
# whose files are to be copied
adopt() { # NAME with_files|without_files
  [ -z "${is_visited[$*]:-}" ] || return 0
  is_visited[$*]=$1
  local name
  for name in $(names_in "${depends[$1]}"); do
    adopt "$name" "$2"
  done
}

for package in "$@"; do
  files=without_files
  [ "$(dpkg-deb -f "$package" Package)" != npbs-mesh ] || files=with_files
  for name in $(names_in "$(dpkg-deb -f "$package" Depends)"); do
    adopt "$name" "$files"
  done
done
mapfile -t registered < <(printf '%s\n' "${is_visited[@]}" | sort -u)
mapfile -t copied < <(for key in "${!is_visited[@]}"; do echo "$key"; done | sed -n 's/ with_files$//p' | sort)
for name in "${registered[@]}"; do
  cp "/var/lib/dpkg/info/${list_of[$name]}.list" "$root/var/lib/dpkg/info/"
done
dpkg-query -s "${registered[@]}" > "$root/var/lib/dpkg/status"
dpkg-query -L "${copied[@]}" | sort -u | while read -r file; do
  [ -d "$file" ] && [ ! -L "$file" ] || echo "${file#/}"
done | tar -C / --create --ignore-failed-read --files-from=- 2> /dev/null |
  tar -C "$root" --extract --keep-directory-symlink

# dpkg itself checks the dependencies, and refuses what misses one
for package in "$@"; do
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
