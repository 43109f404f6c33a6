#!/usr/bin/env python3
"""Draws what `./run bench predicate` measured: python3 plot_predicate.py out/bench-predicate.json OUT.png

Left: time per random pair with 7 % hits, certified and uncertified. Middle: time per exactly degenerate pair against
the bits that its mantissas fill. Right: time per pair against the share of degenerate pairs among random ones.
Medians over the repetitions; bars and bands from the lower to the upper quartile.
"""
import json
import statistics
import sys

try:
    import matplotlib
except ImportError:
    sys.exit("plot_predicate.py: no module matplotlib (Debian: python3-matplotlib)")

matplotlib.use("Agg")
import matplotlib.pyplot as plt

OURS, PEER, UNCERTIFIED = "#0072B2", "#009E73", "#D55E00"
BARS = [("batch", "sf-filtered, batch", OURS), ("simd_mt", "Möller–Trumbore, SIMD", UNCERTIFIED),
        ("batch_avx2", "sf-filtered, batch, AVX2", OURS), ("simd_mt_avx2", "Möller–Trumbore, SIMD, AVX2", UNCERTIFIED),
        ("single", "sf-filtered", OURS), ("scalar_mt", "Möller–Trumbore", UNCERTIFIED),
        ("sf_double", "Segura–Feito, double", UNCERTIFIED), ("epick", "CGAL EPICK", PEER), ("epeck", "CGAL EPECK", PEER),
        ("sf_expansion", "Segura–Feito, expansions", PEER), ("sf_rational", "GMP integers", PEER)]


def read(path):
    """Nanoseconds a pair of every repetition, by benchmark."""
    with open(path, encoding="utf-8") as file:
        runs = json.load(file)["benchmarks"]
    samples = {}
    for run in runs:
        if run["run_type"] == "iteration":
            samples.setdefault(run["run_name"].split("/repeats:")[0], []).append(1e9 / run["items_per_second"])
    return samples


def quartiles(values):
    low, mid, high = statistics.quantiles(values, n=4, method="inclusive")
    return low, mid, high


def draw_bars(ax, samples):
    rows = [(label, colour, quartiles(samples["hits_7/" + key])) for key, label, colour in BARS
            if "hits_7/" + key in samples]
    for y, (label, colour, (low, mid, high)) in enumerate(reversed(rows)):
        ax.barh(y, mid, color=colour, xerr=[[mid - low], [high - mid]], ecolor="#222222", height=0.7)
        ax.text(high * 1.12, y, f"{mid:.3g}", va="center", fontsize=8)
    ax.set_yticks(range(len(rows)), [row[0] for row in reversed(rows)])
    ax.set_xscale("log")
    ax.set_xlim(right=ax.get_xlim()[1] * 2)
    ax.set_title("Random pairs, 7 % hits")
    ax.set_xlabel("ns a pair")


def draw_lines(ax, samples, prefix, title, xlabel):
    for key, label, colour in (("single", "sf-filtered", OURS), ("epick", "CGAL EPICK", PEER)):
        points = sorted((int(name.split("/")[0][len(prefix):]), quartiles(values)) for name, values in samples.items()
                        if name.startswith(prefix) and name.endswith("/" + key))
        if not points:
            continue
        xs = [x for x, _ in points]
        ax.plot(xs, [q[1] for _, q in points], "o-", color=colour, label=label)
        ax.fill_between(xs, [q[0] for _, q in points], [q[2] for _, q in points], color=colour, alpha=0.2, lw=0)
    ax.set_yscale("log")
    ax.set_title(title)
    ax.set_xlabel(xlabel)
    ax.legend(frameon=False)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    samples = read(sys.argv[1])
    plt.rcParams.update({"font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
                         "grid.color": "#E6E6E6", "axes.axisbelow": True, "axes.titlelocation": "left"})
    figure, axes = plt.subplots(1, 3, figsize=(13, 3.8), width_ratios=[1.4, 1, 1])
    draw_bars(axes[0], samples)
    draw_lines(axes[1], samples, "mantissa_fill_", "Exactly degenerate pairs", "bits of the map's entries")
    draw_lines(axes[2], samples, "share_degenerate_", "Random pairs, some degenerate", "degenerate pairs, %")
    figure.tight_layout()
    figure.savefig(sys.argv[2], dpi=110)


if __name__ == "__main__":
    main()
