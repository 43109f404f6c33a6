#!/usr/bin/python3
"""The tables of docs/results.md on the paper's claim, in Markdown: python3 docs/paper_table.py out/bench-paper.txt

Reads what `./run bench paper` prints; types no figure.
"""
import sys

from compare_benches import ratios

SHARES = {"hits_0": "0 % hits", "hits_7": "7 %", "hits_50": "50 %", "hits_100": "100 %", "memory": "7 %, in memory"}
BUILDS = {"x87": "x87, `-O2`", "sse2": "SSE2, `-O2`", "native": "AVX-512, `-O3`"}
CLAIM = {"sf_over_mt": "Segura–Feito over Möller–Trumbore", "sf_over_badouel": "Segura–Feito over Badouel",
         "sf_prepared_over_mt": "plane kept, over Möller–Trumbore",
         "sf_prepared_over_badouel_prepared": "plane kept, over Badouel, plane kept"}
OTHERS = {"jimenez_over_mt": "Jiménez–Segura–Feito", "badouel_prepared_over_mt": "Badouel, prepared", "chirkov2_over_mt": "Chirkov, C2",
          "chirkov3_prepared_over_mt": "Chirkov, C3, prepared", "baldwin_weber_prepared_over_mt": "Baldwin–Weber, prepared"}


def cell(found, build, share, what, pair):
    over, under = pair.split("_over_")
    ratio = found.get(f"{build}/{share}/{over}/{what}_over_{under}")
    return "–" if ratio is None else "{:.2f} [{:.2f}, {:.2f}]".format(*ratio)


def table(found, pairs, what):
    print("| | built for | " + " | ".join(SHARES.values()) + " |")
    print("|---|---|" + "---|" * len(SHARES))
    for pair, words in pairs.items():
        for build, flags in BUILDS.items():
            print(f"| {words} | {flags} | " + " | ".join(cell(found, build, share, what, pair) for share in SHARES) + " |")
    print()


def main(path):
    found = ratios(path)
    for title, pairs, what in (("Do they meet?", CLAIM, "asks"), ("Where do they meet?", CLAIM, "point"),
                               ("Others over Möller–Trumbore, do they meet?", OTHERS, "asks")):
        print(f"**{title}**\n")
        table(found, pairs, what)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
