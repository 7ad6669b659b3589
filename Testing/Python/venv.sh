#!/bin/sh
# Makes the environment in which the Python tests find PyVista, xarray, GeoPandas, trame and a driver of
# Chromium: build/python-env, beside Debian's VTK. ctest uses it when it is there.
#   sh Testing/Python/venv.sh [BUILD_DIR]
# Versions are pinned in requirements.txt; PyVista comes without what it needs, which is VTK from pip.
set -eu
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
build_dir=${1:-${VTKTERRAIN_BUILD_DIR:-$source_dir/build}}
env=$build_dir/python-env
list=$source_dir/Testing/Python/requirements.txt

sh "$source_dir/Module/packages.sh" chromium python3-gdal python3-venv
wanted=$(cksum "$list")
[ "$wanted" != "$(cat "$env/made-of" 2>/dev/null)" ] || exit 0
/usr/bin/python3 -m venv --clear --system-site-packages "$env"
"$env/bin/pip" install -q -r "$list"
"$env/bin/pip" install -q --no-deps "$(sed -n 's/^# no-deps: //p' "$list")"
printf '%s\n' "$wanted" >"$env/made-of"
