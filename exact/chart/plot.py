#!/usr/bin/env python3
"""Draws what `tribunal chart` measured: python3 plot.py chart.json OUTDIR

speed-accuracy  share of wrong answers against time per test, a panel for each population of cases
onset           share of wrong answers against the mantissa fill of exactly degenerate cases
speed           time per test by the share of hits, a line of marks for each method and way to call it

A method that was never wrong is not drawn at zero, which a log axis does not have and a sample cannot show, but at the
upper 95 % confidence bound on its share: hollow, with an arrow that points down.
"""
import json
import math
import os
import sys

try:
    import matplotlib
except ImportError:
    sys.exit("plot.py: no module matplotlib (Debian: python3-matplotlib)")

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.lines import Line2D
from matplotlib.ticker import FuncFormatter, NullFormatter

# Okabe and Ito's colours, which stay apart for colour-blind eyes; one for each family of methods.
COLOURS = {"sf": "#0072B2", "mt": "#D55E00", "cgal": "#009E73", "woop": "#CC79A7", "badouel": "#E69F00",
           "pluecker": "#56B4E9", "jimenez": "#7A5195", "baldwin": "#8C6D1F", "haines": "#A6761D", "feito": "#666666"}
INK, FAINT = "#222222", "#8A8A8A"

plt.rcParams.update({
    "svg.hashsalt": "tribunal", "svg.fonttype": "path", "font.family": "DejaVu Sans", "font.size": 9.5,
    "axes.edgecolor": FAINT, "axes.labelcolor": INK, "text.color": INK, "xtick.color": INK, "ytick.color": INK,
    "axes.spines.top": False, "axes.spines.right": False, "axes.axisbelow": True, "axes.grid": True,
    "grid.color": "#E6E6E6", "grid.linewidth": 0.6, "axes.titlelocation": "left", "axes.titlesize": 11,
    "axes.titleweight": "bold"})


def colour_of(method):
    return COLOURS.get(method.split("-")[0], INK)


def marker_of(method):
    endings = {"float": "^", "double": "o", "eps": "D"}
    return endings.get(method.split("-")[-1], "s")


def nanoseconds(x):
    return f"{x:g} ns" if x < 1000 else f"{x / 1000:g} µs"


def percent_axis(ax, floor):
    """Ticks at powers of ten, down to where something is drawn."""
    ax.set_yticks([10.0 ** e for e in range(math.floor(math.log10(floor)), 1)])
    ax.set_yticks([], minor=True)
    ax.yaxis.set_major_formatter(FuncFormatter(lambda y, _: f"{100 * y:g} %"))


def draw_point(ax, x, answers, method, size=6.5):
    """Filled with its confidence interval, or hollow at the bound with an arrow down."""
    colour, bound = colour_of(method), answers["bound"]
    if bound:
        ax.annotate("", (x, answers["drawn"]), (0, -17), textcoords="offset points",
                    arrowprops={"arrowstyle": "<|-", "color": colour, "lw": 1.1, "shrinkA": 0, "shrinkB": 4})
    else:
        ax.plot([x, x], [answers["lower"], answers["upper"]], color=colour, lw=1.6)
    ax.plot([x], [answers["drawn"]], marker_of(method), ms=size, mec=colour, mew=1.5, mfc="white" if bound else colour,
            zorder=3)


def spread(places, gap):
    """Places pushed apart, keeping their order, until neighbours are `gap` from each other."""
    order = sorted(range(len(places)), key=lambda i: places[i])
    apart = list(places)
    for _ in range(300):
        for a, b in zip(order, order[1:]):
            short = gap - (apart[b] - apart[a])
            if short > 1e-9:
                apart[a] -= short / 2
                apart[b] += short / 2
    return apart


def label(ax, text, point, place, method, tie=(0, 0.5), **alignment):
    """A name at a place given in fractions of the axes, tied to its point by a thin line."""
    ax.annotate(text, point, place, textcoords="axes fraction", fontsize=8.5, color=colour_of(method), **alignment,
                arrowprops={"arrowstyle": "-", "color": colour_of(method), "lw": 0.5, "shrinkA": 1, "shrinkB": 6,
                            "relpos": tie})


