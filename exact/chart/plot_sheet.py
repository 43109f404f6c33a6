"""The sheet that plot.py fills: a column of a paper wide, panels above, and below them a key and notes."""
import functools
import os

import matplotlib.pyplot as plt
from matplotlib.font_manager import findfont, get_font

from plot_marks import (ARITHMETIC, FAINT, FORMATS, INK, MAKERS, SMALL, WIDTH, arithmetic_of, draw_mark, place_labels)

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
        print("drawn", os.path.basename(name))


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
        heights = 0.34 + rows * (PANEL + 0.19) + 0.32
        self.sheet, self.key, self.below = Sheet(heights + key.height()), key, heights
        self.sheet.text(0.05, 0.05, title, 7.6, fontweight="bold")
        width = (WIDTH - LEFT - RIGHT - GAP) / 2
        self.axes = [[self.sheet.axes(LEFT + c * (width + GAP), 0.43 + r * (PANEL + 0.19), width, PANEL) for c in range(2)]
                     for r in range(rows)]
        for row in self.axes:
            row[1].tick_params(labelleft=False)
        for ax, fmt in zip(self.axes[0], FORMATS):
            ax.text(1, 1.035 + 0.1 / PANEL, fmt, transform=ax.transAxes, ha="right", va="bottom", color=FAINT)

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
