#!/bin/sh
# clang-tidy over the sources of the module, its tests and examples, and the ParaView plugin, in a configured build,
# on all cores. What passed is not looked at again until it, a header that it reaches or the checks change.
#   sh Testing/check-lint.sh BUILD_DIR [GLOB...]
# GLOB chooses: 'Testing/Cxx/*.cxx'. The plugin is looked at where it has been built (Testing/ParaView/run.sh;
# VTKTERRAIN_PARAVIEW_BUILD_DIR names the folder). What no build here compiles is named, and left out.
set -eu
build_dir=$(cd "$1" && pwd)
shift
cd "$(dirname "$0")/.."
passed=$build_dir/lint-passed
plugin=${VTKTERRAIN_PARAVIEW_BUILD_DIR:-build-paraview}
mkdir -p "$passed"
# Files of a unity build, which take a quarter of the time, without the headers that GCC has precompiled, which clang
# cannot read; the headers made from shaders are those of the build.
separate=$passed/separate
cmake -G Ninja -S . -B "$separate" -DCMAKE_UNITY_BUILD=ON -DVTKTERRAIN_BUILD_TESTING=ON \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DVTKTERRAIN_BUILD_EXAMPLES=ON -DVTKTERRAIN_BUILD_BENCHMARKS=ON \
  >"$passed/configured.log"
sed "s|$separate/module/|$build_dir/module/|g; s|$build_dir/module/\([^ \"]*\)/Unity/|$separate/module/\1/Unity/|g" \
  "$separate/compile_commands.json" >"$passed/compile_commands.json"
ln -sf "$build_dir"/module/src/*.cxx "$separate/module/src/"
# The checks of a file are those of the nearest folder above it.
mkdir -p "$separate/Testing"
cp .clang-tidy "$separate/"
cp Testing/.clang-tidy "$separate/Testing/"

checks=$(cat .clang-tidy Testing/.clang-tidy Testing/check-lint.sh | cksum | tr -d ' ')
[ $# -gt 0 ] || set -- 'src/*.cxx' 'Examples/*.cxx' 'Testing/*.cxx' 'Module/ParaView/*.cxx'
# shellcheck disable=SC2046 # file names here have no spaces
python3 Testing/list-lint-units.py "$passed" "$plugin" -- $(git ls-files "$@") >"$passed/units"
while read -r commands unit content; do
  stamp=$passed/$content-$checks
  [ -e "$stamp" ] || printf '%s\n%s\n%s\n' "$commands" "$unit" "$stamp"
done <"$passed/units" | xargs -r -n 3 -P "$(nproc)" sh -c '
  if clang-tidy-16 --quiet -p "$0" --checks=-bugprone-suspicious-include \
    --header-filter="^$PWD/(src|Testing|Examples|Module)/" "$1" 2>"$2.log"; then
    mv "$2.log" "$2"
  else
    cat "$2.log" >&2
    exit 1
  fi'