def label_points(ax, rows):
    """Names of the wrong in a column to their right, names of the never wrong in a row below."""
    to_axes = ax.transData + ax.transAxes.inverted()
    where = [to_axes.transform((r["nanoseconds"]["median"], r["answers"]["drawn"])) for r in rows]
    for bound in (False, True):
        own = [i for i, r in enumerate(rows) if r["answers"]["bound"] == bound]
        places = spread([where[i][0 if bound else 1] for i in own], 0.046 if bound else 0.04)
        inset = max(0, 0.025 - min(places, default=1)) if bound else 0
        ends = [to_axes.transform((rows[i]["nanoseconds"]["upper_quartile"], 1))[0] for i in own]
        column = max(ends, default=0) + 0.06
        for i, place in zip(own, places):
            r = rows[i]
            point = (r["nanoseconds"]["median"], r["answers"]["drawn"])
            if bound:
                label(ax, r["method"], point, (place + inset, 0.24), r["method"], (0.5, 1), rotation=90,
                      ha="center", va="top")
            else:
                label(ax, r["method"], point, (column, place), r["method"], ha="left", va="center")


def caption(panels, rows):
    """Cases and hits of a panel, and what some methods were not judged on."""
    hits = ", ".join(f"{100 * p['hits'] / p['cases']:.1f} % hits in {p['fmt']}" for p in panels)
    cases = f"{max(p['cases'] for p in panels):,} cases" + (" each" if len(panels) > 1 else "")
    unjudged = {}
    for r in rows:
        if r["answers"]["unsupported"]:
            share = f"{100 * r['answers']['unsupported'] / r['answers']['asked']:.0f} %"
            unjudged.setdefault(share, []).append(r["method"])
    notes = [f"{', '.join(methods)}: {share} outside the contract, judged on the rest" for share, methods in unjudged.items()]
    return "\n".join([hits + "; " + cases] + notes)


def speed_accuracy(chart):
    keys = list(dict.fromkeys(p["population"] for p in chart["panels"]))
    rows = [r for r in chart["rows"] if r["drawn"] and r["answers"]["judged"]]
    figure, axes = plt.subplots(1, len(keys), figsize=(4.2 * len(keys), 6.4), sharex=True, sharey=True)
    figure.subplots_adjust(left=0.078, right=0.985, top=0.73, bottom=0.165, wspace=0.07)
    floor = min(r["answers"]["drawn"] for r in rows)
    times = [r["nanoseconds"] for r in rows]
    for ax, key in zip(axes, keys):
        ax.set(xscale="log", yscale="log", xlim=(min(t["lower_quartile"] for t in times) / 2,
                                                 max(t["upper_quartile"] for t in times) * 2.5),
               ylim=(floor / 600, 1.3), xlabel="time per test (median; bar: quartiles)")
        ax.xaxis.set_major_formatter(FuncFormatter(lambda x, _: nanoseconds(x)))
        ax.xaxis.set_minor_formatter(NullFormatter())
        percent_axis(ax, floor)
        own = [r for r in rows if r["population"] == key]
        for r in own:
            t = r["nanoseconds"]
            ax.plot([t["lower_quartile"], t["upper_quartile"]], [r["answers"]["drawn"]] * 2,
                    color=colour_of(r["method"]), lw=1.6)
            draw_point(ax, t["median"], r["answers"], r["method"])
        panels = [p for p in chart["panels"] if p["population"] == key and p["cases"]]
        ax.set_title(panels[0]["title"], pad=54)
        ax.text(0, 1.15, panels[0]["about"] + "\n" + caption(panels, own), transform=ax.transAxes, fontsize=8,
                color="#555555", va="top", linespacing=1.4)
    figure.canvas.draw()
    for ax, key in zip(axes, keys):
        label_points(ax, [r for r in rows if r["population"] == key])
    axes[0].set_ylabel("share of wrong answers")
    figure.suptitle("What being right costs: wrong answers against time per test", x=0.078, y=0.975, ha="left",
                    fontsize=14, fontweight="bold")
    figure.text(0.078, 0.912, "General position: binary32 cases for every method. Elsewhere binary32 methods have "
                "binary32 cases, all others binary64 cases.", fontsize=9, color="#555555", va="bottom")
    legend(figure)
    return figure


