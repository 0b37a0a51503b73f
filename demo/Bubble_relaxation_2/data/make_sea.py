#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes an outline of the sea of coasts: make_sea.py west/east/south/north x y < coast.txt > sea.geojson

Reads lines as GMT writes them, in degrees, and writes the part of the box between them that has the point (x, y): a
polygon with the marker 1, and lines with the marker 2 where it is the box that bounds it, which is the open sea.
"""
import json
import sys

from shapely.geometry import LinearRing, LineString, Point, mapping
from shapely.ops import polygonize, unary_union

west, east, south, north = map(float, sys.argv[1].split("/"))
lines, line = [], []
for row in list(sys.stdin) + [">"]:
    if row.startswith(">"):
        if len(line) > 1:
            lines.append(LineString(line))
        line = []
    else:
        line.append(tuple(map(float, row.split()[:2])))
# a parallel is no straight line on a map, so it gets points
steps = [k / 100 for k in range(100)]
corners = [(west, south), (east, south), (east, north), (west, north)]
frame = [tuple(p[c] if p[c] == q[c] else p[c] + t * (q[c] - p[c]) for c in (0, 1))
         for p, q in zip(corners, corners[1:] + corners[:1]) for t in steps]
edges = unary_union(lines + [LinearRing(frame)])
sea = next(p for p in polygonize(edges) if p.contains(Point(float(sys.argv[2]), float(sys.argv[3]))))
is_open = [side for side in zip(sea.exterior.coords, sea.exterior.coords[1:])
           if any(side[0][c] == side[1][c] == limit for c, limit in ((0, west), (0, east), (1, south), (1, north)))]
features = [(sea, 1)] + [(LineString(side), 2) for side in is_open]
json.dump({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"marker": marker}, "geometry": mapping(shape)} for shape, marker in features]},
    sys.stdout)
