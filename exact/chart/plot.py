#!/usr/bin/env python3
"""Draws what `tribunal chart` measured: python3 plot.py chart.json OUTDIR

speed-accuracy           share of wrong answers against time, a panel for each population and format
speed-accuracy-shares    the same on random pairs by the share of hits
speed-accuracy-polygons  the same of polygons
pictures                 share of wrong pixels against rays a second
leaks                    leaks per million rays against time
speed                    time per test by the share of hits, a line of marks for each method and way to call it

Everything is read from the record; a mark's shape and fill come from what the record says of its method. Figures are as
wide as a paper's column. A method that was never wrong stands in a band of its own below the axis, which has no zero.
"""
import functools
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
from matplotlib.font_manager import findfont, get_font
from matplotlib.lines import Line2D

WIDTH = 84 / 25.4  # inches
INK, FAINT, PALE = "#222222", "#6E6E6E", "#DDDDDD"
SMALL = 5.8  # points, of all text but titles
MARK = 4.6   # points across

# Okabe and Ito's colours, which stay apart for colour-blind eyes; the fill says the same without them.
MAKERS = {"segura-feito": ("#0072B2", "full", "Segura–Feito"), "published": ("#D55E00", "none", "published rival"),
          "library": ("#00805E", "bottom", "CGAL's own"), "plugin": ("#222222", "dot", "plugin")}
ARITHMETIC = {"binary32": ("^", "computes in binary32"), "binary64": ("o", "in binary64"), "exact": ("s", "exact"),
              "certified": ("D", "exact, certified")}
FORMATS = ("binary32", "binary64")

plt.rcParams.update({
    "svg.hashsalt": "tribunal", "svg.fonttype": "path", "font.family": "DejaVu Sans", "font.size": SMALL,
    "text.parse_math": False, "axes.edgecolor": FAINT, "axes.linewidth": 0.5, "axes.labelcolor": INK,
    "text.color": INK, "xtick.color": INK, "ytick.color": INK, "axes.labelpad": 2, "axes.axisbelow": True,
    "xtick.major.size": 2, "ytick.major.size": 2, "xtick.major.width": 0.5, "ytick.major.width": 0.5,
    "xtick.major.pad": 1.5, "ytick.major.pad": 1.5, "axes.spines.top": False, "axes.spines.right": False})


# --- marks ---------------------------------------------------------------------------------------------------------

def arithmetic_of(method):
    if method["exact"]:
        return "certified" if method["certified"] else "exact"
    return method["fmt"]


def draw_mark(ax, x, y, shape, maker, **more):
    """Shape: arithmetic; fill and colour: maker."""
    colour, fill, _ = MAKERS[maker]
    size = MARK * (0.86 if shape == "D" else 1)
    style = {"marker": shape, "ms": size, "mec": colour, "mew": 0.8, "ls": "", "zorder": 4, "clip_on": False, **more}
    if fill in ("full", "bottom"):
        ax.plot([x], [y], mfc=colour, mfcalt="white", fillstyle=fill, **style)
    else:
        ax.plot([x], [y], mfc="white", **style)
    if fill == "dot":
        ax.plot([x], [y], marker="o", ms=1.5, mfc=colour, mec="none", ls="", zorder=5, transform=more.get("transform", ax.transData),
                clip_on=False)


class Methods:
    """What the record says of each method, with the number that stands for it in every figure."""

    def __init__(self, record):
        self.by_name = {m["name"]: m for m in record["methods"]}
        self.number = {name: i + 1 for i, name in enumerate(self.by_name)}

    def mark(self, ax, x, y, name, **more):
        m = self.by_name[name]
        draw_mark(ax, x, y, ARITHMETIC[arithmetic_of(m)][0], m["maker"], **more)


# --- places of numbers ---------------------------------------------------------------------------------------------

def overlap(a, b):
    w = min(a[2], b[2]) - max(a[0], b[0])
    h = min(a[3], b[3]) - max(a[1], b[1])
    return w * h if w > 0 and h > 0 else 0


def crosses(p, q, box):
    """Whether the line from p to q meets the box, by steps of a point or less."""
    steps = 24
    return any(box[0] <= p[0] + (q[0] - p[0]) * t / steps <= box[2] and box[1] <= p[1] + (q[1] - p[1]) * t / steps <= box[3]
               for t in range(steps + 1))


def label_width(text):
    """Points."""
    return 0.64 * SMALL * len(text) + 0.6


