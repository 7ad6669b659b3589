#!/bin/sh
# Guess:   odc-geo's accessor for xarray, odc.geo.xr, works with what odc-geo[xr,warp] installs: the extras
#          are there for it, and none of its functions needs dask until an array of dask's is given.
# Happens: `import odc.geo.xr` ends with "No module named 'dask'" as soon as rasterio, which [warp] and
#          rioxarray bring, is there: then it imports the writer of cloud-optimized GeoTIFFs, which imports
#          dask.delayed at its head. With [xr] alone, without rasterio, the import works.
# Where:   a DataArray of odc-geo's beside rioxarray: the import fails before anything is computed.
# Seen:    odc-geo 0.5.3 from PyPI with Python 3.11, 2026-11-29.
set -eu
python=${PYTHON:-python3}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$python" -m venv "$folder/venv"
"$folder/venv/bin/pip" -q install 'odc-geo[xr,warp]==0.5.3'
"$folder/venv/bin/python" - <<'PYTHON'
import importlib.metadata
import importlib.util
import sys

print("odc-geo", importlib.metadata.version("odc-geo"), "Python", sys.version.split()[0])
required = [line for line in importlib.metadata.requires("odc-geo") if "extra" not in line
            or 'extra == "xr"' in line or 'extra == "warp"' in line]
print("required, with [xr,warp]:", required)
try:
    import odc.geo.xr
    said = "imported"
except ModuleNotFoundError as error:
    said = str(error)
print("import odc.geo.xr:", said)
same = said == "No module named 'dask'" and importlib.util.find_spec("dask") is None
print("as described" if same else "CHANGED: the header of this file is out of date")
sys.exit(0 if same else 1)
PYTHON
