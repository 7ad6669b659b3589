#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTerrain authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the data beside it: an island that there is not, at 65 degrees north.

heights.tif  heights in degrees (EPSG:4326), 241 x 201 samples, metres above the sea
photo.tif    an orthophoto of most of it in UTM 27 N, 10 m a pixel, with alpha
route.gpx    a walk from the shore to the crater, which the photo shows as a light path
huts.geojson three huts on the way
zones.geojson a reserve round the crater, whose middle is none, and meadows of two parts

belts.cpt, the colours of its heights with names, is written by hand. Needs Python alone, and GDAL's
programs gdal_translate and gdalwarp.
"""
import json
import math
import pathlib
import random
import subprocess
import tempfile

HERE = pathlib.Path(__file__).parent
WEST, NORTH = -18.10, 65.045
COLUMNS, ROWS = 241, 201
EAST_STEP, SOUTH_STEP = 0.00080, 0.00045  # about 38 x 50 m
TOP = (-18.004, 65.000)
METRES = (111320.0 * math.cos(math.radians(65.0)), 111400.0)

random.seed(7)
WAVES = [
    (random.uniform(0, 2 * math.pi), random.uniform(0, 2 * math.pi), 0.0011 * 1.55 ** k, 62.0 / 1.75**k)
    for k in range(7)
    for _ in range(4)
]


def position(longitude, latitude):
    """East and north of the top, in metres."""
    return (longitude - TOP[0]) * METRES[0], (latitude - TOP[1]) * METRES[1]


def height(longitude, latitude):
    x, y = position(longitude, latitude)
    rough = sum(
        amplitude * math.sin(frequency * (x * math.cos(a) + y * math.sin(a)) + phase)
        for a, phase, frequency, amplitude in WAVES
    )
    distance = math.hypot(x / 1.15, y)
    cone = 1250.0 * math.exp(-((distance / 1700.0) ** 1.3)) - 130.0
    crater = -330.0 * math.exp(-((distance / 260.0) ** 4))
    return max(0.0, cone + crater + rough * (0.25 + 0.75 * min(1.0, distance / 1500.0)))


def walk():
    """Longitude and latitude of the points of the route: up from the west in bends."""
    points = []
    for k in range(161):
        t = k / 160.0
        distance = 3000.0 * (1.0 - t) + 330.0 * t
        angle = math.radians(195.0 + 80.0 * t + 9.0 * math.sin(34.0 * t))
        points.append(
            (
                TOP[0] + distance * math.cos(angle) / METRES[0],
                TOP[1] + distance * math.sin(angle) / METRES[1],
            )
        )
    return points


def mix(low, high, t):
    t = min(1.0, max(0.0, t))
    return tuple(a + t * (b - a) for a, b in zip(low, high))


def color(longitude, latitude, path):
    here = height(longitude, latitude)
    if here <= 0.0:
        return 28, 74, 112
    x, y = position(longitude, latitude)
    if min((x - px) ** 2 + (y - py) ** 2 for px, py in path) < 14.0**2:
        return 238, 226, 190
    shade = 0.9 + 0.1 * math.sin(0.013 * x + 3.0 * math.sin(0.009 * y))
    ground = mix((196, 184, 140), (84, 122, 62), here / 60.0)
    ground = mix(ground, (128, 118, 84), (here - 260.0) / 260.0)
    ground = mix(ground, (96, 84, 78), (here - 520.0) / 200.0)
    ground = mix(ground, (240, 244, 248), (here - 800.0) / 60.0)
    return tuple(int(min(255, shade * channel)) for channel in ground)


def run(*command):
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)


def write_heights(folder):
    grid = folder / "heights.xyz"
    with grid.open("w") as out:
        for row in range(ROWS):
            for column in range(COLUMNS):
                place = WEST + column * EAST_STEP, NORTH - row * SOUTH_STEP
                out.write(f"{place[0]:.6f} {place[1]:.6f} {height(*place):.0f}\n")
    run("gdal_translate", "-q", "-a_srs", "EPSG:4326", "-ot", "Int16", "-co", "COMPRESS=DEFLATE",
        "-co", "PREDICTOR=2", grid, HERE / "heights.tif")


def write_photo(folder, route):
    path = []
    for (a, b), (c, d) in zip(route, route[1:]):
        path += [position(a + t / 4.0 * (c - a), b + t / 4.0 * (d - b)) for t in range(4)]
    columns, rows = 700, 700
    west, north, east, south = -18.07, 65.030, -17.94, 64.970
    picture = folder / "photo.ppm"
    with picture.open("wb") as out:
        out.write(f"P6 {columns} {rows} 255\n".encode())
        for row in range(rows):
            latitude = north + (row + 0.5) / rows * (south - north)
            for column in range(columns):
                longitude = west + (column + 0.5) / columns * (east - west)
                out.write(bytes(color(longitude, latitude, path)))
    placed = folder / "photo.tif"
    run("gdal_translate", "-q", "-a_srs", "EPSG:4326", "-a_ullr", west, north, east, south, picture, placed)
    run("gdalwarp", "-q", "-overwrite", "-t_srs", "EPSG:32627", "-tr", 10, 10, "-r", "average", "-dstalpha",
        "-co", "COMPRESS=DEFLATE", "-co", "PREDICTOR=2", "-co", "ZLEVEL=9", placed, HERE / "photo.tif")


def write_route(route):
    points = "\n".join(
        f'      <trkpt lat="{latitude:.6f}" lon="{longitude:.6f}"><ele>{height(longitude, latitude):.0f}</ele></trkpt>'
        for longitude, latitude in route
    )
    (HERE / "route.gpx").write_text(
        '<?xml version="1.0" encoding="UTF-8"?>\n'
        '<gpx version="1.1" creator="make-data.py" xmlns="http://www.topografix.com/GPX/1/1">\n'
        f"  <trk>\n    <name>Up the crater</name>\n    <trkseg>\n{points}\n    </trkseg>\n  </trk>\n</gpx>\n"
    )
    huts = [
        {
            "type": "Feature",
            "properties": {"name": name},
            "geometry": {"type": "Point", "coordinates": [round(c, 6) for c in route[index]]},
        }
        for name, index in (("Shore", 2), ("Halfway", 80), ("Rim", 156))
    ]
    (HERE / "huts.geojson").write_text(
        json.dumps({"type": "FeatureCollection", "features": huts}, indent=1) + "\n"
    )


def circle(distance, wave=0.0, east=0.0, north=0.0):
    """Longitudes and latitudes round a place in metres from the top, closed."""
    points = []
    for k in range(73):
        angle = 2.0 * math.pi * (k % 72) / 72.0
        reach = distance * (1.0 + wave * math.sin(5.0 * angle))
        points.append([round(TOP[0] + (east + reach * math.cos(angle)) / METRES[0], 6),
                       round(TOP[1] + (north + reach * math.sin(angle)) / METRES[1], 6)])
    return points


def write_zones():
    zones = [("Reserve", "Polygon", [circle(1500.0, 0.12), circle(420.0)]),
             ("Meadows", "MultiPolygon",
              [[circle(520.0, 0.1, -1900.0, -1500.0)], [circle(600.0, 0.1, 2100.0, -900.0)]])]
    features = [{"type": "Feature", "properties": {"zone": name}, "geometry": {"type": kind, "coordinates": rings}}
                for name, kind, rings in zones]
    (HERE / "zones.geojson").write_text(json.dumps({"type": "FeatureCollection", "features": features}) + "\n")


def main():
    route = walk()
    with tempfile.TemporaryDirectory() as folder:
        write_heights(pathlib.Path(folder))
        write_photo(pathlib.Path(folder), route)
    write_route(route)
    write_zones()


main()