def box_of(text, to_points):
    box = text.get_window_extent()
    return tuple(to_points * v for v in (box.x0, box.y0, box.x1, box.y1))


def place_labels(ax, points):
    """A number at each mark, where it covers no mark and no other number; a line to it, which crosses no mark, if it
    stands further off. In points, from the figure's corner."""
    to_points = 72 / ax.figure.dpi

    def spot(x, y):
        px, py = ax.transData.transform((x, y))
        return px * to_points, py * to_points

    bounds = ax.get_window_extent()
    frame = (bounds.x0 * to_points - 2, bounds.y0 * to_points, bounds.x1 * to_points + 2, bounds.y1 * to_points + 3)
    where = [spot(p["x"], p["y"]) for p in points]
    half = MARK / 2 + 0.9
    marks = [(x - half, y - half, x + half, y + half) for x, y in where]
    bars = []
    for p, (x, y) in zip(points, where):
        bars.append((spot(p["left"], p["y"])[0], y - 0.3, spot(p["right"], p["y"])[0], y + 0.3))
        if "low" in p:
            bars.append((x - 0.3, spot(p["x"], p["low"])[1], x + 0.3, spot(p["x"], p["high"])[1]))
    wide, tall = (72 * inches for inches in ax.figure.get_size_inches())
    taken = [box_of(text, to_points) for text in ax.texts if text.get_text().startswith("none wrong")]
    for i in sorted(range(len(points)), key=lambda i: ("beside" not in points[i], where[i])):
        x, y = where[i]
        text = points[i]["text"]
        w, h = label_width(text), 0.76 * SMALL + 0.6
        if "beside" in points[i]:
            left = x + points[i]["beside"]
            taken.append((left, y - h / 2, left + w, y + h / 2))
            ax.figure.text((left + w / 2) / wide, y / tall, text, ha="center", va="center_baseline", zorder=6)
            continue
        best = None
        for radius in (0, 3, 7, 12, 18, 25):
            for turn in range(16):
                angle = math.pi * (turn / 8 + 0.25)
                cx = x + math.cos(angle) * (half + w / 2 - 0.4 + radius)
                cy = y + math.sin(angle) * (half + h / 2 - 0.4 + radius)
                box = (cx - w / 2, cy - h / 2, cx + w / 2, cy + h / 2)
                cost = 0.35 * radius + sum(9 * overlap(box, m) for m in marks) + sum(12 * overlap(box, t) for t in taken)
                cost += sum(4 * overlap(box, b) for b in bars)
                cost += 1000 * (box[0] < frame[0] or box[1] < frame[1] or box[2] > frame[2] or box[3] > frame[3])
                if radius > 3:
                    cost += 60 * sum(crosses((x, y), (cx, cy), m) for j, m in enumerate(marks) if j != i)
                    cost += 30 * sum(crosses((x, y), (cx, cy), t) for t in taken)
                if best is None or cost < best[0] - 1e-9:
                    best = (cost, box, cx, cy, radius)
        _, box, cx, cy, radius = best
        taken.append(box)
        ax.figure.text(cx / wide, cy / tall, text, ha="center", va="center_baseline", zorder=6)
        if radius > 3:
            far = math.hypot(cx - x, cy - y)
            from_mark, to_number = (half + 0.2) / far, 1 - 0.5 * h / far
            ax.figure.add_artist(Line2D([(x + f * (cx - x)) / wide for f in (from_mark, to_number)],
                                        [(y + f * (cy - y)) / tall for f in (from_mark, to_number)],
                                        transform=ax.figure.transFigure, color=FAINT, lw=0.4))


# --- a panel -------------------------------------------------------------------------------------------------------

def percent(share):
    return f"{100 * share:g} %"


def whole(n):
    return f"{n:,}"


