#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a .vtu with a strict XML parser and prints what is in its arrays."""
import base64
import struct
import sys
import xml.etree.ElementTree

letters = {"Int32": "i", "Int64": "q", "UInt8": "B", "Float64": "d"}

def numbers(array):
    raw = base64.b64decode(array.text, validate=True)
    size = struct.unpack("=Q", raw[:8])[0]
    assert size == len(raw) - 8, array.get("Name")
    letter = letters[array.get("type")]
    return struct.unpack("=%d%s" % (size // struct.calcsize(letter), letter), raw[8:])

piece = xml.etree.ElementTree.parse(sys.argv[1]).getroot().find("UnstructuredGrid/Piece")
arrays = {kind: {a.get("Name"): numbers(a) for a in piece.find(kind)}
          for kind in ("PointData", "CellData", "Points", "Cells")}
points, cells = int(piece.get("NumberOfPoints")), int(piece.get("NumberOfCells"))
assert all(len(a) == points for a in arrays["PointData"].values())
assert all(len(a) == cells for a in arrays["CellData"].values())
assert len(arrays["Points"]["Points"]) == 3 * points
types, offsets = arrays["Cells"]["types"], arrays["Cells"]["offsets"]
assert [b - a for a, b in zip((0,) + offsets, offsets)] == [{5: 3, 3: 2}[t] for t in types]
assert len(arrays["Cells"]["connectivity"]) == offsets[-1]
assert all(0 <= i < points for i in arrays["Cells"]["connectivity"])
for q, dimension, t in zip(arrays["CellData"]["q"], arrays["CellData"]["dimension"], types):
    assert dimension == {5: 2, 3: 1}[t] and (0 < q <= 1) == (dimension == 2)
print("point data:", *sorted(arrays["PointData"]))
print("cell data:", *sorted(arrays["CellData"]))
print("markers of lines:", *sorted(set(m for m, t in zip(arrays["CellData"]["marker"], types) if t == 3)))
print("markers of points:", *sorted(set(arrays["PointData"]["marker"])))
