#!/bin/sh
# Measures which lines of src/ the unit, pipeline and image suites run, with GCC's counters and gcovr.
#   sh Testing/Coverage/run.sh
# Builds in build/coverage. Prints the files under 80 % and the total, writes build/coverage.json, and fails under 92 %.
set -eu
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
build_root=${VTKTERRAIN_BUILD_DIR:-$source_dir/build}
build_dir=$build_root/coverage
here=$source_dir/Testing/Coverage
sh "$source_dir/Module/packages.sh"
command -v gcovr >/dev/null || apt-get install --yes --no-install-recommends gcovr >/dev/null

cmake -G Ninja -S "$source_dir" -B "$build_dir" -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON \
  -DVTKTERRAIN_BUILD_EXAMPLES=OFF "-DVTKTERRAIN_DATA_DIR=${VTKTERRAIN_DATA_DIR:-}" \
  "-DCMAKE_CXX_COMPILER_LAUNCHER=${VTKTERRAIN_COVERAGE_LAUNCHER:-}" \
  "-DCMAKE_CXX_FLAGS=--coverage -fprofile-update=atomic" -DCMAKE_CXX_FLAGS_RELEASE="-O1" >"$build_dir.log"
cmake --build "$build_dir"
find "$build_dir" -name '*.gcda' -delete
# OSMesa runs the lines that EGL does
(cd "$build_dir" && ctest --no-tests=error --parallel "$(nproc)" -L 'unit|pipeline|image' -E -osmesa --timeout 900 \
  --output-on-failure)
gcovr --root "$source_dir" --filter "$source_dir/src/" --object-directory "$build_dir" --json "$build_root/coverage.json" \
  "$build_dir"
python3 "$here/report.py" "$build_root/coverage.json"
