#!/usr/bin/env python3
"""Draws what `tribunal sweep` recorded: python3 plot.py RECORD OUTDIR

sweep.json   thresholds, and a figure for each axis: the share of wrong answers at each of its values
compilers.json   a cell for each method and build: how many of the answers change
map-*.json   a failure map: one pixel for each pair of moved coordinates, a panel for each method

A share of zero is drawn at the upper 95 % confidence bound, as a hollow triangle that points down and that no line joins:
a log axis has no zero, no sample shows one, and a bound is no rate.
"""
import json
import math
import os
import sys
import traceback

try:
    import matplotlib
except ImportError:
    print("plot.py: no module matplotlib (Debian: python3-matplotlib)", file=sys.stderr)
    sys.exit(69)  # script_lacks_module

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.lines import Line2D
from matplotlib.patches import Patch
from matplotlib.ticker import FuncFormatter, MaxNLocator

# Okabe and Ito's colours, from dark to light; with a marker and a dash each, so that no line needs its colour.
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#7A5195", "#666666"]
MARKERS = ["o", "s", "^", "D", "<", "P", "X", "*"]
DASHES = ["-", "--", "-.", ":"]
INK, FAINT, NOTE = "#222222", "#8A8A8A", "#555555"
FORMATS, PROBES = ("binary32", "binary64"), ("segment", "ray")
WIDTH = 6.5

plt.rcParams.update({
    "svg.hashsalt": "tribunal", "svg.fonttype": "path", "font.family": "DejaVu Sans", "font.size": 10,
    "axes.edgecolor": FAINT, "axes.labelcolor": INK, "text.color": INK, "xtick.color": INK, "ytick.color": INK,
    "axes.spines.top": False, "axes.spines.right": False, "axes.axisbelow": True, "axes.grid": True,
    "grid.color": "#E6E6E6", "grid.linewidth": 0.6, "axes.titlelocation": "left", "axes.titlesize": 10.5})