class Scale:
    """The vertical axis of a figure: logarithms of shares, and a band below all of them for none."""

    def __init__(self, rows, name=percent):
        somes = [r["lower"] for r in rows if r["wrong"] and r["lower"] > 0]
        self.floor = math.floor(math.log10(min(somes, default=1e-3)))
        self.top = math.ceil(math.log10(max((r["upper"] for r in rows if r["wrong"]), default=1)) - 0.15)
        self.top = max(self.top, self.floor + 2)
        self.band = 0.85 * (self.top - self.floor)
        self.name = name

    def levels(self):
        """Heights within the band; they mean nothing."""
        return [self.floor - self.band * f for f in (0.26, 0.375, 0.49, 0.605, 0.72, 0.835, 0.95)]

    def dress(self, ax, label):
        bottom = self.floor - 1.02 * self.band
        ax.set_ylim(bottom, self.top + 0.08 * (self.top - self.floor))
        ax.axhspan(bottom, self.floor - 0.04 * self.band, color="#F0F0F0", lw=0, zorder=0)
        every = 1 if self.top - self.floor < 4 else 2
        ticks = list(range(self.top, self.floor - 1, -every))
        ax.set_yticks(ticks + [self.levels()[3]], [self.name(10.0 ** t) for t in ticks] + ["none"])
        for t in ticks:
            ax.axhline(t, color=PALE, lw=0.4, zorder=0)
        ax.text(0.985, (self.floor - 0.06 * self.band - bottom) / (self.top + 0.08 * (self.top - self.floor) - bottom),
                label, transform=ax.transAxes, ha="right", va="top", fontsize=SMALL - 0.4, color=FAINT,
                bbox={"facecolor": "#F0F0F0", "edgecolor": "none", "pad": 0.3})


def points_of(ax, rows, methods, scale, usual):
    """Rows as points. Those with none wrong are dealt to the levels of the band, so that marks, bars and the number right
    of each lie apart; `beside` is where that number begins, in points right of the mark."""
    points, ends = [], [-math.inf] * len(scale.levels())
    across = ax.get_position().width * WIDTH * 72
    for r in sorted(rows, key=lambda r: r["left"]):
        p = {"x": r["x"], "left": r["left"], "right": r["right"], "name": r["method"], "wrong": r["wrong"],
             "share": r["share"], "text": str(methods.number[r["method"]]) + ("*" if r["n"] < usual else "")}
        points.append(p)
        if r["wrong"]:
            p["y"], p["low"], p["high"] = (math.log10(max(r[k], 1e-12)) for k in ("share", "lower", "upper"))
            continue
        low, high = map(math.log, ax.get_xlim())
        left, middle, right = (across * (math.log(r[k]) - low) / (high - low) for k in ("left", "x", "right"))
        left, right = min(left, middle - MARK / 2 - 0.8), max(right, middle + MARK / 2) + 0.8
        wide = label_width(p["text"])
        p["beside"] = right - middle if right + wide < across + 4 else left - wide - middle
        left, right = min(left, middle + p["beside"]), max(right, middle + p["beside"] + wide)
        free = [i for i, end in enumerate(ends) if end <= left]
        level = free[0] if free else min(range(len(ends)), key=lambda i: ends[i])
        ends[level] = right
        p["y"] = scale.levels()[level]
    return points


def frontier_of(points, better_left):
    """Those than which none is both quicker and less often wrong."""
    best, frontier = math.inf, []
    for p in sorted(points, key=lambda p: (p["x"] if better_left else -p["x"], p["share"])):
        if p["share"] < best:
            best = p["share"]
            frontier.append(p)
    return frontier


def draw_panel(ax, rows, methods, scale, better_left=True):
    """rows: method, x, left, right, wrong, n, share, lower, upper; those with n = 0 are not drawn."""
    rows = [r for r in rows if r["n"]]
    usual = max((r["n"] for r in rows), default=0)
    scale.dress(ax, f"none wrong of {whole(usual)}" if usual else "nothing judged")
    points = points_of(ax, rows, methods, scale, usual)
    steps = []
    for p in frontier_of(points, better_left):
        if steps:
            steps.append((p["x"], steps[-1][1]))
        steps.append((p["x"], p["y"]))
    ax.plot([x for x, _ in steps], [y for _, y in steps], color=FAINT, lw=0.9, ls=(0, (2.5, 1.2)), zorder=2)
    for p in points:
        colour = MAKERS[methods.by_name[p["name"]]["maker"]][0]
        ax.plot([p["left"], p["right"]], [p["y"]] * 2, color=colour, lw=0.9, zorder=3, solid_capstyle="butt")
        if p["wrong"]:
            ax.plot([p["x"]] * 2, [p["low"], p["high"]], color=colour, lw=0.9, zorder=3, solid_capstyle="butt")
        methods.mark(ax, p["x"], p["y"], p["name"])
    return points


def decades(low, high):
    return [m * 10.0 ** e for e in range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1) for m in (1, 2, 5)
            if low <= m * 10.0 ** e <= high]


