#!/bin/sh
# Runs the unit and pipeline suites under AddressSanitizer with UndefinedBehaviorSanitizer, and under
# ThreadSanitizer. Fails on the first finding. What draws is left out: drivers of OpenGL make code while they run.
#   sh Testing/Sanitizers/run.sh [address|thread]     default: both
# Builds in build/sanitize-address and build/sanitize-thread. suppressions-*.txt beside this file name other
# people's libraries, each with a reason.
set -eu
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
build_root=${VTKTERRAIN_BUILD_DIR:-$source_dir/build}
here=$source_dir/Testing/Sanitizers
sh "$source_dir/Module/packages.sh"

run()
{
  kind=$1
  flags=$2
  build_dir=$build_root/sanitize-$kind
  cmake -G Ninja -S "$source_dir" -B "$build_dir" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_UNITY_BUILD=ON \
    -DVTKTERRAIN_BUILD_EXAMPLES=OFF "-DVTKTERRAIN_DATA_DIR=${VTKTERRAIN_DATA_DIR:-}" \
    "-DCMAKE_CXX_COMPILER_LAUNCHER=${VTKTERRAIN_SANITIZER_LAUNCHER:-}" \
    "-DCMAKE_CXX_FLAGS=$flags -fno-omit-frame-pointer" -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1" >"$build_dir.log"
  # one program a test, both of one name
  # shellcheck disable=SC2046 # names of programs have no spaces
  cmake --build "$build_dir" --target vtkTerrainUnitTests \
    $(cd "$build_dir" && ctest -N -L pipeline | sed -n 's/^ *Test *#[0-9]*: //p')
  (cd "$build_dir" && ctest --no-tests=error --parallel "$(nproc)" -L 'unit|pipeline' --timeout 900 --output-on-failure)
}
for kind in ${1:-address thread}; do
  case $kind in
    address)
      export ASAN_OPTIONS="detect_stack_use_after_return=1:strict_init_order=1:allocator_may_return_null=1"
      export LSAN_OPTIONS="suppressions=$here/suppressions-leaks.txt:print_suppressions=0"
      export UBSAN_OPTIONS="print_stacktrace=1"
      run address "-fsanitize=address,undefined -fno-sanitize-recover=all"
      ;;
    thread)
      export VTK_SMP_BACKEND_IN_USE=STDThread # whose threads ThreadSanitizer follows
      export TSAN_OPTIONS="suppressions=$here/suppressions-threads.txt:halt_on_error=1:second_deadlock_stack=1"
      run thread "-fsanitize=thread"
      ;;
    *)
      echo "No such sanitizer: $kind (address, thread)" >&2
      exit 2
      ;;
  esac
done
