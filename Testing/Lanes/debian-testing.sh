#!/usr/bin/env bash
# The test command of the README in Debian testing: VTK 9.6, the newest GCC, warnings as errors.
#   bash Testing/Lanes/debian-testing.sh [COMMAND...]   COMMAND in the sources, in place of the test command
# Makes a root file system with debootstrap in build/lanes/debian-testing/root, once: about 5 GB. Builds in
# the folder beside it. Takes root; all mounts are those of this process alone and end with it.
# VTKTERRAIN_DATA_DIR is passed on. With VTKTERRAIN_LANE_SUITE=sid, or another suite, the lane is that one's.
set -euo pipefail
if [ "${1:-}" != --mounts-are-own ]; then
  exec unshare --mount --propagation private bash "$0" --mounts-are-own "$@"
fi
shift
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
suite=${VTKTERRAIN_LANE_SUITE:-testing}
lane=${VTKTERRAIN_BUILD_DIR:-$source_dir/build}/lanes/debian-$suite
root=$lane/root
sh "$source_dir/Module/packages.sh" debootstrap

if [ ! -e "$lane/made" ]; then
  mirror=$(sh "$source_dir/Module/debian-mirror.sh")
  rm -rf "$root"
  mkdir -p "$root"
  debootstrap --variant=minbase "$suite" "$root" "$mirror" /usr/share/debootstrap/scripts/sid
  touch "$lane/made"
fi
cp -r /etc/apt/apt.conf.d/. "$root/etc/apt/apt.conf.d/"
cp /etc/resolv.conf /etc/hosts "$root/etc/"

mkdir -p "$lane/build" "$root/src" "$root/build" "$root/data"
for folder in proc sys dev; do
  mount --rbind "/$folder" "$root/$folder"
done
mount --bind "$source_dir" "$root/src"
mount -o remount,ro,bind "$root/src"
mount --bind "$lane/build" "$root/build"
data=""
if [ -n "${VTKTERRAIN_DATA_DIR:-}" ]; then
  mount --bind "$VTKTERRAIN_DATA_DIR" "$root/data"
  data=/data
fi
[ $# -gt 0 ] || set -- sh Testing/run.sh -DVTKTERRAIN_STRICT=ON
env -u DISPLAY VTKTERRAIN_BUILD_DIR=/build VTKTERRAIN_DATA_DIR="$data" LC_ALL=C.UTF-8 \
  chroot "$root" sh -c 'cd /src && exec "$@"' sh "$@"
