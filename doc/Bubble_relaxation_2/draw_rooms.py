#!/usr/bin/env python3
"""Draws the rooms of include/CGAL/Bubble_relaxation_2/internal, each with the number of its headers, as SVG.

usage: draw_rooms.py OUTPUT.svg
"""
import os
import sys

INTERNAL = os.path.join(os.path.dirname(__file__), "..", "..", "include", "CGAL", "Bubble_relaxation_2", "internal")

# name, column, row, width in columns: stages above what they are made of
STAGES = [("outline_simplification", 5.4, 0.1, 1.6), ("transfer", 4.66, 0.1, 0.74), ("adaptation", 3.8, 0.1, 0.86),
          ("reading", 0, 1, 1), ("placement", 1, 2, 1), ("simulation", 2, 2, 1),
          ("population", 3, 2, 1), ("treatment", 4, 2, 1), ("quality", 5, 2, 1), ("writing", 6, 1, 1),
          ("dual", 6, 1.9, 1), ("files", 6, 2.6, 1)]
FRAMES = [("engine", 1, 1, 5), ("relaxation", 1.06, 1.48, 2.88)]
SHELVES = [("corners", 0, 3.28, 1), ("sizes", 1, 3.28, 1), ("fields", 2, 3.28, 1), ("domain", 3, 3.28, 1), ("geometry", 4, 3.28, 2),
           ("core", 6, 3.28, 1)]
RANKS = [("distributed/input", 0, 5.1, 1), ("distributed/placement", 1, 5.1, 1), ("distributed/simulation", 2, 5.1, 1.5),
         ("distributed/treatment", 3.5, 5.1, 1.5), ("distributed/engine", 5, 5.1, 1), ("distributed/writing", 6, 5.1, 1),
         ("distributed/mesh", 0, 5.9, 2), ("distributed/parts", 2, 5.9, 2.5), ("distributed/mpi", 4.5, 5.9, 2.5)]
MESHLESS = [("meshless/search", 0, 7.2, 2), ("meshless/mls", 2, 7.2, 2), ("meshless/galerkin", 4, 7.2, 3)]
WIDTH, HEIGHT = 136, 62


def number_of_headers(room):
    return sum(name.endswith(".h") for name in os.listdir(os.path.join(INTERNAL, room)))


def text(x, y, words, size, anchor="middle", style=""):
    return '<text x="%g" y="%g" font-size="%g" text-anchor="%s" %s>%s</text>' % (x, y, size, anchor, style, words)


def box(room, column, row, width, color):
    x, y = 20 + column * WIDTH, row * HEIGHT
    w, h = width * WIDTH - 12, HEIGHT - 18
    n = number_of_headers(room)
    return ['<rect x="%g" y="%g" width="%g" height="%g" rx="5" fill="%s" stroke="#555"/>' % (x, y, w, h, color),
            text(x + w / 2, y + 19, room.split("/")[-1], 15, style='font-weight="bold"'),
            text(x + w / 2, y + 35, "%d header%s" % (n, "s" if n > 1 else ""), 11, style='fill="#444"')]


def frame(room, column, row, width, bottom):
    x, y = 20 + column * WIDTH - 6, row * HEIGHT - 6
    return ['<rect x="%g" y="%g" width="%g" height="%g" rx="7" fill="none" stroke="#777" stroke-dasharray="5 3"/>'
            % (x, y, width * WIDTH, bottom * HEIGHT - 12 - y), text(x + 10, y + 19, room, 15, "start", 'font-weight="bold"')]


def band(row, words):
    return [text(20, row * HEIGHT - 10, words, 13, "start", 'fill="#333"')]


def arrow(column, row, to_column, to_row):
    """from the right side of a box to the left side of another one"""
    x, y = 20 + (column + 1) * WIDTH - 12, (row + 0.35) * HEIGHT
    to_x, to_y = 20 + to_column * WIDTH, (to_row + 0.35) * HEIGHT
    return ['<line x1="%g" y1="%g" x2="%g" y2="%g" stroke="#333" stroke-width="1.6" marker-end="url(#tip)"/>'
            % (x, y, to_x - 1, to_y)]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip().splitlines()[-1])
    parts = ['<svg xmlns="http://www.w3.org/2000/svg" width="990" height="510" font-family="sans-serif">',
             '<rect width="990" height="510" fill="white"/>',
             '<defs><marker id="tip" markerWidth="8" markerHeight="8" refX="7" refY="3" orient="auto">'
             '<path d="M0,0 L7,3 L0,6 z" fill="#333"/></marker></defs>']
    parts += band(0.75, "CGAL::npbs_relax() and the other entry points: each stage has a door or a few")
    for name, column, row, width in FRAMES:
        parts += frame(name, column, row, width, 3.08 if name == "engine" else 2.98)
    for room in STAGES:
        parts += box(*room, "#cfe3f7")
    parts += arrow(0, 1, 1, 2) + arrow(1, 2, 2, 2) + arrow(2, 2, 3, 2) + arrow(3, 2, 4, 2) + arrow(4, 2, 5, 2)
    parts += arrow(5, 2, 6, 1)
    for room in SHELVES:
        parts += box(*room, "#e9edd8")
    parts += band(4.42, "what stages are made of: right before left")
    parts += band(5.08, "on several ranks: the same stages, with a team that tells the others")
    for room in RANKS:
        parts += box(*room, "#f7e3cf")
    parts += band(7.15, "meshless: from nodes to moving least squares and the element-free Galerkin method")
    for room in MESHLESS:
        parts += box(*room, "#eadcf2")
    parts.append("</svg>")
    with open(sys.argv[1], "w") as file:
        file.write("\n".join(parts) + "\n")


if __name__ == "__main__":
    main()
