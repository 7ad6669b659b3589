#!/usr/bin/env bash
# What the wheel says on a bare machine that lacks something, and that it runs for who may write nothing.
# Runs in the bare room of run.sh, in its folder, where venv has the wheel.
#   bash refusals.sh PYTHON WHEEL SOURCE
set -euo pipefail
python=$1 wheel=$2 source_dir=$3
heights=$source_dir/Examples/Places/heights.tif

fail()
{
  printf '%s\n' "$*" >&2
  exit 1
}

# says STATUS TEXT COMMAND...: it ends with a status, not by a signal, and with a line that has the text
says()
{
  local wanted=$1 text=$2 status=0
  shift 2
  timeout 120 "$@" >said 2>&1 || status=$?
  [ "$status" = "$wanted" ] || fail "$*: status $status: $(tail -3 said)"
  tail -1 said | grep -qE "$text" || fail "$*: does not say '$text': $(tail -3 said)"
}

# Another VTK than the one that it is built for.
for other in 9.5.2 9.7.2; do
  rm -rf other
  "$python" -m venv other
  other/bin/pip install -q --disable-pip-version-check --no-deps "vtk==$other" "$wheel"
  says 1 "ImportError: .*Python imports $other from .*pip install 'vtk>=" other/bin/python -c 'import vtkterrain'
done
rm -rf other

# Neither libEGL nor OSMesa.
mkdir hidden
mv /usr/lib/x86_64-linux-gnu/lib{EGL,OSMesa}.so* hidden/ 2>/dev/null || true
says 1 "libegl1 libgl1-mesa-dri" venv/bin/python -W error -c 'import vtkterrain'
says 1 "vtkterrain: .*libegl1 libgl1-mesa-dri" venv/bin/python -m vtkterrain --no-browser "$heights"
mv hidden/* /usr/lib/x86_64-linux-gnu/

# libEGL without a driver.
mv /usr/lib/x86_64-linux-gnu/libEGL_mesa.so* /usr/lib/x86_64-linux-gnu/dri hidden/
says 1 "libEGL finds no driver" venv/bin/python -W error -c 'from vtkterrain import vtkTerrainActor'
says 1 "vtkterrain: libEGL finds no driver" venv/bin/python -m vtkterrain --no-browser "$heights"
mv hidden/* /usr/lib/x86_64-linux-gnu/
rmdir hidden

# Somebody who may write neither to the packages nor to a home.
mkdir -m 777 nobodys
setpriv --reuid=65534 --regid=65534 --clear-groups env HOME=/nowhere PATH="$PATH" \
  venv/bin/python "$source_dir/Examples/Python/render.py" "$heights" nobodys/render.png
cmp render.png nobodys/render.png || fail "Nobody's picture is another one"
echo "Refusals: said; without the right to write: drawn"
