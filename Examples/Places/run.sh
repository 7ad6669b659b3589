#!/bin/sh
# Draws an island whose heights are in degrees, with an orthophoto in UTM, a walk as GPX and huts as GeoJSON,
# from a place, in the sunlight of a time; prints the path of the picture. More options of terrain-render may
# follow. The data are made up, by make-data.py.
set -eu
island=$(cd "$(dirname "$0")" && pwd)

exec sh "$island/../run.sh" "$island/heights.tif" --output island.png \
  --drape "$island/photo.tif" --track "$island/route.gpx" --track "$island/huts.geojson" \
  --look-from -18.13,64.94,5200 --look-at -18.009,64.996,300 --view-angle 32 --sun 2024-06-21T09:00Z \
  --graticule degrees --scale-bar --north-arrow "$@"
