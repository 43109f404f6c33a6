#!/usr/bin/env python3
"""Writes the solids of ../solids and the validation scenes beside itself (but cube-grid.json, elephant.json and
mirror-and-prism.json, which have their own makers or none).

Solids have small integer coordinates, moved by integer matrices where they should stand askew: every polygonal face is
planar exactly. Run in data/scenes.
"""
import json
import math

# --- solids: vertices, and faces as rings of indices, counter-clockwise seen from outside ---------------------------


class Solid:
    def __init__(self, description):
        self.description, self.vertices, self.faces = description, [], []

    def add(self, points):
        first = len(self.vertices)
        self.vertices += [list(p) for p in points]
        return list(range(first, len(self.vertices)))

    def walls(self, low, high):
        n = len(low)
        self.faces += [[[low[i], low[(i + 1) % n], high[(i + 1) % n], high[i]]] for i in range(n)]

    def prism(self, outline, z0, z1, bottom_holes=(), top_holes=()):
        """Outline counter-clockwise seen from above; returns the rings of bottom and top."""
        low, high = (self.add([(x, y, z) for x, y in outline]) for z in (z0, z1))
        self.faces += [[low[::-1], *bottom_holes], [high, *top_holes]]
        self.walls(low, high)
        return self.faces[-2 - len(outline)], self.faces[-1 - len(outline)]

    def tunnel(self, outline, z0, z1, bottom, top):
        """A hole through both faces."""
        low, high = (self.add([(x, y, z) for x, y in outline]) for z in (z0, z1))
        bottom.append(low)
        top.append(high[::-1])
        self.walls(low[::-1], high[::-1])

    def boss(self, outline, z0, z1, face):
        """A prism that stands on the face above (z1 > z0), or a pocket cut into it."""
        low, high = (self.add([(x, y, z) for x, y in outline]) for z in (z0, z1))
        face.append(low[::-1])
        self.faces.append([high])
        self.walls(low, high)

    def spike(self, outline, z0, apex, face):
        low = self.add([(x, y, z0) for x, y in outline])
        top = self.add([apex])[0]
        face.append(low[::-1])
        n = len(low)
        self.faces += [[[low[i], low[(i + 1) % n], top]] for i in range(n)]

    def moved(self, matrix, shift=(0, 0, 0)):
        self.vertices = [[sum(m * c for m, c in zip(row, v)) + s for row, s in zip(matrix, shift)]
                         for v in self.vertices]
        return self

    def write(self, name):
        lines = [' "description": ' + json.dumps(self.description),
                 ' "vertices": [\n  ' + ",\n  ".join(json.dumps(v) for v in self.vertices) + "\n ]",
                 ' "faces": [\n  ' + ",\n  ".join(json.dumps(f) for f in self.faces) + "\n ]"]
        with open(f"../solids/{name}.json", "w") as out:
            out.write("{\n" + ",\n".join(lines) + "\n}\n")


def square(x, y, half):
    return [(x - half, y - half), (x + half, y - half), (x + half, y + half), (x - half, y + half)]


def round_outline(n, radius, x=0, y=0, turn=0.0):
    return [(x + round(radius * math.cos(2 * math.pi * (i + turn) / n)),
             y + round(radius * math.sin(2 * math.pi * (i + turn) / n))) for i in range(n)]


def star(n, outer, inner, x=0, y=0):
    return [(x + round(r * math.cos(math.pi * i / n)), y + round(r * math.sin(math.pi * i / n)))
            for i in range(2 * n) for r in [inner if i % 2 else outer]]


UPRIGHT = [[1, 0, 0], [0, 0, 1], [0, -1, 0]]  # z becomes up (y)


def cross_piece():
    s = Solid("A cross with a triangular boss: 30 vertices, 18 faces, as the smaller solid of the paper's figure 2a. The "
              "top is concave and has a hole where the boss stands.")
    cross = [(-2, -6), (2, -6), (2, -2), (6, -2), (6, 2), (2, 2), (2, 6), (-2, 6), (-2, 2), (-6, 2), (-6, -2), (-2, -2)]
    _, top = s.prism(cross, 0, 4)
    s.boss([(-1, -1), (1, -1), (0, 1)], 4, 9, top)
    return s.moved(UPRIGHT)


