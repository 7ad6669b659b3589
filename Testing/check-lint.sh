#!/bin/sh
# clang-tidy over the sources of the module and the examples in a configured build, on all cores. What
# passed is not looked at again until it, a header or the checks change.
#   sh Testing/check-lint.sh BUILD_DIR
set -eu
build_dir=$(cd "$1" && pwd)
cd "$(dirname "$0")/.."
passed=$build_dir/lint-passed
mkdir -p "$passed"
# Every file by itself, and without the headers that GCC has precompiled, which clang cannot read;
# the headers made from shaders are those of the build.
cmake -G Ninja -S . -B "$passed/separate" -DCMAKE_UNITY_BUILD=OFF \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DVTKTERRAIN_BUILD_EXAMPLES=ON >"$passed/configured.log"
sed "s|$passed/separate/module/|$build_dir/module/|g" "$passed/separate/compile_commands.json" \
  >"$passed/compile_commands.json"

common=$(cat .clang-tidy $(git ls-files '*.h') | cksum | tr -d ' ')
for file in $(git ls-files 'src/*.cxx' 'Examples/*.cxx'); do
  grep -qF "/$file\"" "$passed/compile_commands.json" || continue
  stamp=$passed/$(cat "$file" | cksum | tr -d ' ')-$common-$(echo "$file" | tr / _)
  [ -e "$stamp" ] || printf '%s\n%s\n' "$file" "$stamp"
done | xargs -r -n 2 -P "$(nproc)" sh -c \
  'clang-tidy-16 --quiet -p "$0" "$1" 2>/dev/null && : >"$2"' "$passed"