def legend(figure):
    def key(marker, filled, text):
        return Line2D([], [], ls="", marker=marker, ms=6.5, mec=INK, mew=1.4, mfc=INK if filled else "white",
                      label=text)

    handles = [key("^", True, "binary32"), key("o", True, "binary64"), key("D", True, "binary64 with a tolerance"),
               key("s", True, "exact arithmetic"),
               Line2D([], [], color=INK, lw=1.6, label="95 % confidence interval"),
               key("s", False, "hollow with ▼: 0 wrong, drawn at the 95 % upper bound")]
    figure.legend(handles=handles, loc="lower left", bbox_to_anchor=(0.055, 0.005), ncol=len(handles), frameon=False,
                  fontsize=8.5, handletextpad=0.4, columnspacing=1.3)


def grouped(rows):
    """Curves that coincide share a line: {curve: methods}."""
    curves = {}
    for method in dict.fromkeys(r["method"] for r in rows):
        own = sorted((r for r in rows if r["method"] == method), key=lambda r: r["bits"])
        curve = tuple((r["bits"], r["answers"]["drawn"], r["answers"]["bound"]) for r in own)
        curves.setdefault(curve, []).append(method)
    return curves


def label_lines(ax, curves):
    """Names at the right end of each line, pushed apart, tied to it by a thin line."""
    ends = [(curve[-1], methods) for curve, methods in curves.items()]
    to_axes = ax.transData + ax.transAxes.inverted()
    heights = [to_axes.transform((bits, share))[1] for (bits, share, _), _ in ends]
    gap = 0.042 * (1 + max((len(m) for m in curves.values()), default=0) // 4)
    for ((bits, share, _), methods), height in zip(ends, spread(heights, gap)):
        lines = [", ".join(methods[i:i + 3]) for i in range(0, len(methods), 3)]
        label(ax, ",\n".join(lines), (bits, share), (1.03, height), methods[0], va="center")


def onset(chart):
    rows = [r for r in chart["onset"] if r["drawn"] and r["answers"]["judged"]]
    formats = [f for f in ("binary32", "binary64") if any(r["fmt"] == f for r in rows)]
    figure, axes = plt.subplots(1, len(formats), figsize=(12.5, 5.6), sharey=True, squeeze=False,
                                gridspec_kw={"width_ratios": [1, 1.7][-len(formats):], "wspace": 0.28})
    figure.subplots_adjust(left=0.075, right=0.83, top=0.79, bottom=0.2)
    floor = min(r["answers"]["drawn"] for r in rows)
    for ax, fmt in zip(axes[0], formats):
        own = [r for r in rows if r["fmt"] == fmt]
        ax.set(yscale="log", ylim=(floor / 3, 1), xlabel="bits of the map's entries")
        bits = sorted({r["bits"] for r in own})
        apart = bits[-1] / (16 if bits[-1] > 30 else 11)
        ticks = [bits[0]]
        for b in bits:
            if b - ticks[-1] >= apart:
                ticks.append(b)
        ax.set_xticks(ticks)
        percent_axis(ax, floor)
        curves = grouped(own)
        for curve, methods in curves.items():
            for (b0, s0, zero0), (b1, s1, zero1) in zip(curve, curve[1:]):
                ax.plot([b0, b1], [s0, s1], color=colour_of(methods[0]), lw=1.4, ls=":" if zero0 or zero1 else "-")
            for r in (r for r in own if r["method"] == methods[0]):
                draw_point(ax, r["bits"], r["answers"], methods[0], 5.5)
        ax.set_title(f"{fmt} methods on {fmt} cases" if len(formats) > 1 else f"{fmt} cases", pad=24)
        ax.text(0, 1.02, f"{min(r['answers']['asked'] for r in own):,} cases a level", transform=ax.transAxes,
                fontsize=8.5, color="#555555", va="bottom")
    figure.canvas.draw()
    for ax, fmt in zip(axes[0], formats):
        label_lines(ax, grouped([r for r in rows if r["fmt"] == fmt]))
    axes[0][0].set_ylabel("share of wrong answers")
    figure.suptitle("Where floating point begins to fail: exactly degenerate cases, by mantissa fill", x=0.075, y=0.965,
                    ha="left", fontsize=14, fontweight="bold")
    legend(figure)
    return figure


HIT_MARKS = {0: ("o", "#56B4E9"), 7: ("s", "#0072B2"), 50: ("^", "#E69F00"), 100: ("D", "#D55E00")}


def speed(chart):
    """The quickest at 7 % hits on top; tests that do nothing below all."""
    rows = [r for r in chart["speed"] if r["call"] != "set-up"]
    set_up = {r["method"]: r["nanoseconds"]["median"] for r in chart["speed"] if r["call"] == "set-up"}
    lines = {}
    for r in rows:
        lines.setdefault((r["method"], r["call"]), {})[r["percent_hits"]] = r["nanoseconds"]
    order = sorted(lines, key=lambda k: (not k[0].startswith("("), -lines[k][7]["median"]))
    height = 2.3 + 0.235 * len(order)
    figure, ax = plt.subplots(figsize=(11, height))
    figure.subplots_adjust(left=0.26, right=0.84, top=1 - 1.15 / height, bottom=0.95 / height)
    for y, key in enumerate(order):
        spans = lines[key]
        ax.plot([min(t["median"] for t in spans.values()), max(t["median"] for t in spans.values())], [y, y],
                color="#C8C8C8", lw=1.2, zorder=1)
        for percent, t in spans.items():
            marker, colour = HIT_MARKS[percent]
            ax.plot([t["lower_quartile"], t["upper_quartile"]], [y, y], color=colour, lw=2.2, zorder=2)
            ax.plot([t["median"]], [y], marker, ms=5, color=colour, zorder=3)
        if key[1] == "prepared":
            ax.text(1.015, y, f"{set_up[key[0]]:.0f} ns a triangle", transform=ax.get_yaxis_transform(), fontsize=8,
                    va="center", color="#555555")
    if set_up:
        ax.text(1.015, 1.0, "set-up", transform=ax.transAxes, fontsize=8.5, fontweight="bold", va="bottom")
    ax.set(xscale="log", ylim=(-0.7, len(order) - 0.3), xlabel="time per test (median; bar: quartiles)")
    ax.set_yticks(range(len(order)), [m if call == "single" else f"{m}, {call}" for m, call in order], fontsize=8.5)
    ax.xaxis.set_major_formatter(FuncFormatter(lambda x, _: nanoseconds(x)))
    ax.xaxis.set_minor_formatter(NullFormatter())
    handles = [Line2D([], [], ls="", marker=m, color=c, ms=5.5, label=f"{p} % hit") for p, (m, c) in HIT_MARKS.items()]
    figure.legend(handles=handles, loc="lower left", bbox_to_anchor=(0.25, 0.002), ncol=4, frameon=False, fontsize=8.5)
    figure.suptitle("What a test costs, by the share of hits", x=0.02, y=1 - 0.2 / height, ha="left", fontsize=14,
                    fontweight="bold")
    figure.text(0.02, 1 - 0.72 / height, "Random segments and triangles of the unit cube, 4,000 pairs in cache, each "
                "test in a loop that was compiled around it.", fontsize=9, color="#555555")
    return figure


def save(figure, name):
    figure.savefig(name + ".svg", metadata={"Date": None, "Creator": None})
    figure.savefig(name + ".png", dpi=160, metadata={"Software": None})
    plt.close(figure)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__.splitlines()[0])
    with open(sys.argv[1], encoding="utf-8") as file:
        chart = json.load(file)
    save(speed_accuracy(chart), os.path.join(sys.argv[2], "speed-accuracy"))
    save(onset(chart), os.path.join(sys.argv[2], "onset"))
    save(speed(chart), os.path.join(sys.argv[2], "speed"))


if __name__ == "__main__":
    main()