def channel_piece():
    s = Solid("A channel with a square pocket and three pyramids: 40 vertices, 28 faces, as the larger solid of the "
              "paper's figure 2a. Concave ends, a bottom with four holes in it.")
    channel = [(-8, 0), (8, 0), (8, 8), (5, 8), (5, 3), (-5, 3), (-5, 8), (-8, 8)]
    bottom, top = s.prism(channel, 0, 6)
    s.boss(square(0, 1.5, 1), 6, 2, top)
    s.spike(square(-6.5, 6, 1), 6, (-6.5, 6, 10), top)
    s.spike(square(6.5, 6, 1), 6, (6.5, 6, 10), top)
    s.spike([(-5, 1), (-3, 1), (-2.5, 2), (-4, 2.75), (-5.5, 2)], 6, (-4, 1.75, 9), top)
    return s.moved(UPRIGHT)


def gear():
    s = Solid("A gear with a star cut through it: concave faces of 24 corners with a concave hole of 10.")
    bottom, top = s.prism(star(12, 64, 48), 0, 20)
    s.tunnel(star(5, 30, 14), 0, 20, bottom, top)
    return s.moved([[1, 0, 0], [0, 0, 1], [0, -1, 0]])


def plate():
    s = Solid("An L-shaped plate with six drilled holes and a slot: concave faces with seven holes each.")
    bottom, top = s.prism([(0, 0), (90, 0), (90, 30), (36, 30), (36, 80), (0, 80)], 0, 12)
    for x, y in [(14, 16), (14, 64), (76, 16), (18, 40)]:
        s.tunnel(round_outline(8, 7, x, y, 0.5), 0, 12, bottom, top)
    s.tunnel([(32, 10), (60, 10), (60, 20), (32, 20)], 0, 12, bottom, top)
    s.tunnel([(26, 62), (32, 62), (29, 74)], 0, 12, bottom, top)
    s.tunnel([(27, 32), (33, 38), (27, 44)], 0, 12, bottom, top)
    return s.moved([[4, 0, 1], [0, 4, 2], [-1, -2, 4]])


def edge_pair():
    s = Solid("Two blocks that share an edge: four faces meet there, so the solid is not manifold. It is closed; each "
              "face is a square.")
    v = s.add([(x, y, z) for z in (0, 8) for x, y in [(0, 0), (6, 0), (6, 6), (0, 6), (12, 6), (12, 12), (6, 12)]])
    for ring in ([0, 1, 2, 3], [2, 4, 5, 6]):
        low, high = [v[i] for i in ring], [v[i + 7] for i in ring]
        s.faces += [[low[::-1]], [high]]
        s.walls(low, high)
    return s.moved(UPRIGHT)


def vertex_pair():
    s = Solid("Two pyramids tip to tip: their fans of faces meet in one vertex, so the solid is not manifold there; "
              "each base has a hole that touches the base's corner.")
    tip = s.add([(0, 0, 0)])[0]
    for z, order in ((-24, 1), (24, -1)):
        base = s.add([(-16, -16, z), (16, -16, z), (16, 16, z), (-16, 16, z)])
        dent = s.add([(4, -10, z), (10, 4, z), (2, 2, z / 2)])
        ring = [base[0], dent[0], dent[1]]  # touches the outer ring at base[0]
        s.faces.append([base[::-order], ring[::order]])
        s.faces += [[[base[i], base[(i + 1) % 4], tip][::order]] for i in range(4)]
        s.faces += [[[ring[i], ring[(i + 1) % 3], dent[2]][::-order]] for i in range(3)]
    return s.moved([[1, 0, 0], [0, 0, 1], [0, -1, 0]])


def comb():
    s = Solid("A comb whose teeth touch: the outline runs through seven of its corners twice, so the faces' rings touch "
              "themselves and the solid has seven edges in which four faces meet.")
    low = [(0, 0), (64, 0)]
    for i in range(7, -1, -1):  # teeth along the back, neighbours touch at their widest
        low += [(8 * i + 8, 16), (8 * i + 8, 24), (8 * i + 4, 48), (8 * i, 24)] if i == 7 else \
               [(8 * i + 8, 24), (8 * i + 4, 48), (8 * i, 24)]
        if i:
            low += [(8 * i + 3, 16), (8 * i - 3, 16)]
    low.append((0, 16))
    s.prism(low, 0, 10)
    return s.moved(UPRIGHT)


SOLIDS = {"cross": cross_piece, "channel": channel_piece, "gear": gear, "plate": plate, "edge-pair": edge_pair,
          "vertex-pair": vertex_pair, "comb": comb}

# --- scenes ----------------------------------------------------------------------------------------------------------


