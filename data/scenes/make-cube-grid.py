#!/usr/bin/env python3
"""Writes cube-grid.json: 48 turned cubes whose corners lie exactly under pixel rays.

The camera stands at the origin, looks along -z and is 192/128 high at unit distance, so the ray of a pixel has the
direction (i/256, j/256, -1) with odd i, j. Each corner is t times such a direction, t a multiple of 1/8 below 2048: at
most 22 significant bits, exact in binary32. Corners are two pixels apart, so many edges run under rays as well.
"""
import json
import math

COLUMNS, ROWS, HALF = 8, 6, 128.0
FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


def turned(p, a, b):
    x, y, z = p
    x, z = x * math.cos(a) + z * math.sin(a), z * math.cos(a) - x * math.sin(a)
    y, z = y * math.cos(b) - z * math.sin(b), z * math.cos(b) + y * math.sin(b)
    return x, y, z


def under_pixel_ray(p):
    t = round(-p[2] * 8) / 8
    i, j = (4 * math.floor(256 * c / t / 4) + 1 for c in p[:2])
    return [i * t / 256, j * t / 256, -t]


def cube(column, row):
    centre = ((column - 3.5) * 420.0, (row - 2.5) * 420.0, -1840.0)
    angles = (0.35 + 0.19 * column + 0.05 * row, 0.4 + 0.16 * row)
    corners = [turned((HALF * x, HALF * y, HALF * z), *angles) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    vertices = [under_pixel_ray([c + m for c, m in zip(corner, centre)]) for corner in corners]
    faces = [t for f in FACES for t in ([f[0], f[2], f[1]], [f[0], f[3], f[2]])]
    hue = column / COLUMNS, row / ROWS
    colour = [round(0.35 + 0.55 * hue[0], 3), round(0.75 - 0.35 * hue[1], 3), round(0.85 - 0.5 * hue[0] * hue[1], 3)]
    return {"name": f"cube {column},{row}", "vertices": vertices, "faces": faces, "colour": colour, "ambient": 0.15,
            "diffuse": 0.8, "specular": 0.1}


scene = {
    "description": "Cubes whose corners, and many edges, lie exactly under pixel rays; every coordinate is exact in "
                   "binary32. The sides of a cube share each such ray: an exact method leaves no hole.",
    "camera": {"eye": [0, 0, 0], "look_at": [0, 0, -1], "up": [0, 1, 0], "view_height": 1.5, "width": 256,
               "height": 192},
    "background": [0.07, 0.08, 0.12],
    "depth": 1,
    "lights": [{"position": [-900, 1400, 600], "colour": [1, 0.97, 0.9]}],
    "solids": [cube(c, r) for r in range(ROWS) for c in range(COLUMNS)],
}
head = json.dumps({k: v for k, v in scene.items() if k != "solids"}, indent=1)[:-2]
with open("cube-grid.json", "w") as out:
    out.write(head + ',\n "solids": [\n  ' + ",\n  ".join(json.dumps(s) for s in scene["solids"]) + "\n ]\n}\n")
