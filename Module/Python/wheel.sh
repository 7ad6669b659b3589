#!/usr/bin/env bash
# Builds the wheel beside pip's VTK, and the source distribution, from nothing but a Debian 12 machine,
# and checks them; both are left in DIR. Needs root.
#   bash Module/Python/wheel.sh DIR
# The compiler is that of Debian 11 (GCC 10 as VTK's own wheels, glibc 2.31). The headers and the tools
# of VTK that no package of pip's has are those of a later Debian, unpacked. One library serves every
# CPython; each has a wrapping of its own. What is made on the way stays in DIR/work and is used again.
set -euo pipefail
vtk_series=9.6 # the next one: this number, and the release that has it
vtk_release=forky
pythons="3.10 3.11 3.12 3.13 3.14"
# shellcheck disable=SC2034 # read in functions.sh
largest=3000000 # bytes

# shellcheck source=/dev/null
source "$(dirname "$0")/wheel/functions.sh"
source_dir=$(cd "$(dirname "$0")/../.." && pwd)
# shellcheck disable=SC2034 # read in functions.sh
mirror=$(sh "$source_dir/Module/debian-mirror.sh")
mkdir -p "$1/work"
dist=$(cd "$1" && pwd)
work=$dist/work
cd "$work"

need debootstrap python3-venv binutils
get_packages "$vtk_release" libvtk9-dev "libvtk$vtk_series" vtk9 python3-vtk9 libc6
get_packages bookworm libgdal-dev
vtk=$(version_of "$vtk_release" libvtk9-dev)
case $vtk in
  "$vtk_series".*) ;;
  *) fail "$vtk_release has VTK $vtk, not $vtk_series" ;;
esac
vtk=${vtk%%[+-]*}
get_headers $pythons
get_tools
make_root

echo "VTK $vtk, CPython $(cd python && echo [0-9]*)"
unpack gdal packages/bookworm/libgdal-dev_*.deb
/usr/bin/python3 "$source_dir/Module/Python/wheel/vtk_sdk.py" sdk "packages/$vtk_release" "$vtk_series"
get_wheels "vtk==$vtk" 'numpy<2.1' 'cmake<4'
copy_source "$source_dir" source
cp "$source_dir"/Module/Python/wheel/{inside.sh,wrap.py} .
run_in_root bash "$work/inside.sh" "$work" "$vtk_series"

copy_licences licences
version=$(sed -n 's/^project(vtkTerrain VERSION \([0-9.]*\).*/\1/p' source/CMakeLists.txt)
rm -rf raw fixed
PATH=$work/tools/bin:$PATH tools/bin/python "$source_dir/Module/Python/wheel/pack.py" build/vtkterrain wrapped licences raw \
  "$version" "$vtk_series" "$source_dir"
exclude=(--exclude 'libvtkWrappingPythonCore*')
for library in root/venv/lib/python3*/site-packages/vtkmodules/libvtk*.so; do
  exclude+=(--exclude "$(basename "$library")")
done
mkdir -p bundled
cp -P root/usr/lib/x86_64-linux-gnu/libGeographic.so.* bundled/
LD_LIBRARY_PATH=$work/bundled PATH=$work/tools/bin:$PATH tools/bin/auditwheel repair --plat manylinux_2_31_x86_64 "${exclude[@]}" \
  -w fixed raw/*.whl >auditwheel.log 2>&1 || fail "$(cat auditwheel.log)"

rm -f "$dist"/vtkterrain-*
cp fixed/*.whl "$dist/"
tools/bin/python -m build --sdist --outdir "$dist" source >sdist.log 2>&1 || fail "$(tail -20 sdist.log)"
check_wheel "$dist"/vtkterrain-*.whl
ls -l "$dist"/vtkterrain-*