def camera(eye, look_at, fov=40, size=(300, 300), up=(0, 1, 0), **more):
    c = {"eye": eye, "look_at": look_at, "up": up, "fov": fov, "width": size[0], "height": size[1]}
    if "view_height" in more:
        del c["fov"]
    return c | more


def lamp(position, aim, colour=(1, 1, 1), concentration=2, cone=50, **more):
    return {"position": position, "colour": colour, "aim": aim, "concentration": concentration, "cone": cone} | more


def slab(name, y, half, **material):
    return {"name": name, "vertices": [[-half, y, -half], [-half, y, half], [half, y, half], [half, y, -half]],
            "faces": [[0, 1, 2, 3]]} | material


def box(name, lo, hi, inward=False, **material):
    v = [[x, y, z] for z in (lo[2], hi[2]) for y in (lo[1], hi[1]) for x in (lo[0], hi[0])]
    faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    return {"name": name, "vertices": v, "faces": [f[::-1] for f in faces] if inward else faces} | material


GLASS = {"colour": [0.8, 0.93, 0.95], "ambient": 0.04, "diffuse": 0.06, "specular": 0.6, "shininess": 80,
         "reflection": 0.12, "transparency": 0.85, "refractive_index": 1.5}
MIRROR = {"colour": [0.3, 0.32, 0.35], "ambient": 0.1, "diffuse": 0.2, "specular": 0.3, "reflection": 0.6}


def write(name, description, cam, solids, lights, background=(0.1, 0.11, 0.16), depth=4):
    head = {"description": description, "camera": cam, "background": background, "depth": depth}
    text = ",\n".join(f" {json.dumps(k)}: {json.dumps(v)}" for k, v in head.items())
    for key, items in (("lights", lights), ("solids", solids)):
        text += f",\n \"{key}\": [\n  " + ",\n  ".join(json.dumps(i) for i in items) + "\n ]"
    with open(f"{name}.json", "w") as out:
        out.write("{\n" + text + "\n}\n")


def paper_pair(name, depth, description):
    write(name, description, camera([3, 23, 31], [0.5, 1.5, 0], 40),
          [slab("floor", 0, 40, colour=[0.55, 0.56, 0.6], diffuse=0.6, specular=0, reflection=0.3),
           {"name": "cross", "solid": "../solids/cross.json", "translate": [-6.5, 0.125, -2],
            "colour": [0.85, 0.35, 0.25], "specular": 0.4, "reflection": 0.15},
           {"name": "channel", "solid": "../solids/channel.json", "scale": 0.75, "translate": [7, 0.125, 2],
            "colour": [0.3, 0.5, 0.85], "specular": 0.4, "reflection": 0.2}],
          [lamp([-14, 26, 20], [0, 0, 0], [0.95, 0.92, 0.85], 6, 35),
           lamp([20, 22, 10], [4, 2, 0], [0.4, 0.42, 0.5], 2, 60, flaps={"x": [-30, 10]})], depth=depth)


def piece(name, solid, description, eye, look_at, floor, colour, lights=None, fov=36, **place):
    lights = lights or [lamp([eye[0] - 90, eye[1] + 60, eye[2] + 20], look_at, [0.95, 0.92, 0.86], 4, 40),
                        {"position": [eye[0] + 80, eye[1] + 30, eye[2] - 40], "colour": [0.3, 0.32, 0.4]}]
    write(name, description, camera(eye, look_at, fov),
          [slab("floor", floor, 400, colour=[0.5, 0.52, 0.5], diffuse=0.6, specular=0, reflection=0.2),
           {"name": solid, "solid": f"../solids/{solid}.json", "colour": colour, "specular": 0.35} | place], lights)


