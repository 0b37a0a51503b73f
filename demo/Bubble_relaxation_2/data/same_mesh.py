#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether two meshes in Triangle's files are the same in whatever order: same_mesh.py A B reads A.node, A.ele, A.poly.

Points are compared as they are written, with their markers, triangles with their regions, and segments with their
markers. Of holes, which any point in them tells, only the number counts.
"""
import sys


def rows(path, skip):
    with open(path) as file:
        return [line.split() for line in file.read().splitlines()[skip:]]


def mesh(stem):
    points = {row[0]: tuple(row[1:]) for row in rows(stem + ".node", 1)}
    triangles = sorted((sorted(points[v] for v in row[1:4]), row[4:]) for row in rows(stem + ".ele", 1))
    poly = rows(stem + ".poly", 1)
    number = int(poly[0][0])
    segments = sorted((sorted(points[v] for v in row[1:3]), row[3]) for row in poly[1:1 + number])
    return sorted(points.values()), triangles, segments, len(poly) - 2 - number


first, second = mesh(sys.argv[1]), mesh(sys.argv[2])
for name, a, b in zip(("points", "triangles", "segments", "holes"), first, second):
    if a != b:
        sys.exit(name + " differ")
print("the same", len(first[1]), "triangles")