def dress_x(axes, rows, name, unit=None):
    """One logarithmic axis for all panels of a figure; a line at `unit`."""
    low, high = min(r["left"] for r in rows) / 1.5, max(r["right"] for r in rows) * 1.6
    ticks = decades(low, high)
    if len(ticks) > 4:
        ticks = [t for t in ticks if f"{t:e}"[0] == "1"]
    for row in axes:
        for ax in row:
            ax.set_xscale("log")
            ax.set_xlim(low, high)
            ax.set_xticks(ticks, [name(t) for t in ticks] if row is axes[-1] else [""] * len(ticks))
            ax.set_xticks([], minor=True)
            if unit:
                ax.axvline(unit, color=FAINT, lw=0.5, ls=":", zorder=1)


# --- text ----------------------------------------------------------------------------------------------------------

@functools.lru_cache(maxsize=None)
def advance_of(character):
    """In units of the font's size."""
    font = get_font(findfont("DejaVu Sans"))
    font.set_size(100, 72)
    return font.load_char(ord(character)).linearHoriAdvance / 6553600


def width_of(text, size=SMALL):
    """Inches."""
    return sum(map(advance_of, text)) * size / 72


def wrapped(text, width=WIDTH - 0.1):
    lines = []
    for paragraph in text.split("\n"):
        line = ""
        for word in paragraph.split(" "):
            longer = f"{line} {word}" if line else word
            if line and width_of(longer) > width:
                lines.append(line)
                line = word
            else:
                line = longer
        lines.append(line)
    return lines


def shortened(name, most=26):
    return name if len(name) <= most else name[:most - 1] + "…"


def machine(record):
    e = record["environment"]
    compiler = " ".join(e["compiler"].split()[:2])
    return f"{e['processor']}; {compiler}, {e['flags']}; {e['program']}; seed {record['seed']}."


class Sheet:
    """A figure of a column's width, filled from above; y counts down from the top, in inches."""

    def __init__(self, height):
        self.height = height
        self.figure = plt.figure(figsize=(WIDTH, height))

    def axes(self, left, top, width, height):
        return self.figure.add_axes((left / WIDTH, 1 - (top + height) / self.height, width / WIDTH, height / self.height))

    def text(self, x, y, text, size=SMALL, **more):
        self.figure.text(x / WIDTH, 1 - y / self.height, text, fontsize=size, va="top", **more)

    def mark(self, x, y, shape, maker):
        ax = self.figure.axes[0]
        draw_mark(ax, x / WIDTH, 1 - y / self.height, shape, maker, transform=self.figure.transFigure)

    def save(self, name):
        self.figure.savefig(name + ".svg", metadata={"Date": None, "Creator": None})
        self.figure.savefig(name + ".pdf", metadata={"CreationDate": None, "Creator": None, "Producer": None})
        self.figure.savefig(name + ".png", dpi=1280 / WIDTH, metadata={"Software": None})
        plt.close(self.figure)


LINE = 0.107  # inches between lines