def paper_scenes():
    same = (" After the paper's figure 2: solids of 30 and 40 vertices with 18 and 28 faces, 300 x 300 pixels. Must be "
            "seen: both solids whole, the boss and the pyramids rising from holed concave faces, one soft-edged pool of "
            "light (concentration and cone) and one cut off along a straight line by its flap.")
    paper_pair("paper-2a", 1, "Figure 2a: depth 1, no reflections." + same)
    paper_pair("paper-2b", 4, "Figure 2b: depth 4, the floor and the solids mirror each other." + same)
    piece("paper-2c", "gear", "Figure 2c: concave faces with a concave hole. Must be seen: the floor through the "
          "star, and light through it on the floor.", [90, 150, 190], [0, 0, 0], -40, [0.75, 0.6, 0.3])
    piece("paper-2d", "plate", "Figure 2d: concave faces with seven holes, askew to all axes. Must be seen: the floor "
          "through every hole.", [300, 560, 400], [175, 160, -110], -260, [0.45, 0.65, 0.7], fov=46)
    piece("paper-2e", "edge-pair", "Figure 2e: a non-manifold edge. Must be seen: two blocks that touch along a line, and "
          "no light through the line.", [2, 24, 30], [6, 3, -6], 0, [0.8, 0.45, 0.4])
    piece("paper-2f", "vertex-pair", "Figure 2f: a non-manifold vertex, and holes that touch the corner of their face. "
          "Must be seen: two pyramids tip to tip, the upper base dented from its corner.", [60, 90, 110], [0, 0, 0], -24,
          [0.5, 0.7, 0.4])
    piece("paper-2g", "comb", "Figure 2g: rings that touch themselves, so edges in which four faces meet. Must be "
          "seen: the teeth of a comb, each touching its neighbours along a line.", [50, 90, 60], [32, 2, -20], 0,
          [0.65, 0.5, 0.75])
    write("paper-2h", "Figure 2h: a triangle mesh, so no covering is needed. Must be seen: a closed elephant without "
          "specks.", camera([1.1, 0.6, 1.4], [0, -0.03, 0], 36),
          [{"name": "elephant", "mesh": "../meshes/elephant.off", "colour": [0.6, 0.6, 0.68], "ambient": 0.15,
            "specular": 0.15},
           slab("floor", -0.52, 4, colour=[0.5, 0.52, 0.48], diffuse=0.6, specular=0, reflection=0.25)],
          [lamp([2, 3, 2], [0, 0, 0], [0.95, 0.92, 0.86], 3, 40)])


