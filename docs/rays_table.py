#!/usr/bin/python3
"""The tables of speed of docs/results/tracer.md, in Markdown: docs/rays_table.py out/bench-tracer.txt

Reads what `./run bench tracer` prints; types no figure.
"""
import sys

from compare_benches import ratios
from predicate_table import rows

RAYS = {"coherent_16k": "coherent, 16 k", "random_16k": "random, 16 k", "coherent_1m": "coherent, 1 M", "random_1m": "random, 1 M"}
CASTERS = ("ours", "ours_batch", "embree", "aabb")
QUOTIENTS = ("embree", "embree_batch", "aabb_single", "aabb")


def ratio(found):
    return "–" if found is None else "{:.2f} [{:.2f}, {:.2f}]".format(*found)


def main(path):
    times, quotients = rows(path), ratios(path)
    print("| ns a ray | ours, single | ours, batch | Embree robust | CGAL AABB | single over Embree | batch over Embree | single over CGAL | batch over CGAL |")
    print("|---|---|---|---|---|---|---|---|---|")
    for name, words in RAYS.items():
        cells = [f"{times[(name, caster)][0]:,.0f}" for caster in CASTERS] + [ratio(quotients.get(f"{q}_{name}")) for q in QUOTIENTS]
        print(f"| {words} | " + " | ".join(cells) + " |")
    for kind in ("coherent", "random"):
        cells = [ratio(quotients.get(f"slowdown_{kind}_{caster}")) for caster in CASTERS]
        print(f"| slow-down {kind} | " + " | ".join(cells) + " | | | | |")
    print()
    print("| CPU ns a pixel | ours | POV-Ray 3.7 | ours is faster by |")
    print("|---|---|---|---|")
    for (scene, who), time in times.items():
        if who == "povray":
            print(f"| {scene} | {times[(scene, 'ours')][0]:,.0f} | {time[0]:,.0f} | {ratio(quotients.get('povray_frame_' + scene))} |")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
