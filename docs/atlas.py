#!/usr/bin/env python3
"""Writes docs/atlas.md and its drawings, docs/atlas/*.svg, from what the program knows of its classes:

    python3 docs/atlas.py build/release/tribunal docs

Needs nothing but Python's standard library.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

COLUMNS, CELL, LABEL = 6, (120, 90), 16

STYLE = """
svg{background:#fff;font:9px sans-serif}
.t{fill:#dfe7f1;stroke:#4a5f7a;stroke-width:1.2;stroke-linejoin:round}
.p{stroke:#111;stroke-width:1.4;fill:none}
.h{stroke:#fff;stroke-width:1.8;stroke-dasharray:2.5 2.5}
.m{stroke:#c2410c;stroke-width:4;stroke-linecap:round;stroke-opacity:.75}
.d{fill:#111}.n{fill:#111;paint-order:stroke;stroke:#fff;stroke-width:2.5px}
.id{font-weight:bold;font-size:10px}
@media (prefers-color-scheme:dark){svg{background:#15181d}.t{fill:#273347;stroke:#9fb4d0}.p{stroke:#eee}
.h{stroke:#15181d}.d{fill:#eee}.n{fill:#eee;stroke:#15181d}.m{stroke:#fb923c}}
"""

GROUPS = [
    ("crossing", "In space: four of the five points span it",
     lambda c: c["rank"] == 4),
    ("in-plane-miss", "In one plane, a triangle with area: misses",
     lambda c: c["rank"] == 3 and c["triangle"] == "tri" and not c["hit"]),
    ("in-plane-hit", "In one plane, a triangle with area: hits",
     lambda c: c["rank"] == 3 and c["triangle"] == "tri" and c["hit"]),
    ("flat", "In one plane, a triangle without area",
     lambda c: c["rank"] == 3 and c["triangle"] != "tri"),
    ("line", "On one line, or at one place; the probe is drawn beside the triangle",
     lambda c: c["rank"] <= 2),
]


def line(cls, ends):
    (x1, y1), (x2, y2) = ends
    return f'<line class="{cls}" x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}"/>'


def arrow(ends):
    """A head at the second end."""
    (x1, y1), (x2, y2) = ends
    length = ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5
    if length == 0:
        return ""
    ux, uy = (x2 - x1) / length, (y2 - y1) / length
    left = (x2 - 7 * ux - 3 * uy, y2 - 7 * uy + 3 * ux)
    right = (x2 - 7 * ux + 3 * uy, y2 - 7 * uy - 3 * ux)
    return f'<path class="d" d="M{x2} {y2}L{left[0]:.1f} {left[1]:.1f}L{right[0]:.1f} {right[1]:.1f}z"/>'


def distance(x, y, ends):
    """Of a point from a line between two ends."""
    (x1, y1), (x2, y2) = ends
    dx, dy = x2 - x1, y2 - y1
    square = dx * dx + dy * dy
    t = min(1, max(0, ((x - x1) * dx + (y - y1) * dy) / square)) if square else 0
    return ((x1 + t * dx - x) ** 2 + (y1 + t * dy - y) ** 2) ** 0.5


def name_place(dot, sketch):
    """Beside the dot, where most room is left by lines and other dots; above and below where the probe is drawn beside."""
    if sketch["apart"]:
        return dot["x"], dot["y"] + (-5 if dot["of"][0] in "abc" else 11)
    a, b, c = sketch["tri"]
    lines = [(a, b), (b, c), (c, a), sketch["probe"]]
    lines += [((d["x"], d["y"]),) * 2 for d in sketch["dots"] if d is not dot]

    def room(direction):
        x, y = dot["x"] + direction[0] * 9, dot["y"] + direction[1] * 9
        return min(distance(x, y, ends) for ends in lines)

    dx, dy = max([(0, -1), (1, 0), (-1, 0), (0, 1), (0.7, -0.7), (-0.7, -0.7), (0.7, 0.7), (-0.7, 0.7)], key=room)
    return dot["x"] + 9 * dx, dot["y"] + 9 * dy + 3


def drawing(c):
    s = c["sketch"]
    parts = ['<polygon class="t" points="' + " ".join(f"{x},{y}" for x, y in s["tri"]) + '"/>']
    meet = s["meet"]
    if meet and len(meet) == 2:
        parts.append(line("m", meet))
    parts.append(line("p", s["probe"]))
    if s["hidden"]:
        parts.append(line("h", s["hidden"]))
    if s["arrow"]:
        parts.append(arrow(s["probe"]))
    if meet and len(meet) == 1:
        parts.append(f'<circle class="m" fill="none" cx="{meet[0][0]}" cy="{meet[0][1]}" r="5" style="stroke-width:2"/>')
    for dot in s["dots"]:
        x, y = name_place(dot, s)
        parts.append(f'<circle class="d" cx="{dot["x"]}" cy="{dot["y"]}" r="2"/>')
        parts.append(f'<text class="n" x="{x:.1f}" y="{y:.1f}" text-anchor="middle">{dot["of"]}</text>')
    parts.append(f'<text class="n id" x="3" y="{CELL[1] + 9}">{c["id"]} {"hit" if c["hit"] else "miss"}</text>')
    return "".join(parts)


def sheet(classes):
    rows = -(-len(classes) // COLUMNS)
    width, height = COLUMNS * CELL[0], rows * (CELL[1] + LABEL)
    parts = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}">',
             f"<style>{STYLE}</style>"]
    for i, c in enumerate(classes):
        x, y = i % COLUMNS * CELL[0], i // COLUMNS * (CELL[1] + LABEL)
        parts.append(f'<g transform="translate({x} {y})"><title>{c["id"]}: {c["words"]}</title>{drawing(c)}</g>')
    return "\n".join(parts) + "\n</svg>\n"


def signs(c):
    return " ".join({-1: "−", 0: "0", 1: "+"}[s] for s in c["signs"])


def row(c):
    return f'| {c["id"]} | {signs(c)} | {c["contact"]} | {c["words"]} |'


def page(classes):
    text = ["# Atlas of the classes", "",
            "Up to the order of the vertices, reflection and, of a segment, its direction, there are 163 ways in which a segment and a",
            "triangle can lie to each other, and 165 of a ray and a triangle, any of them possibly degenerate. The answer of an intersection",
            "test is a function of the class. Each drawing shows one representative with small integers as coordinates: the triangle a b c;",
            "the segment p q or the ray from o along d; in orange what they have in common; dashed what is hidden behind the triangle.",
            "Signs are those of the volumes abcp, abcq, pqab, pqbc and pqca ([conventions.md](conventions.md); of a ray q stands for d).",
            "They decide where the first two are not both 0; else the test goes on in the triangle's plane, with signs of areas.",
            "`data/classes163.tsv` and `data/ray_classes.tsv` have the representatives.", "",
            "`python3 docs/atlas.py build/release/tribunal docs` makes this page and its drawings."]
    for kind, title in (("C", "A segment and a triangle"), ("R", "A ray and a triangle")):
        text += ["", f"## {title}"]
        for name, group, chosen in GROUPS:
            some = [c for c in classes if c["id"][0] == kind and chosen(c)]
            if not some:
                continue
            file = f'atlas/{"segment" if kind == "C" else "ray"}-{name}.svg'
            text += ["", f"### {group}", "", f"![Drawings of {some[0]['id']} to {some[-1]['id']}]({file})", "",
                     "<details><summary>In words</summary>", "", "| class | signs | contact | in words |", "|---|---|---|---|"]
            text += [row(c) for c in some] + ["", "</details>"]
    return "\n".join(text) + "\n"


def main():
    program, out = sys.argv[1], Path(sys.argv[2])
    with tempfile.NamedTemporaryFile(suffix=".json") as file:
        subprocess.run([program, "report", "--classes", file.name], check=True)
        classes = json.load(open(file.name, encoding="utf-8"))
    (out / "atlas").mkdir(parents=True, exist_ok=True)
    for kind, word in (("C", "segment"), ("R", "ray")):
        for name, _, chosen in GROUPS:
            some = [c for c in classes if c["id"][0] == kind and chosen(c)]
            (out / "atlas" / f"{word}-{name}.svg").write_text(sheet(some), encoding="utf-8")
    (out / "atlas.md").write_text(page(classes), encoding="utf-8")


if __name__ == "__main__":
    main()