def validation_scenes():
    tent = [[1024 + x, 1024 + y, 1024 + z] for x, y, z in
            [(-1, -1, -1), (1, -1, -1), (1, -1, 1), (-1, -1, 1), (0.25, 1, -0.75), (-0.125, 1, 0.75)]]
    write("dark-box", "A closed tent far from the origin, its walls without thickness, bright lights just outside. Every "
          "pixel must be black: there is no ambient light, and any other pixel is light that leaked through a wall, an "
          "edge or a corner. A constant step along the normal leaks along every acute edge.",
          camera([1024.25, 1023.5, 1024.375], [1023, 1024.25, 1023], 100, (240, 240)),
          [{"name": "tent", "vertices": tent, "faces": [[0, 1, 2, 3], [0, 4, 1], [1, 4, 2], [2, 4, 5], [2, 5, 3],
                                                        [3, 5, 4], [3, 4, 0]],
            "colour": [1, 1, 1], "ambient": 0, "diffuse": 1, "specular": 1, "reflection": 0.5}],
          [{"position": [1024 + x, 1024 + y, 1024 + z], "colour": [9, 9, 9]} for x, y, z in
           ([3, 0.5, 0.25], [-3, 0.5, 0.25], [0, 0, 3], [0, 0.25, -3], [0, -1 - 2**-13, 0], [0, 4, 0])], [0, 0, 0], 3)
    write("inside-mesh", "A camera inside a closed mesh, a bright magenta world outside. No ray may escape: magenta "
          "must not be seen, directly, by reflection or through the wall.",
          camera([-0.0625, -0.1875, 0], [0.05, 0, 0.125], 110, (240, 240)),
          [{"name": "elephant", "mesh": "../meshes/elephant.off", "colour": [0.75, 0.72, 0.7], "ambient": 0.2,
            "diffuse": 0.7, "specular": 0, "reflection": 0.4}],
          [{"position": [0, -0.09375, 0.03125], "colour": [1, 0.95, 0.9]}], [1, 0, 1], 3)
    rim = [[64 * math.cos(2 * math.pi * i / 720), 64 * math.sin(2 * math.pi * i / 720), -3 * (i % 2)]
           for i in range(720)]
    write("slivers", "A crinkled cone of 720 slivers, seen along its axis from 64 diameters away over a bright magenta world. "
          "The hub is exactly under a pixel, edges run along rays. Must be seen: a grey disc, its crinkles as moire, without magenta specks.",
          camera([0, 0, 8192], [0, 0, 0], size=(241, 241), view_height=241 / 16384),
          [{"name": "fan", "vertices": [[0, 0, 8]] + [[round(x * 2**17) / 2**17, round(y * 2**17) / 2**17, z]
                                                      for x, y, z in rim],
            "faces": [[0, i + 1, (i + 1) % 720 + 1] for i in range(720)], "colour": [0.5, 0.5, 0.5], "ambient": 0.4,
            "diffuse": 0.6, "specular": 0}],
          [{"position": [0, 40, 100], "colour": [1, 1, 1]}], [1, 0, 1], 1)
    sheets = [{"name": f"sheet {k}", "vertices": [[k, -6, -6], [k, 6, -6], [k, 6, 6], [k, -6, 6]],
               "faces": [[0, 1, 2, 3]], "colour": [1, 0, 1], "ambient": 1} for k in (-2, 0, 6)]
    write("edge-on", "Rays in the plane of faces: the eye is in the plane of the middle sheet and of two faces of a cube "
          "behind it. The middle sheet must not be seen (a face edge-on is invisible), the outer two must, and the "
          "cube's front must be whole.",
          camera([0, 0, 32], [0, 0, 0], size=(255, 255), view_height=255 / 512),
          sheets + [box("cube", [0, 0, -12], [4, 4, -8], colour=[0.3, 0.6, 0.9], ambient=0.3),
                    slab("wall", -7, 20, colour=[0.6, 0.6, 0.55], ambient=0.3)],
          [{"position": [3, 9, 30], "colour": [0.9, 0.9, 0.9]}], [0.05, 0.05, 0.1], 2)
    write("facing-mirrors", "Two mirrors that face each other exactly, a cube between them. Must be seen: a "
          "straight row of cubes, ever darker, as many as the depth allows.",
          camera([-1.5, 1.25, 3.5], [0.5, -0.25, -4], 50, (240, 180)),
          [{"name": "back", "vertices": [[-4, -2, -4], [4, -2, -4], [4, 3, -4], [-4, 3, -4]], "faces": [[0, 1, 2, 3]],
            **MIRROR, "reflection": 0.85},
           {"name": "front", "vertices": [[-4, -2, 4], [4, -2, 4], [4, 3, 4], [-4, 3, 4]], "faces": [[3, 2, 1, 0]],
            **MIRROR, "reflection": 0.85},
           box("cube", [-0.5, -2, -1], [0.5, -1, 0], colour=[0.9, 0.5, 0.2]),
           {"name": "floor", "vertices": [[-4, -2, -4], [-4, -2, 4], [4, -2, 4], [4, -2, -4]], "faces": [[0, 1, 2, 3]],
            "colour": [0.5, 0.6, 0.5], "specular": 0}],
          [{"position": [2, 2.5, 1], "colour": [0.9, 0.9, 0.85]}], [0.2, 0.25, 0.35], 12)
    prism = {"name": "prism", "vertices": [[-4, 0.125, 1], [-1, 0.125, 1], [-2.5, 2.625, 1], [-4, 0.125, -2],
                                           [-1, 0.125, -2], [-2.5, 2.625, -2]],
             "faces": [[0, 1, 2], [3, 5, 4], [0, 3, 4, 1], [1, 4, 5, 2], [2, 5, 3, 0]], **GLASS}
    nested = [box("outer cube", [0.5, 0.125, -1.5], [3.5, 3.125, 1.5], **GLASS),
              box("inner cube", [1.25, 0.875, -0.75], [2.75, 2.375, 0.75], **(GLASS | {
                  "colour": [0.95, 0.8, 0.6], "refractive_index": 0.75, "reflection": 0.05}))]
    stripes = [{"name": f"stripe {i}", "vertices": [[i, 0, -6], [i + 0.5, 0, -6], [i + 0.5, 5, -6], [i, 5, -6]],
                "faces": [[0, 1, 2, 3]], "colour": [0.9, 0.3 + 0.05 * (i + 7), 0.2], "ambient": 0.4} for i in range(-7, 8)]
    write("prism-and-nested", "Refraction: a prism and a cube within a cube, before stripes. Must be seen: the stripes "
          "displaced, bent and mirrored in the prism, total reflection at its slanted faces, and the inner cube (of index "
          "0.75 against the glass around it, an air gap of a kind) within the outer; no specks on any face.",
          camera([1.5, 3, 9], [-0.25, 1.25, 0], 40, (320, 240)),
          [slab("floor", 0, 12, colour=[0.6, 0.62, 0.65], diffuse=0.6, specular=0), prism, *nested, *stripes],
          [lamp([5, 9, 8], [0, 0, 0], [1, 0.97, 0.9], 1, 60)], [0.5, 0.62, 0.8], 7)


for file, make in SOLIDS.items():
    make().write(file)
paper_scenes()
validation_scenes()
