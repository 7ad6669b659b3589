#!/bin/sh
# From a clone to the result of the whole test suite: installs what is missing, builds, runs ctest, and lists
# what was skipped and why.
#   sh Testing/run.sh [CMAKE_OPTION...]
# Tests that need real elevation files take them from the folder VTKTERRAIN_DATA_DIR and skip if it is
# not set.
set -eu
source_dir=$(cd "$(dirname "$0")/.." && pwd)
build_dir=${VTKTERRAIN_BUILD_DIR:-$source_dir/build}
data_dir=${VTKTERRAIN_DATA_DIR:-}
[ -z "$data_dir" ] || data_dir=$(cd "$data_dir" && pwd)

sh "$source_dir/Module/packages.sh" xvfb # for the tests of terrain-view
# Examples are built by their tests, against the installed module.
sh "$source_dir/Module/build.sh" all -DVTKTERRAIN_BUILD_TESTING=ON -DVTKTERRAIN_BUILD_EXAMPLES=OFF \
  "-DVTKTERRAIN_DATA_DIR=$data_dir" "$@"
status=0
(cd "$build_dir" && ctest --no-tests=error --parallel "$(nproc)" --output-on-failure) || status=$?
sh "$source_dir/Testing/list-skipped.sh" "$build_dir"
exit $status
