#!/usr/bin/env bash
# Runs in the Debian 11 root: builds the library and the package, and wraps it for every CPython.
#   bash inside.sh WORK VTK_SERIES
set -euo pipefail
cd "$1"
series=$2

if [ ! -e /venv/bin/cmake ]; then
  python3 -m venv /venv
  /venv/bin/pip install -q --no-index --no-deps wheels/*.whl
fi
vtkmodules=$(echo /venv/lib/python3*/site-packages/vtkmodules)
python3 sdk/finish.py sdk "$vtkmodules"
export VTK_DIR=$PWD/sdk/usr/lib/x86_64-linux-gnu/cmake/vtk-$series
export LD_LIBRARY_PATH=$vtkmodules
export CXXFLAGS="-D_GLIBCXX_USE_CXX11_ABI=0 -ffile-prefix-map=$PWD/="

# The library is not linked to GDAL: its headers are all that is taken. With -O3 the wheel is larger
# than it may be; what is hot asks for -O3 itself (core_lanes_options in src/Files.cmake).
/venv/bin/cmake -S source -B build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON \
  -DCMAKE_CXX_FLAGS_RELEASE="-O2 -DNDEBUG -ffunction-sections -fdata-sections" \
  -DCMAKE_SHARED_LINKER_FLAGS="-Wl,--gc-sections" \
  -DVTKTERRAIN_BUILD_TESTING=OFF -DVTKTERRAIN_BUILD_EXAMPLES=OFF -DVTKTERRAIN_WRAP_PYTHON=ON \
  -DPython3_EXECUTABLE=/venv/bin/python -DVTKTERRAIN_PYTHON_DESTINATION=. \
  -DCMAKE_INSTALL_LIBDIR=vtkterrain -DCMAKE_PLATFORM_NO_VERSIONED_SONAME=ON \
  -DCMAKE_SKIP_BUILD_RPATH=ON \
  -DGDAL_INCLUDE_DIR="$PWD/gdal/usr/include/gdal" -DGDAL_LIBRARY=/not/linked/libgdal.so
LD_LIBRARY_PATH=$vtkmodules:$PWD/build/vtkterrain ninja -C build

rm -rf wrapped
mkdir -p wrapped
for python in python/*; do
  python3 wrap.py build wrapped "$python"
done
