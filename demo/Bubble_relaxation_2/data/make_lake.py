#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes lake.poly, a shore with four islands: circles with a few waves on them. Prints it."""
from math import cos, sin, pi

def shore(cx, cy, radius, n, waves, flat=1.0):
    points = []
    for i in range(n):
        t = 2 * pi * i / n
        r = radius * (1 + sum(a * cos(k * t + p) for k, a, p in waves))
        points.append((cx + r * cos(t), cy + flat * r * sin(t)))
    return points

outlines = [
    shore(0.0, 0.0, 1.0, 180, [(2, 0.18, 0.4), (3, 0.12, 1.9), (5, 0.07, 0.3), (9, 0.035, 2.2), (17, 0.02, 1.0)], 0.72),
    shore(0.25, 0.08, 0.17, 48, [(2, 0.22, 1.0), (3, 0.12, 0.2), (7, 0.05, 2.0)]),
    shore(-0.38, -0.12, 0.11, 36, [(2, 0.18, 2.4), (5, 0.07, 0.9)]),
    shore(-0.05, -0.33, 0.06, 24, [(3, 0.15, 0.0)]),
    shore(-0.02, 0.36, 0.05, 20, [(2, 0.25, 0.7)]),
]
print("# a lake with four islands, made by make_lake.py")
print(sum(map(len, outlines)), 2, 0, 0)
number = 1
segments = []
for outline in outlines:
    first = number
    for x, y in outline:
        print(number, f"{x:.6f}", f"{y:.6f}")
        segments.append((number, number + 1 if number + 1 < first + len(outline) else first))
        number += 1
print(len(segments), 0)
for k, (a, b) in enumerate(segments, 1):
    print(k, a, b)
print(4)
for k, (x, y) in enumerate([(0.25, 0.08), (-0.38, -0.12), (-0.05, -0.33), (-0.02, 0.36)], 1):
    print(k, x, y)
