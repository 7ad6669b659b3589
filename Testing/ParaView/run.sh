#!/bin/sh
# From a clone to the result of the ParaView plugin's tests: unpacks Debian's ParaView beside the build,
# where none is given, builds the plugin for it, and runs its tests.
#   sh Testing/ParaView/run.sh [PREFIX_OF_PARAVIEW]
# Debian's packages of ParaView and of VTK's headers cannot be installed together: these are unpacked only.
set -eu
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
build_dir=${VTKTERRAIN_PARAVIEW_BUILD_DIR:-$source_dir/build-paraview}
sh "$source_dir/Module/packages.sh" openmpi-bin xvfb

prefix=${1:-$build_dir/paraview/usr}
if [ ! -e "$prefix/bin/pvbatch" ]; then
  mkdir -p "$build_dir/paraview"
  cd "$build_dir/paraview"
  if ! apt-get download paraview paraview-dev python3-paraview >/dev/null; then
    echo "Skipped: no packages of ParaView to be had; give the prefix of an installed one" >&2
    exit 77
  fi
  for package in *.deb; do
    dpkg -x "$package" .
  done
  rm ./*.deb
fi
package_dir=$(dirname "$(find "$prefix/lib" -name paraview-config.cmake | head -1)")

cmake -G Ninja -S "$source_dir" -B "$build_dir" -DCMAKE_BUILD_TYPE=Release \
  -DVTKTERRAIN_BUILD_PARAVIEW_PLUGIN=ON -DVTKTERRAIN_BUILD_EXAMPLES=OFF \
  -DPython3_EXECUTABLE=/usr/bin/python3 "-DParaView_DIR=$package_dir"
cmake --build "$build_dir"
cd "$build_dir"
exec ctest --no-tests=error --output-on-failure
