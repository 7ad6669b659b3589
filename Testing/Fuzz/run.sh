#!/bin/sh
# Fuzzes with libFuzzer under AddressSanitizer and UndefinedBehaviorSanitizer. Fails on the first finding,
# which lies beside the program then.
#   sh Testing/Fuzz/run.sh [SECONDS [TARGET...]]   of each target; default 20, all of them
# The smoke run is the default; the long one: sh Testing/Fuzz/run.sh 3600
set -eu
cd "$(dirname "$0")/../.."
seconds=${1:-20}
[ $# -eq 0 ] || shift
[ $# -gt 0 ] || set -- FuzzPlaces FuzzHierarchy FuzzHeights
sh Module/packages.sh clang-16 libclang-rt-16-dev
folder=${VTKTERRAIN_FUZZ_DIR:-build/fuzz}
mkdir -p "$folder"

flags="-std=c++17 -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined
  -fno-sanitize-recover=undefined -Isrc -ITesting/Unit"
# shellcheck disable=SC2086 # flags are several
for source in $(find src/core -name '*.cxx'); do
  object=$folder/$(echo "$source" | tr / _).o
  if [ ! "$object" -nt "$source" ]; then
    ${VTKTERRAIN_FUZZ_LAUNCHER:-} clang++-16 $flags -w -fsanitize=fuzzer-no-link -c "$source" -o "$object"
  fi
done
for target in "$@"; do
  # shellcheck disable=SC2086
  clang++-16 $flags -fsanitize=fuzzer "Testing/Fuzz/$target.cxx" "$folder"/*.o -lGeographicLib -pthread \
    -o "$folder/$target"
  mkdir -p "$folder/corpus-$target"
  set -- "$folder/corpus-$target"
  [ "$target" != FuzzPlaces ] || set -- "$@" Testing/Fuzz/seeds/places
  echo "$target, $seconds s"
  "$folder/$target" -max_total_time="$seconds" -max_len=4096 -len_control=0 -rss_limit_mb=2048 -timeout=20 -seed=1 \
    -print_final_stats=1 -artifact_prefix="$folder/" "$@" 2>"$folder/$target.log" ||
    { tail -40 "$folder/$target.log" >&2; exit 1; }
  grep -E 'number_of_executed_units|DONE' "$folder/$target.log" | tail -2
done