class Key:
    """Below the panels: the methods by number, what shapes and fills mean, and notes."""

    def __init__(self, methods, names, notes):
        self.methods, self.names = methods, names
        longest = max((width_of(shortened(n)) for n in names), default=0)
        self.columns = max(1, min(4, int((WIDTH - 0.1) / (longest + 0.33))))
        self.rows = -(-len(names) // self.columns)
        self.notes = [line for note in notes if note for line in wrapped(note)]
        self.shapes = [a for a in ARITHMETIC if any(arithmetic_of(methods.by_name[n]) == a for n in names)]
        self.makers = [m for m in MAKERS if any(methods.by_name[n]["maker"] == m for n in names)]

    def height(self):
        return LINE * (self.rows + 2 + len(self.notes)) + 0.2

    def draw(self, sheet, y):
        for i, name in enumerate(self.names):
            x = 0.05 + (i // self.rows) * (WIDTH - 0.08) / self.columns
            top = y + (i % self.rows) * LINE
            m = self.methods.by_name[name]
            sheet.text(x + 0.11, top, str(self.methods.number[name]), ha="right")
            sheet.mark(x + 0.175, top + 0.043, ARITHMETIC[arithmetic_of(m)][0], m["maker"])
            sheet.text(x + 0.24, top, shortened(name))
        y += self.rows * LINE + 0.05
        for entries in ([(ARITHMETIC[s][0], "segura-feito", ARITHMETIC[s][1]) for s in self.shapes],
                        [("o", m, MAKERS[m][2]) for m in self.makers]):
            x = 0.1
            for shape, maker, text in entries:
                sheet.mark(x, y + 0.043, shape, maker)
                sheet.text(x + 0.07, y, text, color=INK)
                x += 0.07 + width_of(text) + 0.17
            y += LINE
        y += 0.05
        for line in self.notes:
            sheet.text(0.05, y, line, color="#444444")
            y += LINE


LEFT, RIGHT, GAP = 0.5, 0.06, 0.1
PANEL = 1.5  # inches high


class Grid:
    """A title, rows of panels, two in a row, and a key."""

    def __init__(self, title, rows, key):
        heights = 0.24 + rows * (PANEL + 0.19) + 0.32
        self.sheet, self.key, self.below = Sheet(heights + key.height()), key, heights
        self.sheet.text(0.05, 0.05, title, 7.6, fontweight="bold")
        width = (WIDTH - LEFT - RIGHT - GAP) / 2
        self.axes = [[self.sheet.axes(LEFT + c * (width + GAP), 0.33 + r * (PANEL + 0.19), width, PANEL) for c in range(2)]
                     for r in range(rows)]
        for row in self.axes:
            row[1].tick_params(labelleft=False)
        for ax, fmt in zip(self.axes[0], FORMATS):
            ax.text(1, 1.035, fmt, transform=ax.transAxes, ha="right", va="bottom", color=FAINT)

    def label_row(self, r, title):
        self.axes[r][0].text(0, 1.035, title, transform=self.axes[r][0].transAxes, fontsize=SMALL + 0.7, va="bottom",
                             fontweight="bold")

    def label_y(self, text):
        for row in self.axes:
            box = row[0].get_position()
            self.sheet.figure.text(0.07 / WIDTH, (box.y0 + box.y1) / 2, text, rotation=90, ha="center", va="center")

    def label_x(self, text):
        self.sheet.text(LEFT + (WIDTH - LEFT - RIGHT) / 2, self.below - 0.2, text, ha="center")

    def save(self, panels, name):
        """panels: axes with their points, of which the numbers are placed now that all scales are known."""
        self.key.draw(self.sheet, self.below)
        self.sheet.figure.canvas.draw()
        for ax, points in panels:
            place_labels(ax, points)
        self.sheet.save(name)


# --- share of wrong answers against time ---------------------------------------------------------------------------

def interval(median):
    return {"x": median["median"], "left": median.get("lower", median["median"]),
            "right": median.get("upper", median["median"])}


def row_of(r):
    a = r["answers"]
    return {"method": r["method"], **interval(r["nanoseconds"]["ratio"]), "wrong": a["wrong"], "n": a["judged"],
            "share": a["share"], "lower": a["lower"], "upper": a["upper"]}


def share_text(part, of):
    return "none" if part == 0 else f"{100 * part / of:.1f} %" if part * 1000 > of else "< 0.1 %"


def makeup_note(panels):
    """One population, in either format."""
    def shares(of):
        texts = [share_text(of(p), p["cases"]) for p in panels]
        return texts[0] if len(set(texts)) == 1 else " / ".join(texts)

    note = f"{panels[0]['title']}: {panels[0]['about']}; hits {shares(lambda p: p['hits'])}"
    for what, of in (("with a subnormal coordinate", lambda p: p["subnormal"]),
                     ("past all integers of fixed width", lambda p: p["by_stage"]["exact"])):
        note += f", {shares(of)} {what}"
    return note + "."


def numbers_text(numbers):
    return ", ".join(str(n) for n in sorted(numbers))


def unjudged_notes(record, methods, panels):
    """Who has no mark in a panel, and who was judged on fewer cases than the others."""
    none, fewer = {}, {}
    for panel in panels:
        own = {r["method"]: r["answers"] for r in record["rows"]
               if (r["population"], r["fmt"]) == (panel["population"], panel["fmt"])}
        missing = tuple(sorted(methods.number[m] for m in methods.by_name if m not in own or not own[m]["judged"]))
        usual = max((a["judged"] for a in own.values()), default=0)
        if missing:
            none.setdefault(missing, []).append(panel)
        for m, a in own.items():
            if 0 < a["judged"] < usual:
                fewer.setdefault((panel["title"], methods.number[m]), []).append(whole(a["judged"]))
    notes = []
    for missing, where in none.items():
        titles = [f"{p['title']}, {p['fmt']}" for p in where]
        if {p["fmt"] for p in where} == {where[0]["fmt"]} and len(where) == len([p for p in panels if p["fmt"] == where[0]["fmt"]]):
            titles = [f"all panels of {where[0]['fmt']} cases"]
        if len(where) == len(panels):
            titles = ["all panels"]
        names = ", ".join(f"{n} {shortened(name)}" for name, n in methods.number.items() if n in missing)
        notes.append(f"Nothing to judge, so no mark, in {'; '.join(titles)}: {names}.")
    parts = [f"{title}: {number} on {' / '.join(dict.fromkeys(counts))}" for (title, number), counts in fewer.items()]
    if parts:
        notes.append("* judged on fewer cases, the rest being outside the contract: " + "; ".join(parts) + ".")
    return notes


def bars_note(repetitions):
    time = (f"of time for the median over {repetitions} repetitions, by ranks" if repetitions >= 6
            else "of time none, for want of repetitions")
    return (f"Bars are 95 % intervals both ways: of shares by Clopper and Pearson, {time}. Dashed: the frontier, than which "
            "nothing is both quicker and less often wrong. In the grey band nothing was wrong; heights in it mean nothing.")


def bound_note(n):
    return f"None of {whole(n)} leaves at most {100 * (1 - 0.05 ** (1 / n)):.2g} % (95 %, one-sided)." if n else ""


def speed_accuracy(record, figure, title, out):
    methods = Methods(record)
    panels = [p for p in record["panels"] if p["figure"] == figure and p["cases"]]
    keys = list(dict.fromkeys(p["population"] for p in panels))
    rows = {(p["population"], p["fmt"]): [] for p in panels}
    for r in record["rows"]:
        if (r["population"], r["fmt"]) in rows:
            rows[r["population"], r["fmt"]].append(row_of(r))
    drawn = [r for own in rows.values() for r in own if r["n"]]
    if not drawn:
        return
    taking = [m for m in methods.by_name if any(r["method"] == m for r in drawn)]
    if figure == "polygons":  # those that take none are no news
        methods.by_name = {m: methods.by_name[m] for m in taking}
    repetitions = max(r["nanoseconds"]["repetitions"] for r in record["rows"])
    unit = f"1 = {record['yardstick']} in the same run" + (", on random triangles; polygons are prepared."
                                                         if figure == "polygons" else ", on the same pairs.")
    notes = [bars_note(repetitions), f"Time: {unit} Each repetition took other pairs.",
             bound_note(max(r["n"] for r in drawn))]
    notes += unjudged_notes(record, methods, panels)
    if figure != "shares":
        notes += [makeup_note([p for p in panels if p["population"] == key]) for key in keys]
        notes.append("Where two figures stand, they are of binary32 / binary64 cases.")
    if figure == "shares":
        notes.append(f"{panels[0]['about'][0].upper()}{panels[0]['about'][1:]}, dealt to have these shares of hits.")
    key = Key(methods, taking, notes + [machine(record)])
    grid = Grid(title, len(keys), key)
    scale, placed = Scale(drawn), []
    dress_x(grid.axes, drawn, lambda t: f"{t:g}×", 1)
    for r, name in enumerate(keys):
        grid.label_row(r, next(p["title"] for p in panels if p["population"] == name))
        for ax, fmt in zip(grid.axes[r], FORMATS):
            placed.append((ax, draw_panel(ax, rows.get((name, fmt), []), methods, scale)))
    grid.label_y("share of wrong answers")
    grid.label_x(f"time per test, as a multiple of {record['yardstick']}'s")
    grid.save(placed, out)


# --- pictures and leaks --------------------------------------------------------------------------------------------

def two_panels(record, rows, title, ylabel, xlabel, name_x, notes, out, name_y=percent, better_left=True, unit=None):
    """One panel a format."""
    methods = Methods(record)
    drawn = [r for own in rows.values() for r in own if r["n"]]
    if not drawn:
        return
    names = [m for m in methods.by_name if any(r["method"] == m for r in drawn)]
    for fmt in FORMATS:
        missing = [m for m in methods.by_name if all(r["method"] != m for r in rows[fmt])]
        if missing:
            notes.append(f"Nothing to judge, so no mark, in {fmt}: "
                         + ", ".join(f"{methods.number[m]} {shortened(m)}" for m in missing) + ".")
    grid = Grid(title, 1, Key(methods, names, notes + [machine(record)]))
    scale = Scale(drawn, name_y)
    dress_x(grid.axes, drawn, name_x, unit)
    placed = [(ax, draw_panel(ax, rows[fmt], methods, scale, better_left)) for ax, fmt in zip(grid.axes[0], FORMATS)]
    grid.label_y(ylabel)
    grid.label_x(xlabel)
    grid.save(placed, out)


def big(x):
    return f"{x / 1e6:g} M" if x >= 1e6 else f"{x / 1e3:g} k" if x >= 1e3 else f"{x:g}"


def pictures(record, out):
    part = record.get("pictures", {"rows": []})
    rows = {fmt: [{**r, **interval(r["rays_per_second"]), "n": r["pixels"]} for r in part["rows"] if r["fmt"] == fmt]
            for fmt in FORMATS}
    if not part["rows"]:
        return
    once = sorted({r["method"] for r in part["rows"] if "lower" not in r["rays_per_second"]})
    numbers = Methods(record).number
    starts = max(r["other_start"] for r in part["rows"])
    notes = [bars_note(max(r["repetitions"] for r in part["rows"])),
             f"{len(part['scenes'])} scenes: {', '.join(os.path.splitext(s)[0] for s in part['scenes'])}; all faces as "
             f"triangles, {whole(part['rows'][0]['pixels'])} pixels a method and format, rays of all kinds counted, one "
             "thread, shading included.",
             "A pixel is wrong if, at the first ray on which method and exact reference part, the method answers wrongly by "
             "its own contract, or takes hits in the wrong order. Not counted: pixels that part only because a secondary ray "
             f"starts elsewhere (at most {whole(starts)} of a method), or where the contract owes nothing.",
             f"Drawn without a bar of time, being slow, timed once or too seldom: {numbers_text(numbers[m] for m in once)}."
             if once else ""]
    two_panels(record, rows, "Wrong pixels against rays a second", "share of wrong pixels", "rays a second", big, notes, out,
               better_left=False)


def leaks(record, out):
    part = record.get("leaks", {"rows": []})
    time = {r["method"]: r["nanoseconds"]["ratio"] for r in record["speed"]
            if r["probe"] == "ray" and r["call"] == "single" and r["percent_hits"] == 7 and not r.get("nothing")}
    rows = {fmt: [{**r, **interval(time[r["method"]]), "n": r["rays"], "wrong": r["leaks"]} for r in part["rows"]
                  if r["fmt"] == fmt and r["method"] in time] for fmt in FORMATS}
    if not part["rows"]:
        return
    n = max(r["rays"] for r in part["rows"])
    repetitions = max(r["nanoseconds"]["repetitions"] for r in record["speed"])
    notes = [bars_note(repetitions),
             f"{part['mesh']}, {whole(n)} rays of each format at its vertices, edges and faces. A ray leaks if it passes through "
             "the surface, and no face is reported there.",
             f"Time: of random rays and triangles, 7 % hits, in binary64; 1 = {record['yardstick']} in the same run.",
             f"None of {whole(n)} leaves at most {1e6 * (1 - 0.05 ** (1 / n)):.2g} per million (95 %, one-sided)."]
    two_panels(record, rows, "Leaks against time", "leaks per million rays",
               f"time per test of a ray, as a multiple of {record['yardstick']}'s", lambda t: f"{t:g}×", notes, out,
               name_y=lambda share: big(1e6 * share), unit=1)


# --- time by the share of hits -------------------------------------------------------------------------------------

HIT_MARKS = {0: ("o", "white"), 7: ("s", "#222222"), 50: ("^", "#9A9A9A"), 100: ("D", "white")}


def nanoseconds(x):
    return f"{x:g} ns" if x < 1000 else f"{x / 1000:g} µs"


def draw_lines(ax, order, lines):
    for y, key in enumerate(order):
        spans = lines.get(key)
        if y % 2:
            ax.axhspan(y - 0.5, y + 0.5, color="#F4F4F4", lw=0, zorder=0)
        if not spans:
            ax.text(0.5, y, "not taken", transform=ax.get_yaxis_transform(), va="center", ha="center", color=FAINT)
            continue
        middles = [t["median"] for t in spans.values()]
        ax.plot([min(middles), max(middles)], [y, y], color="#B0B0B0", lw=0.6, zorder=1)
        for hits, t in spans.items():
            shape, fill = HIT_MARKS[hits]
            ax.plot([t["lower_quartile"], t["upper_quartile"]], [y, y], color=INK, lw=0.7, zorder=2)
            ax.plot([t["median"]], [y], shape, ms=3, mfc=fill, mec=INK, mew=0.6, zorder=3)


def speed(record, out):
    """Segments beside rays; the quickest about segments at 7 % hits on top, tests that do nothing below all."""
    set_up = {r["method"]: r["nanoseconds"]["median"] for r in record["speed"] if r["call"] == "set-up"}
    idle = {r["method"] for r in record["speed"] if r.get("nothing")}
    lines = {"segment": {}, "ray": {}}
    for r in (r for r in record["speed"] if r["call"] != "set-up"):
        lines[r["probe"]].setdefault((r["method"], r["call"]), {})[r["percent_hits"]] = r["nanoseconds"]
    both = {**lines["ray"], **lines["segment"]}
    order = sorted(both, key=lambda k: (k[0] not in idle, -both[k][7]["median"]))
    names = [shortened(m if call == "single" else f"{m}, {call}", 30) for m, call in order]
    notes = ["Random segments, or rays, and triangles of the unit cube, 53-bit coordinates, "
             f"{whole(record['speed_pairs'])} pairs; each test in a loop that was compiled around it. Mark: the median of nanoseconds a test; bar: its quartiles."]
    if set_up:
        notes.append("To prepare a triangle takes, in ns: "
                     + ", ".join(f"{shortened(m)} {t:.0f}" for m, t in set_up.items()) + ".")
    text = [line for note in notes + [machine(record)] for line in wrapped(note)]
    left = 0.1 + max(width_of(n) for n in names)
    tall, width = 0.112 * len(order) + 0.05, (WIDTH - left - RIGHT - GAP) / 2
    sheet = Sheet(0.45 + tall + 0.42 + LINE * len(text) + 0.1)
    sheet.text(0.05, 0.05, "What a test costs, by the share of hits", 7.6, fontweight="bold")
    times = [t for own in lines.values() for spans in own.values() for t in spans.values()]
    for i, (probe, title) in enumerate((("segment", "segments"), ("ray", "rays"))):
        ax = sheet.axes(left + i * (width + GAP), 0.4, width, tall)
        draw_lines(ax, order, lines[probe])
        low, high = min(t["lower_quartile"] for t in times) / 1.4, max(t["upper_quartile"] for t in times) * 1.5
        ticks = [t for t in decades(low, high) if f"{t:e}"[0] == "1"]
        ax.set(xscale="log", xlim=(low, high), ylim=(-0.6, len(order) - 0.4))
        ax.set_xticks(ticks, [nanoseconds(t) for t in ticks])
        ax.set_xticks([], minor=True)
        ax.set_yticks(range(len(order)), names if i == 0 else [""] * len(order))
        ax.tick_params(left=False)
        for t in ticks:
            ax.axvline(t, color=PALE, lw=0.4, zorder=0)
        ax.text(0, 1 + 0.04 / tall, title, transform=ax.transAxes, fontweight="bold", va="bottom")
    handles = [Line2D([], [], ls="", marker=m, mfc=f, mec=INK, mew=0.6, ms=3, label=f"{p} % hit")
               for p, (m, f) in HIT_MARKS.items()]
    sheet.figure.legend(handles=handles, loc="center", bbox_to_anchor=(0.5, 1 - (0.4 + tall + 0.26) / sheet.height), ncol=4,
                        frameon=False, fontsize=SMALL, handletextpad=0.1, columnspacing=1)
    for i, line in enumerate(text):
        sheet.text(0.05, 0.4 + tall + 0.36 + i * LINE, line, color="#444444")
    sheet.save(out)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__.splitlines()[0])
    with open(sys.argv[1], encoding="utf-8") as file:
        record = json.load(file)

    def out(name):
        return os.path.join(sys.argv[2], name)

    speed_accuracy(record, "main", "What being right costs", out("speed-accuracy"))
    speed_accuracy(record, "shares", "Wrong answers against time, by the share of hits", out("speed-accuracy-shares"))
    speed_accuracy(record, "polygons", "Polygons: wrong answers against time", out("speed-accuracy-polygons"))
    pictures(record, out("pictures"))
    leaks(record, out("leaks"))
    speed(record, out("speed"))


if __name__ == "__main__":
    main()
