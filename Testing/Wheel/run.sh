#!/usr/bin/env bash
# Installs the wheel that Module/Python/wheel.sh has left in DIR as a new user would, in clean rooms without
# a compiler, and runs the Python tests, the README's snippets and the notebook there:
#   - a bare Debian 13 (CPython 3.13) and, with VTKTERRAIN_CI_ALL, a bare Debian testing (3.14), where
#     nothing of VTK, GDAL or Python's packages is but what pip brings;
#   - environments of two CPythons on this machine.
# Their pictures must be those of the build in BUILD_DIR: bit for bit, but in Debian testing, whose Mesa
# is another one.
#   bash Testing/Wheel/run.sh DIR [BUILD_DIR]
# Needs root (for the bare machine) and debootstrap. The rooms are left in DIR/rooms.
set -euo pipefail
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
dist=$(cd "$1" && pwd)
build=$(cd "${2:-$source_dir/build}" && pwd)
rooms=$dist/rooms
packages="pyvista[jupyter]==0.49.1 rasterio pyogrio xarray rioxarray geopandas odc-geo dask matplotlib nbconvert \
ipykernel playwright"
mkdir -p "$rooms"
wheel=$(ls "$dist"/vtkterrain-*.whl)

fail()
{
  printf '%s\n' "$*" >&2
  exit 1
}

# The picture of the Debian build.
picture_of_the_build()
{
  PYTHONPATH=$(ls -d "$build"/lib/python3*/*-packages) VTK_DEFAULT_OPENGL_WINDOW=vtkEGLRenderWindow \
    /usr/bin/python3 "$source_dir/Examples/Python/render.py" "$source_dir/Examples/Places/heights.tif" "$rooms/build.png"
}

# A Debian with Python and a driver of OpenGL, no compiler, in rooms/RELEASE.
make_bare()
{
  local release=$1 mirror
  [ ! -e "$rooms/$release/.complete" ] || return 0
  mirror=$(sh "$source_dir/Module/debian-mirror.sh")
  rm -rf "${rooms:?}/$release"
  debootstrap --variant=minbase --include=python3,python3-venv,libegl1,libgl1-mesa-dri \
    "$release" "$rooms/$release" "$mirror" /usr/share/debootstrap/scripts/sid >"$rooms/$release.log" 2>&1 ||
    fail "$(tail -5 "$rooms/$release.log")"
  cp -L /etc/resolv.conf /etc/hosts "$rooms/$release/etc/"
  mkdir -p "$rooms/$release/etc/ssl/certs"
  cp -L /etc/ssl/certs/ca-certificates.crt "$rooms/$release/etc/ssl/certs/"
  touch "$rooms/$release/.complete"
}

# Runs inside.sh in a bare machine, which sees this source and the wheel, read only.
run_bare()
{
  make_bare "$1"
  unshare --mount bash -c '
    set -e
    root=$1 source=$2 dist=$3
    mkdir -p "$root/source" "$root/dist" "$root/build"
    mount --bind "$source" "$root/source" && mount -o remount,bind,ro "$root/source"
    mount --bind "$dist" "$root/dist"
    mount -t proc proc "$root/proc" && mount --rbind /dev "$root/dev"
    exec env -u DISPLAY -u PIP_FIND_LINKS PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root \
      chroot "$root" bash /source/Testing/Wheel/inside.sh /usr/bin/python3 /room "/dist/$4" /source "$5"' \
    run "$rooms/$1" "$source_dir" "$dist" "$(basename "$wheel")" "$packages"
}

# Two CPythons of this machine: Debian's, and another.
pythons()
{
  echo /usr/bin/python3
  for candidate in python3.12 python3.10 ~/.pyenv/versions/3.12.*/bin/python3 ~/.pyenv/versions/3.10.*/bin/python3; do
    if "$candidate" -c 'import venv' 2>/dev/null; then
      echo "$candidate"
      break
    fi
  done
}

picture_of_the_build
echo "== bare Debian 13"
run_bare trixie
cmp "$rooms/build.png" "$rooms/trixie/room/render.png" || fail "Debian 13 draws another picture than the build"
if [ -n "${VTKTERRAIN_CI_ALL:-}" ]; then
  echo "== bare Debian testing"
  run_bare forky
  /usr/bin/python3 "$source_dir/Testing/Wheel/compare.py" "$rooms/build.png" "$rooms/forky/room/render.png"
fi
for python in $(pythons); do
  version=$("$python" -c 'import platform; print(platform.python_version())')
  echo "== CPython $version on this machine"
  env -u DISPLAY PYTHONPATH= bash "$source_dir/Testing/Wheel/inside.sh" "$python" "$rooms/$version" "$wheel" "$source_dir" "$packages"
  cmp "$rooms/build.png" "$rooms/$version/render.png" || fail "CPython $version draws another picture than the build"
done
