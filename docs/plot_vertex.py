#!/usr/bin/env python3
"""Draws docs/images/vertex.png: python3 docs/plot_vertex.py PROGRAM OUT.png

`sweep --axis afar` writes a torus, `leak` finds rays through its vertices that a method loses, and a picture is rendered
from the source of one of them with the vertex in the middle. Its whole height is 24 units in the last place of 1.
"""
import json
import os
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

METHODS, EXACT = ("mt-double", "sos-double", "edges-double"), "sf-filtered"
HUNTED = "edges-double"  # watertight along edges; it leaks at vertices alone
HEIGHT = 24 * 2.0 ** -52


def run(program, *words, may_find=False):
    done = subprocess.run([program, *words], capture_output=True, text=True)
    if done.returncode != 0 and not (may_find and done.returncode == 1):
        sys.exit(f"{' '.join(words)}: exit code {done.returncode}\n{done.stderr}")
    return done.stdout


def number(x):
    return float.fromhex(x) if isinstance(x, str) else float(x)


def vertices_of(file):
    words = open(file, encoding="utf-8").read().split()
    count = int(words[1])
    return [tuple(map(float, words[4 + 3 * i:7 + 3 * i])) for i in range(count)]


def witnesses(folder, mesh):
    """The vertices and sources of rays at a vertex, from outside the mesh's box, that are lost."""
    vertices = vertices_of(mesh)
    reach = max(abs(x) for v in vertices for x in v)
    with open(os.path.join(folder, "leaks", "cases.jsonl"), encoding="utf-8") as lines:
        for case in map(json.loads, lines):
            kind, at = case["finding"]["origin"]["aimed_at"].split()
            source = [number(x) for x in case["ray"]["o"]]
            if case["finding"]["outcome"] == "leak" and kind == "vertex" and max(map(abs, source)) > reach:
                yield vertices[int(at)], source


def scene_of(mesh, vertex, source):
    return {"camera": {"eye": source, "look_at": vertex, "up": [0, 1, 0], "view_height": HEIGHT, "width": 160, "height": 120},
            "background": [0.75, 0.83, 0.92], "lights": [{"position": [3 * x for x in source]}],
            "solids": [{"mesh": mesh, "colour": [0.72, 0.66, 0.56], "ambient": 0.35}]}


def differing(said):
    line = next(line for line in said.splitlines() if "pixels differ in colour" in line)
    return int(line.split(": ")[1].split()[0])


def panel(program, folder, scene, method):
    """The picture, the method's name, and how many pixels are wrong."""
    out = os.path.join(folder, method + ".png")
    said = run(program, "render", scene, "--method", method, "--against", EXACT, "--max-cases", "0", "-o", out)
    return plt.imread(out), method, differing(said)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__.splitlines()[0])
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        run(program, "sweep", "--axis", "afar", "--method", EXACT, "--count", "1", "--out", folder)
        mesh = os.path.join(folder, "afar.off")
        run(program, "leak", mesh, "--method", HUNTED, "--format", "binary64", "--keep", "40", "--out",
            os.path.join(folder, "leaks"), may_find=True)
        scene = os.path.join(folder, "scene.json")
        for vertex, source in witnesses(folder, mesh):  # the first whose vertex is not hidden behind the mesh
            with open(scene, "w", encoding="utf-8") as file:
                json.dump(scene_of(mesh, vertex, source), file)
            panels = [panel(program, folder, scene, method) for method in METHODS]
            if all(wrong for _, _, wrong in panels):
                break
        else:
            sys.exit("no leak at a vertex in sight")
        out = os.path.join(folder, "exact.png")
        run(program, "render", scene, "--method", EXACT, "-o", out)
        panels.append((plt.imread(out), "exact", 0))
    figure, axes = plt.subplots(1, 4, figsize=(12.8, 3.2))
    figure.subplots_adjust(left=0.002, right=0.998, top=0.76, bottom=0.01, wspace=0.012)
    for ax, (picture, title, wrong) in zip(axes, panels):
        ax.imshow(picture, interpolation="nearest")
        ax.axis("off")
        ax.text(0, 1.155, title, transform=ax.transAxes, fontsize=17, fontweight="bold", va="bottom")
        note = f"{wrong:,} pixels wrong" if wrong else "none wrong"
        ax.text(0, 1.02, note, transform=ax.transAxes, fontsize=16, va="bottom", color="#333333")
    figure.savefig(sys.argv[2], dpi=100, metadata={"Software": None})
    print("; ".join(f"{title}: {wrong}" for _, title, wrong in panels))


if __name__ == "__main__":
    main()
