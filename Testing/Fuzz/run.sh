#!/bin/sh
# Fuzzes with libFuzzer under AddressSanitizer and UndefinedBehaviorSanitizer. Fails on the first finding,
# which lies beside the program then.
#   sh Testing/Fuzz/run.sh [SECONDS [TARGET...]]   of each target; default 5, all of them
# The smoke run is the default; the long one: sh Testing/Fuzz/run.sh 3600
set -eu
cd "$(dirname "$0")/../.."
seconds=${1:-5}
[ $# -eq 0 ] || shift
[ $# -gt 0 ] || set -- FuzzColors FuzzDocuments FuzzDrapes FuzzGeoreference FuzzGlobe FuzzHeights FuzzHierarchy \
  FuzzHierarchyFile FuzzMeshes FuzzNumbers FuzzObservers FuzzPlaces FuzzPoints FuzzRays FuzzScene FuzzTiles FuzzVectors
sh Module/packages.sh clang-16 libclang-rt-16-dev
folder=${VTKTERRAIN_FUZZ_DIR:-${VTKTERRAIN_BUILD_DIR:-build}/fuzz}
cmake -G Ninja -S Testing/Fuzz -B "$folder" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER=clang++-16 \
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${VTKTERRAIN_FUZZ_LAUNCHER:-}" >/dev/null
cmake --build "$folder" --target "$@" >/dev/null

for target in "$@"; do
  mkdir -p "$folder/corpus-$target"
  seeds=Testing/Fuzz/seeds/$target
  [ -d "$seeds" ] || seeds=""
  echo "$target, $seconds s"
  # shellcheck disable=SC2086 # there may be no seeds
  "$folder/$target" -max_total_time="$seconds" -max_len=4096 -len_control=0 -rss_limit_mb=2048 -timeout=20 -seed=1 \
    -print_final_stats=1 -artifact_prefix="$folder/" "$folder/corpus-$target" $seeds 2>"$folder/$target.log" ||
    { tail -40 "$folder/$target.log" >&2; exit 1; }
  grep -E 'number_of_executed_units|DONE' "$folder/$target.log" | tail -2
done
