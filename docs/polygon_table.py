#!/usr/bin/python3
"""The tables of docs/results/polygons.md, in Markdown: docs/polygon_table.py out/bench-polygon.txt

Reads what `./run bench polygon` prints; types no figure.
"""
import sys

from compare_benches import ratios
from predicate_table import rows

CORNERS = (3, 4, 6, 8, 16, 64, 256)
SHAPES = {"convex": "ns a query, 7 % hits, convex: median (tenth to ninetieth percentile)", "concave": "concave",
          "holed": "with a hole"}
METHODS = {"sf_filtered": "**sf-filtered** (exact)", "uncertified": "the same without its bounds", "haines_tuned": "Haines, tuned",
           "sf_tuned": "covering, tuned", "haines_double": "haines-double", "haines_float": "haines-float",
           "feito_double": "feito-double", "feito_float": "feito-float", "sf_double": "sf-double, prepared",
           "sf_double_on_the_fly": "sf-double, on the fly", "cgal_triangulation": "CGAL, exact", "sf_rational": "sf-rational (exact)"}
POPULATIONS = {"plane_missed": "plane missed", "hits_0": "0 %", "hits_7": "7 %", "hits_50": "50 %", "boundary": "on the boundary"}
RATIOS = {"sf-filtered over best classical": ("filtered_over_best_classical", ("hits_7", "hits_0", "plane_missed", "hits_50")),
          "over the better of haines-double and feito-double": ("filtered_over_textbook_classical", ("hits_7", "plane_missed")),
          "over the same without its bounds": ("filtered_over_uncertified", ("hits_7",)),
          "CGAL over sf-filtered": ("cgal_over_filtered", ("hits_7",)),
          "covering, tuned, over best classical": ("sf_tuned_over_best_classical", ("hits_7", "hits_50", "plane_missed"))}


def rounded(x):
    return f"{x:,.3g}" if x < 1000 else f"{x:,.0f}"


def cell(row, whole):
    if row is None:
        return "–"
    return rounded(row[0]) + (f" ({rounded(row[1])}–{rounded(row[2])})" if whole else "")


def table(head, columns, rows_of):
    print(f"| {head} | " + " | ".join(columns) + " |")
    print("|---|" + "---|" * len(columns))
    for words, cells in rows_of:
        if any(c != "–" for c in cells):
            print(f"| {words} | " + " | ".join(cells) + " |")
    print()


def main(path):
    times, quotients = rows(path), ratios(path)
    for shape, head in SHAPES.items():
        table(head, [str(n) for n in CORNERS],
              [(words, [cell(times.get((f"hits_7/{shape}/n{n}", method)), True) for n in CORNERS]) for method, words in METHODS.items()])
    table("four vertices, convex", list(POPULATIONS.values()),
          [(words, [cell(times.get((f"{population}/convex/n4", method)), False) for population in POPULATIONS]) for method, words in METHODS.items()])
    for words, (name, populations) in RATIOS.items():
        found = [(POPULATIONS[p], [quotients.get(f"{name}_n{n}" + ("" if p == "hits_7" else f"_{p}")) for n in CORNERS]) for p in populations]
        table(words, [str(n) for n in CORNERS],
              [(p, ["–" if r is None else "{:.2f} ({:.2f}–{:.2f})".format(*r) for r in row]) for p, row in found])


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
