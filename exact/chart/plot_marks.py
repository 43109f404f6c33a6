"""What plot.py draws its figures of: marks, the places of their numbers, and panels with an axis of shares that has a band
for none."""
import math

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
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
        ax.plot([x], [y], marker="o", ms=1.5, mfc=colour, mec="none", ls="", zorder=5, clip_on=False,
                transform=more.get("transform", ax.transData))


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
