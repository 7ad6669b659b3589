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
# Every file by itself, and without the headers that GCC has precompiled, which clang cannot read;
# the headers made from shaders are those of the build.
cmake -G Ninja -S . -B "$passed/separate" -DCMAKE_UNITY_BUILD=OFF -DVTKTERRAIN_BUILD_TESTING=ON \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DVTKTERRAIN_BUILD_EXAMPLES=ON -DVTKTERRAIN_BUILD_BENCHMARKS=ON \
  >"$passed/configured.log"
sed "s|$passed/separate/module/|$build_dir/module/|g" "$passed/separate/compile_commands.json" \
  >"$passed/compile_commands.json"

checks=$(cat .clang-tidy Testing/.clang-tidy | cksum | tr -d ' ')
[ $# -gt 0 ] || set -- 'src/*.cxx' 'Examples/*.cxx' 'Testing/*.cxx' 'Module/ParaView/*.cxx'
# shellcheck disable=SC2046 # file names here have no spaces
python3 Testing/checksum-with-headers.py $(git ls-files "$@") | while read -r content file; do
  commands=$passed
  case $file in
    Module/ParaView/*) commands=$plugin ;;
  esac
  if ! grep -qsF "/$file\"" "$commands/compile_commands.json"; then
    echo "not compiled here, not linted: $file" >&2
    continue
  fi
  stamp=$passed/$content-$checks-$(echo "$file" | tr / _)
  [ -e "$stamp" ] || printf '%s\n%s\n%s\n' "$commands" "$file" "$stamp"
done | xargs -r -n 3 -P "$(nproc)" sh -c '
  if clang-tidy-16 --quiet -p "$0" "$1" 2>"$2.log"; then
    mv "$2.log" "$2"
  else
    cat "$2.log" >&2
    exit 1
  fi'
