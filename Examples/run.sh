#!/bin/sh
# From a clone to a picture: installs what is missing, builds the module and terrain-render, draws, and
# prints the path of the picture.
#   sh Examples/run.sh [HEIGHTS [OPTION...]]     the built-in landscape without HEIGHTS
# Options are those of terrain-render. The picture is terrain.png in the current folder unless
# --output names another.
# VTKTERRAIN_RENDER may name a terrain-render that is there already: then nothing is installed or built.
set -eu
if [ -n "${VTKTERRAIN_RENDER:-}" ]; then
  exec "$VTKTERRAIN_RENDER" "$@"
fi
source_dir=$(cd "$(dirname "$0")/.." && pwd)
build_dir=${VTKTERRAIN_BUILD_DIR:-$source_dir/build}

sh "$source_dir/Module/packages.sh"
sh "$source_dir/Module/build.sh" terrain-render -DVTKTERRAIN_BUILD_EXAMPLES=ON
exec "$build_dir/bin/terrain-render" "$@"
