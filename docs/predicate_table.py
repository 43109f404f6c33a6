#!/usr/bin/python3
"""The tables of docs/results/predicate.md, in Markdown: docs/predicate_table.py out/bench-predicate.txt

Reads what `./run bench predicate` prints; types no figure.
"""
import re
import sys

ROW = re.compile(r"^(\S+)/(\S+) +([0-9.]+) +([0-9.]+) +([0-9.]+) +\d+$")
RANDOM = {"hits_7": "7 % hits", "hits_0": "0 %", "hits_50": "50 %", "hits_100": "100 %", "first_level_cache": "7 %, first-level cache",
          "memory": "7 %, in memory", "rays_7": "rays, 7 %"}
HARD = {"degenerate": "exactly degenerate", "near_degenerate": "some ulps off"}
METHODS = {"single": "**`sf-filtered`**, single", "batch": "**`sf-filtered`**, batch, AVX-512", "batch_avx2": "the same, AVX2",
           "batch_portable": "the same, SSE2", "scalar_mt": "Möller–Trumbore, not exact", "simd_mt": "the same, AVX-512",
           "simd_mt_avx2": "the same, AVX2", "simd_mt_portable": "the same, SSE2", "sf_double": "`sf-double`, not exact",
           "epick": "CGAL, EPICK", "epick_checked": "CGAL, EPICK, its preconditions checked", "epeck": "CGAL, EPECK",
           "sf_filtered": "`segura_feito` on the filtered kernel", "sf_epick": "on EPICK", "sf_expansion": "on expansions",
           "sf_epeck": "on EPECK", "sf_rational": "on GMP rationals"}


def rows(path):
    with open(path, encoding="utf-8") as lines:
        found = (ROW.match(line.rstrip("\n")) for line in lines)
        return {(m[1], m[2]): tuple(float(m[i]) for i in (3, 4, 5)) for m in found if m}


def cell(row):
    return "–" if row is None else "{:,.3g} ({:,.3g}–{:,.3g})".format(*row) if row[0] < 1000 else "{:,.0f} ({:,.0f}–{:,.0f})".format(*row)


def table(found, populations):
    print("| ns a pair, median (tenth to ninetieth percentile) | " + " | ".join(populations.values()) + " |")
    print("|---|" + "---|" * len(populations))
    for method, words in METHODS.items():
        cells = [found.get((population, method)) for population in populations]
        if any(cells):
            print(f"| {words} | " + " | ".join(map(cell, cells)) + " |")
    print()


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    measured = rows(sys.argv[1])
    table(measured, RANDOM)
    table(measured, HARD)
