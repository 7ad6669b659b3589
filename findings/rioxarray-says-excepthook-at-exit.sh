#!/bin/sh
# Guess:   a script that opens a file by rioxarray, reads it and ends leaves nothing on its standard error.
# Happens: with rasterio 1.5 the last words of the script are "Error in sys.excepthook:" and "Original exception
#          was:", with no exception after them; its exit status is 0, and its work is done. The file is still open
#          in xarray's cache of files then, and is closed while Python ends. array.close() before the end, or
#          rasterio 1.4, and nothing is said.
# Where:   any script of rioxarray.open_rasterio(FILE); who looks for a fault in the own code finds none.
# Seen:    rasterio 1.5.2, rioxarray 0.23.0, xarray 2026.9.0 from PyPI with CPython 3.12.1, 2026-11-30.
set -eu
python=${PYTHON:-python3.12}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$python" -m venv "$folder/venv"
"$folder/venv/bin/pip" -q install rioxarray==0.23.0 xarray==2026.9.0 rasterio==1.4.4
"$folder/venv/bin/python" - "$folder/a.tif" <<'PYTHON'
import sys

import numpy as np
import rasterio

with rasterio.open(sys.argv[1], "w", driver="GTiff", width=4, height=3, count=1, dtype="float32", crs="EPSG:32632",
                   transform=rasterio.Affine(10.0, 0.0, 5e5, 0.0, -10.0, 5e6)) as file:
    file.write(np.arange(12, dtype="float32").reshape(1, 3, 4))
PYTHON

# What is said where a script ends with $1.
said()
{
  "$folder/venv/bin/python" -c "import rioxarray
array = rioxarray.open_rasterio('$folder/a.tif')
assert float(array.sum()) == 66.0
$1" 2>&1 >/dev/null | tr -s '\n' ' '
}

old=$(said "")
"$folder/venv/bin/pip" -q install rasterio==1.5.2
new=$(said "")
closed=$(said "array.close()")
"$folder/venv/bin/python" -V
echo "rasterio 1.4.4 says '$old'"
echo "rasterio 1.5.2 says '$new', after array.close() '$closed'"
if [ -z "$old$closed" ] && [ "$new" = "Error in sys.excepthook: Original exception was: " ]; then
  echo "as described"
else
  echo "CHANGED: the header of this file is out of date"
  exit 1
fi
