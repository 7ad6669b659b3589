#!/bin/sh
# Configures a Release build where there is none, and builds with all cores; files are compiled several
# at a time, which takes a fraction of the time.
#   sh Module/build.sh TARGET [CMAKE_OPTION...]
# The build folder is build/ in the checkout, or VTKTERRAIN_BUILD_DIR.
set -eu
source_dir=$(cd "$(dirname "$0")/.." && pwd)
build_dir=${VTKTERRAIN_BUILD_DIR:-$source_dir/build}
target=$1
shift

options="-DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON $*"
stamp=$build_dir/configured-with.txt
if [ ! -e "$build_dir/build.ninja" ] || [ "$options" != "$(cat "$stamp" 2>/dev/null)" ]; then
  cmake -G Ninja -S "$source_dir" -B "$build_dir" -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON "$@"
  printf '%s\n' "$options" >"$stamp"
fi
cmake --build "$build_dir" --target "$target"