def style_of(record, method):
    i = [m["name"] for m in record["methods"]].index(method)
    return {"color": COLOURS[i % len(COLOURS)], "marker": MARKERS[i // len(COLOURS) % len(MARKERS) if i >= len(COLOURS)
                                                              else i], "ls": DASHES[i // 2 % len(DASHES)]}


def percent(y, _=None):
    return f"{100 * y:g} %"


def space(ax, axis, values):
    """Values as they are, or by their logarithms, with a place for zero; the easiest value to the left."""
    if axis["spacing"] == "logarithmic":
        ax.set_xscale("symlog", base=2, linthresh=1, linscale=0.6)
        top = max(values)
        step = max(1, math.ceil(math.log2(max(top, 2)) / 5))
        ticks = ([0] if 0 in values else []) + [2 ** e for e in range(0, int(math.log2(top)) + 1, step)]
        ax.set_xticks([t for t in ticks if t == 0 or t >= min(v for v in values if v)])
        ax.xaxis.set_major_formatter(FuncFormatter(
            lambda x, _: f"{x:g}" if x < 2000 else f"$2^{{{round(math.log2(x))}}}$"))
        ax.xaxis.set_minor_locator(matplotlib.ticker.NullLocator())
    else:
        ax.xaxis.set_major_locator(MaxNLocator(nbins=5, integer=True))


def wrapped(text, width):
    """Lines of text; a dollar in it, of a file's name say, begins no formula."""
    lines = [""]
    for word in text.replace("$", r"\$").split():
        if lines[-1] and len(lines[-1]) + 1 + len(word) > width:
            lines.append("")
        lines[-1] += (" " if lines[-1] else "") + word
    return "\n".join(lines)


def source_line(record):
    e = record["environment"]
    return f"{e['program']}, {e['compiler'].split(' 20')[0]}, seed {record['seed']}"


def title(figure, text, about, height):
    """A bold line, and what the figure is about below it."""
    figure.text(0.02, 1 - 0.12 / height, text, fontsize=12, fontweight="bold", va="top")
    figure.text(0.02, 1 - 0.40 / height, about, fontsize=8.5, color=NOTE, va="top", linespacing=1.35)


def draw_line(ax, record, rows, method, share_of):
    """`share_of`: the share that is drawn of a row; none is left out."""
    style = style_of(record, method)
    own = sorted((r for r in rows if r["method"] == method), key=lambda r: r["value"])
    shown = [(r["value"], share_of(r)) for r in own if share_of(r) and share_of(r)["n"]]
    if not shown:
        return
    heights = [w["share"] if w["k"] else w["upper"] for _, w in shown]
    # A line joins rates that were measured. Where nothing was wrong there is a bound and no rate: it stands alone.
    ax.plot([v for v, _ in shown], [y if w["k"] else math.nan for (_, w), y in zip(shown, heights)],
            color=style["color"], ls=style["ls"], lw=1.2)
    for (value, w), y in zip(shown, heights):
        if w["k"]:
            ax.plot([value, value], [max(w["lower"], 1e-9), w["upper"]], color=style["color"], lw=0.9)
            ax.plot([value], [y], style["marker"], ms=4, mec=style["color"], mew=1, mfc=style["color"], zorder=3)
        else:
            ax.plot([value], [y], BOUND, ms=4, mec=style["color"], mew=0.8, mfc="white", zorder=3)


def per_million(y, _=None):
    """Ticks are powers of ten."""
    return f"$10^{{{round(math.log10(1e6 * y))}}}$"


BOUND = "v"  # "at most this", of whatever method

# What can be wrong of a ray at a mesh; faults are drawn by no figure.
MESH_OUTCOMES = {"leak": "leaks", "double hit": "double hits", "false hit": "false hits", "parity": "wrong parity"}


def bands_of(axis, rows):
    """The rows of panels of an axis: a title, which rows of the record, and what share of them."""
    if axis["operands"] == "mesh":
        return [(words, lambda r: True, lambda r, o=outcome: r["outcomes"].get(o))
                for outcome, words in MESH_OUTCOMES.items() if any(outcome in r["outcomes"] for r in rows)]
    return [(probe + "s", lambda r, p=probe: r["probe"] == p, lambda r: r["wrong"])
            for probe in PROBES if any(r["probe"] == probe for r in rows)]


def axis_figure(record, axis):
    """A row of panels for each kind of probe or, of rays at a mesh, for each outcome; a column for each format."""
    rows = [r for r in record["rows"] if r["axis"] == axis["name"] and r["wrong"]["n"]]
    formats = [f for f in FORMATS if any(r["fmt"] == f for r in rows)]
    if not formats:
        return None
    bands = bands_of(axis, rows)
    of_mesh = axis["operands"] == "mesh"
    methods = [m["name"] for m in record["methods"] if any(r["method"] == m["name"] for r in rows)]
    columns = 3
    legend_rows = math.ceil((len(methods) + 1) / columns)
    height = 1.15 + 1.75 * len(bands) + 0.55 + 0.2 * legend_rows
    figure, axes = plt.subplots(len(bands), len(formats), figsize=(WIDTH, height), sharey=True, sharex="col",
                                squeeze=False)
    figure.subplots_adjust(left=0.125, right=0.98, top=1 - 1.15 / height, bottom=(0.62 + 0.2 * legend_rows) / height,
                           wspace=0.08, hspace=0.24)
    shares = [share_of(r) for _, takes, share_of in bands for r in rows if takes(r)]
    floor = min(w["share"] if w["k"] else w["upper"] for w in shares if w and w["n"])
    for i, (words, takes, share_of) in enumerate(bands):
        for j, fmt in enumerate(formats):
            ax = axes[i][j]
            own = [r for r in rows if takes(r) and r["fmt"] == fmt]
            ax.set(yscale="log", ylim=(floor / 2, 1.25))
            ax.yaxis.set_major_formatter(FuncFormatter(per_million if of_mesh else percent))
            ax.yaxis.set_minor_locator(matplotlib.ticker.NullLocator())
            space(ax, axis, axis["values"][fmt])
            for method in methods:
                draw_line(ax, record, own, method, share_of)
            n = {w["n"] for w in map(share_of, own) if w} if of_mesh else {r["asked"] for r in own}
            cases = f"{min(n)}" if len(n) == 1 else f"{min(n)} to {max(n)}" if n else "no"
            ax.set_title(f"{words}, {fmt} ({cases} {'rays' if of_mesh else 'each'})", fontsize=9)
    for ax in axes[-1]:
        ax.tick_params(axis="x", labelsize=9)
    figure.text(0.55, (0.25 + 0.2 * legend_rows) / height, axis["quantity"], ha="center", fontsize=9.5)
    figure.text(0.012, 0.5, "per million rays" if of_mesh else "share of wrong answers", rotation=90, va="center", fontsize=9.5)
    title(figure, f"Wrong answers along the axis “{axis['name']}”",
          wrapped(axis["population"][0].upper() + axis["population"][1:] + f". Bars: 95 % intervals. {source_line(record)}.", 98), height)
    handles = [Line2D([], [], color=style_of(record, m)["color"], marker=style_of(record, m)["marker"],
                      ls=style_of(record, m)["ls"], ms=4.5, lw=1.2, label=m) for m in methods]
    handles.append(Line2D([], [], ls="", marker=BOUND, ms=4.5, mec=INK, mfc="white", label="hollow: none, at most this"))
    figure.legend(handles=handles, loc="lower left", bbox_to_anchor=(0.08, 0), ncol=columns, frameon=False, fontsize=8.5,
                  handlelength=2.6, columnspacing=1.4, labelspacing=0.3)
    return figure


def earliest(marks, side):
    return min(marks, key=abs) if not marks else (min(marks) if side == "up" else max(marks))


def failing_spans(record, axis, fmt, method, probe, first, side):
    """From each value outward of the first at which something fails, to the next value."""
    fails = {r["value"] for r in record["rows"] if r["axis"] == axis["name"] and r["fmt"] == fmt and
             r["method"] == method and r["probe"] == probe and (r["wrong"]["k"] or r["refused"])}
    values = axis["values"][fmt] if side == "up" else axis["values"][fmt][::-1]
    values = values[values.index(first):]
    return [(a, b) for a, b in zip(values, values[1:]) if a in fails]


def thresholds_figure(record):
    """An axis a row, a format a column: for each method a bar where something fails, dark where some outcome is all that
    is left."""
    axes_shown = [a for a in record["axes"] if any(r["axis"] == a["name"] for r in record["rows"])]
    formats = [f for f in FORMATS if any(r["fmt"] == f for r in record["rows"])]
    asked = {a["name"]: [m["name"] for m in record["methods"]
                         if any(r["axis"] == a["name"] and r["method"] == m["name"] for r in record["rows"])]
             for a in axes_shown}
    heights = [0.62 + 0.19 * len(asked[a["name"]]) for a in axes_shown]
    height = sum(heights) + 1.55
    figure = plt.figure(figsize=(WIDTH, height))
    top = height - 0.95
    for axis, h in zip(axes_shown, heights):
        methods = asked[axis["name"]]
        for j, fmt in enumerate(formats):
            left = 0.22 + j * 0.77 / len(formats)
            ax = figure.add_axes([left, (top - h + 0.36) / height, 0.77 / len(formats) - 0.035, (h - 0.62) / height])
            values = axis["values"][fmt]
            space(ax, axis, values)
            ax.set_xlim(*((min(values) - 0.02 * (max(values) - min(values)),
                           max(values) + 0.02 * (max(values) - min(values)))
                          if axis["spacing"] == "even" else (min(values) * 0.9, max(values) * 1.1)))
            ax.set_ylim(len(methods) - 0.5, -0.5)
            ax.set_yticks(range(len(methods)), methods if j == 0 else [""] * len(methods), fontsize=8.5)
            ax.tick_params(axis="x", labelsize=8.5, pad=2)
            ax.tick_params(axis="y", length=0)
            for y, method in enumerate(methods):
                if not any(r["method"] == method and r["fmt"] == fmt for r in record["rows"] if r["axis"] == axis["name"]):
                    ax.text(0.5, y, "not asked", transform=ax.get_yaxis_transform(), fontsize=7.5, color=FAINT, ha="center",
                            va="center")
                    continue
                for k, probe in enumerate(axis["probes"]):
                    offset = (k - 0.5) * 0.36 if len(axis["probes"]) > 1 else 0
                    for side in ("up", "down"):
                        own = [t for t in record["thresholds"] if t["axis"] == axis["name"] and t["fmt"] == fmt and
                               t["method"] == method and t["probe"] == probe and t["side"] == side]
                        if not own:
                            continue
                        end = max(values) if side == "up" else min(values)
                        first = earliest([t["first"]["value"] for t in own], side)
                        for a, b in failing_spans(record, axis, fmt, method, probe, first, side):
                            ax.plot([a, b], [y + offset] * 2, color="#F0A070", lw=3.4, solid_capstyle="butt")
                        ax.plot([first], [y + offset], "|", color=INK, ms=5, mew=1.2)
                        full = [t["all"]["value"] for t in own if t["all"]]
                        if full:
                            ax.plot([earliest(full, side), end], [y + offset] * 2, color="#7A1F00", lw=3.4,
                                    solid_capstyle="butt")
            if j == 0:
                figure.text(0.02, (top - 0.02) / height, f"{axis['name']}: {axis['quantity']}", fontsize=9,
                            fontweight="bold", va="top")
        top -= h
    for j, fmt in enumerate(formats):
        figure.text(0.22 + j * 0.77 / len(formats), (height - 0.78) / height, fmt, fontsize=9.5, va="top")
    title(figure, "Where each method begins to fail, and where it has failed",
          wrapped(f"{record['cases']} cases at each value; two bars of a method: the upper is of segments, the lower of rays. "
                  f"{source_line(record)}.", 98), height)
    figure.legend(handles=[Line2D([], [], color=INK, marker="|", ls="", ms=6, mew=1.3, label="first wrong answer"),
                           Patch(color="#F0A070", label="some wrong"),
                           Patch(color="#7A1F00", label="nothing else left of one outcome")],
                  loc="lower left", bbox_to_anchor=(0.02, 0), ncol=3, frameon=False, fontsize=8.5)
    return figure


# --- failure maps ----------------------------------------------------------------------------------------------------

# Right answers light, wrong ones dark, each a step of grey apart from the next.
PIXELS = {"M": ("right, a miss", "#FFFFFF"), "H": ("right, a hit", "#DDE3EA"), " ": ("nothing owed", "#F6EFC8"),
          "?": ("refused", "#F0C000"), "-": ("false miss", "#C8401A"), "+": ("false hit", "#0B2C5C"),
          "c": ("wrong contact", "#A98BD0"), "x": ("fault", "#000000")}


def rgb(colour):
    return tuple(int(colour[i:i + 2], 16) for i in (1, 3, 5))


def draw_pixels(ax, rows):
    size = len(rows)
    ax.imshow([[rgb(PIXELS[c][1]) for c in row] for row in rows], origin="lower", interpolation="nearest",
              extent=(-size / 2, size / 2, -size / 2, size / 2))
    ax.grid(False)
    for side in ("top", "right"):
        ax.spines[side].set_visible(True)
    ticks = [-(3 * size // 8), 0, 3 * size // 8]
    ax.set_xticks(ticks)
    ax.set_yticks(ticks)
    ax.tick_params(labelsize=8, length=2, pad=2)


def map_figure(record):
    """The exact answer of each format, then every method."""
    probe = record.get("probe", "segment")
    panels = [(f"exact, {fmt}", "", [row.replace("h", "H").replace(".", "M") for row in rows])
              for fmt, rows in record["truth"].items()]
    total = record["size"] ** 2
    for p in record["panels"]:
        wrong = sum(p["counts"].get(o, 0) for o in ("false hit", "false miss", "wrong contact", "fault"))
        panels.append((p["method"], f"{wrong:,} of {total:,} wrong", p["pixels"]))
    columns = min(3, len(panels))
    lines = math.ceil(len(panels) / columns)
    side = (WIDTH - 0.75) / columns - 0.18
    seen = {c for _, _, rows in panels for row in rows for c in set(row)}
    shown = [c for c in PIXELS if c in seen]
    legend_lines = math.ceil(len(shown) / 4)
    height = 1.0 + lines * (side + 0.62) + 0.35 + 0.22 * legend_lines
    figure = plt.figure(figsize=(WIDTH, height))
    for i, (name, note, rows) in enumerate(panels):
        left = 0.62 + (i % columns) * (side + 0.2)
        bottom = height - 1.0 - (i // columns) * (side + 0.62) - side - 0.38
        ax = figure.add_axes([left / WIDTH, bottom / height, side / WIDTH, side / height])
        draw_pixels(ax, rows)
        ax.text(0, 1.115, name, transform=ax.transAxes, fontsize=9, fontweight="bold", va="bottom")
        ax.text(0, 1.02, note, transform=ax.transAxes, fontsize=8, color=NOTE, va="bottom")
        if i % columns:
            ax.set_yticklabels([])
    figure.text(0.53, (0.12 + 0.22 * legend_lines) / height, f"x of the {probe}'s source, moved (ulps)", ha="center", fontsize=9)
    figure.text(0.012, 0.5, "y, moved (ulps)", rotation=90, va="center", fontsize=9)
    e = record["environment"]
    title(figure, f"Answers around a contact: {record['map']}, {probe}s",
          wrapped(record["about"][0].upper() + record["about"][1:] + ". Each method in its own format. " + f"{e['program']}, {e['compiler'].split(' 20')[0]}.",
                  98), height)
    figure.legend(handles=[Patch(fc=PIXELS[c][1], ec=FAINT, lw=0.6, label=PIXELS[c][0]) for c in shown],
                  loc="lower left", bbox_to_anchor=(0.07, 0), ncol=4, frameon=False, fontsize=8.5, handlelength=1.2)
    return figure


def compilers_figure(record):
    """A row a method, a column a build; a cell says the share of answers that change, and is darker for more."""
    builds = [b["name"] for b in record["builds"]]
    methods = list(dict.fromkeys(r["method"] for r in record["rows"]))
    share = {(r["method"], r["build"]): r["changed"] / r["answers"]["asked"] for r in record["rows"]}
    e = record["environment"]
    flags = "; ".join(f"{b['name']}: {b['flags']}" for b in record["builds"])
    about = wrapped(f"Hit or miss is not what the program's own build says ({e['compiler'].split(' 20')[0]}, strict). Of "
                    f"{record['cases_of_each_format']:,} cases of all families in each format, most of them degenerate. "
                    f"Seed {record['seed']}. {flags}.", 100)
    row = 0.19
    head = 1.35 + 0.155 * about.count("\n")
    height = head + row * len(methods)
    figure = plt.figure(figsize=(WIDTH, height))
    ax = figure.add_axes([1.5 / WIDTH, 0.1 / height, (WIDTH - 2.05) / WIDTH, row * len(methods) / height])
    for i, method in enumerate(methods):
        for j, build in enumerate(builds):
            s = share[method, build]
            depth = 0 if s == 0 else min(1, max(0, 1 + math.log10(s) / 4))
            ax.add_patch(plt.Rectangle((j, i), 1, 1, fc=plt.cm.Blues(0.75 * depth), ec="white", lw=1))
            ax.text(j + 0.5, i + 0.53, "0" if s == 0 else f"{100 * s:.1f}" if s >= 0.001 else "<0.1", fontsize=6.5,
                    ha="center", va="center", color="white" if depth > 0.88 else INK)
    ax.set_xlim(0, len(builds))
    ax.set_ylim(len(methods), 0)
    ax.xaxis.tick_top()
    ax.set_xticks([j + 0.35 for j in range(len(builds))], builds, rotation=40, ha="left", va="bottom", fontsize=8)
    ax.set_yticks([i + 0.5 for i in range(len(methods))], methods, fontsize=7.5)
    ax.tick_params(length=0, pad=2)
    ax.grid(False)
    for spine in ax.spines.values():
        spine.set_visible(False)
    title(figure, "One source, built otherwise: answers that change, in %", about, height)
    return figure


def save(figure, name):
    if figure is None:
        return
    figure.savefig(name + ".svg", metadata={"Date": None, "Creator": None})
    figure.savefig(name + ".png", dpi=200, metadata={"Software": None})
    plt.close(figure)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__.splitlines()[0])
    with open(sys.argv[1], encoding="utf-8") as file:
        record = json.load(file)
    if record.get("axis") == "compiler":
        save(compilers_figure(record), os.path.join(sys.argv[2], "compilers"))
        return
    if "map" in record:
        save(map_figure(record), os.path.join(sys.argv[2], os.path.basename(sys.argv[1]).removesuffix(".json")))
        return
    save(thresholds_figure(record), os.path.join(sys.argv[2], "thresholds"))
    for axis in record["axes"]:
        save(axis_figure(record, axis), os.path.join(sys.argv[2], "axis-" + os.path.basename(axis["name"])))


if __name__ == "__main__":
    try:
        main()
    except OSError:
        traceback.print_exc()
        sys.exit(74)  # script_cannot_write
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError):
        traceback.print_exc()
        sys.exit(65)  # script_refuses_record
