#!/usr/bin/env python3
"""Draws what `./run bench polygon` measured: python3 plot_polygon.py out/bench-polygon.json OUT.png

Left and middle: time per query against the number of vertices, convex and concave, 7 % hits. Right: four vertices,
convex, from segments that mostly miss the plane to 50 % hits. Medians over the repetitions; bands and error bars from
the lower to the upper quartile.
"""
import sys

try:
    import matplotlib
except ImportError:
    sys.exit("plot_polygon.py: no module matplotlib (Debian: python3-matplotlib)")

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from plot_predicate import quartiles, read

METHODS = [("cgal_triangulation", "CGAL: triangulation, EPICK", "#009E73", "s"),
           ("sf_double", "covering, double", "#CC79A7", "v"),
           ("feito_double", "Feito, double", "#E69F00", "D"),
           ("haines_double", "Haines, double", "#D55E00", "^"),
           ("sf_tuned", "covering, double, tuned", "#888888", "<"),
           ("haines_tuned", "Haines, double, tuned", "#000000", ">"),
           ("sf_filtered", "sf-filtered (exact)", "#0072B2", "o")]
MIXES = [("plane_missed", "plane\nmissed"), ("hits_0", "0 %"), ("hits_7", "7 %"), ("hits_50", "50 %")]


def draw_growth(ax, samples, outline, title):
    for key, label, colour, marker in METHODS:
        prefix = f"hits_7/{outline}/n"
        points = sorted((int(name[len(prefix):].split("/")[0]), quartiles(values)) for name, values in samples.items()
                        if name.startswith(prefix) and name.endswith("/" + key))
        if not points:
            continue
        xs = [x for x, _ in points]
        ax.plot(xs, [q[1] for _, q in points], marker + "-", color=colour, label=label, ms=4, lw=1.3)
        ax.fill_between(xs, [q[0] for _, q in points], [q[2] for _, q in points], color=colour, alpha=0.2, lw=0)
    ax.set_xscale("log", base=2)
    ax.set_yscale("log")
    ax.set_xticks([3, 4, 6, 8, 16, 64, 256], ["3", "4", "6", "8", "16", "64", "256"])
    ax.minorticks_off()
    ax.set_title(title)
    ax.set_xlabel("vertices")
    ax.set_ylabel("ns a query")


def draw_mixes(ax, samples):
    shown = [m for m in METHODS if m[0] != "cgal_triangulation"]
    width = 0.8 / len(shown)
    for i, (key, label, colour, _) in enumerate(shown):
        for x, (mix, _) in enumerate(MIXES):
            values = samples.get(f"{mix}/convex/n4/{key}")
            if not values:
                continue
            low, mid, high = quartiles(values)
            ax.bar(x + (i - (len(shown) - 1) / 2) * width, mid, width, color=colour, ecolor="#777777",
                   yerr=[[mid - low], [high - mid]], error_kw={"lw": 1})
    ax.set_xticks(range(len(MIXES)), [name for _, name in MIXES])
    ax.grid(axis="x", visible=False)
    ax.set_title("Four vertices, convex, by share of hits")
    ax.set_xlabel("hits")
    ax.set_ylabel("ns a query")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    samples = read(sys.argv[1])
    plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
                         "grid.color": "#E6E6E6", "axes.axisbelow": True, "axes.titlelocation": "left"})
    figure, axes = plt.subplots(1, 3, figsize=(13, 4.4))
    draw_growth(axes[0], samples, "convex", "Convex polygons, 7 % hits")
    draw_growth(axes[1], samples, "concave", "Concave polygons, 7 % hits")
    draw_mixes(axes[2], samples)
    handles, labels = axes[0].get_legend_handles_labels()
    figure.tight_layout(rect=(0, 0.1, 1, 1))
    if labels:
        figure.legend(handles, labels, loc="lower center", ncol=4, frameon=False)
    figure.savefig(sys.argv[2], dpi=110)


if __name__ == "__main__":
    main()
