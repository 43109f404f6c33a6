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
import json
import os
import sys
import traceback

sys.dont_write_bytecode = True
try:
    from plot_marks import (FAINT, FORMATS, INK, PALE, SMALL, WIDTH, Line2D, Methods, Scale, decades, draw_panel, dress_x,
                            percent, whole)
    from plot_sheet import GAP, LINE, RIGHT, Grid, Key, Sheet, machine, shortened, width_of, wrapped
except ImportError as missing:
    print(f"plot.py: no module {missing.name} (Debian: python3-matplotlib)", file=sys.stderr)
    sys.exit(69)  # script_lacks_module

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
        fmt = where[0]["fmt"]
        if where == [p for p in panels if p["fmt"] == fmt]:
            titles = [f"all panels of {fmt} cases"]
        if len(where) == len(panels):
            titles = ["all panels"]
        names = ", ".join(f"{n} {shortened(name)}" for name, n in methods.number.items() if n in missing)
        notes.append(f"Nothing to judge, so no mark, in {'; '.join(titles)}: {names}.")
    parts = [f"{title}: {number} on {' / '.join(dict.fromkeys(counts))}" for (title, number), counts in fewer.items()]
    if parts:
        notes.append("* judged on fewer cases, the rest being outside the contract: " + "; ".join(parts) + ".")
    return notes


def bars_note(repetitions, shares="of shares by Clopper and Pearson"):
    time = (f"of time for the median over {repetitions} repetitions, by ranks" if repetitions >= 6
            else "of time none, for want of repetitions")
    return (f"Bars are 95 % intervals: {time}; {shares}. Dashed: the frontier, than which nothing is both quicker and "
            "less often wrong. In the grey band nothing was wrong; heights in it mean nothing.")


def stretches_note(record):
    """What the clock's repetitions have in common."""
    times = [r["nanoseconds"] for r in record["rows"]]
    repetitions, stretches = (max(t[key] for t in times) for key in ("repetitions", "stretches"))
    batches = sorted({t["batch"] for t in times})
    asked = f"{whole(batches[0])} to {whole(batches[-1])}, the slower the fewer" if batches[1:] else whole(batches[0])
    took = (f"took {'other ones' if stretches == repetitions else f'one of {stretches} stretches'}" if stretches > 1
            else "took the same")
    return f"Cases in a repetition: {asked}; each repetition {took}."


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
    unit = f"1 = {record['yardstick']} in the same repetition" + (
        ", on random triangles; polygons are prepared." if figure == "polygons" else ", on pairs of the same population.")
    notes = [bars_note(repetitions), f"Time: {unit} {stretches_note(record)}",
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
    rows = {fmt: [{**r, **interval(r["rays_per_second"]), "n": r["pixels"], "lower": r["share"], "upper": r["share"]}
                  for r in part["rows"] if r["fmt"] == fmt] for fmt in FORMATS}
    if not part["rows"]:
        return
    once = sorted({r["method"] for r in part["rows"] if "lower" not in r["rays_per_second"]})
    numbers = Methods(record).number
    starts = max(r["other_start"] for r in part["rows"])
    notes = [bars_note(max(r["repetitions"] for r in part["rows"]),
                       "of shares none, since all pixels of these scenes are counted, none is drawn at random, and "
                       "neighbours are wrong together"),
             f"{len(part['scenes'])} scenes: {', '.join(os.path.splitext(s)[0] for s in part['scenes'])}; all faces as "
             f"triangles, {whole(part['rows'][0]['pixels'])} pixels a method and format, rays of all kinds counted, one "
             "thread, shading included.",
             "A pixel is wrong if, at the first ray on which method and exact reference part, the method answers wrongly "
             "by its own contract, or takes hits in the wrong order. Not counted: pixels that part only because a "
             f"secondary ray starts elsewhere (at most {whole(starts)} of a method), or where the contract owes nothing.",
             f"Drawn without a bar of time, being slow, timed once or too seldom: {numbers_text(numbers[m] for m in once)}."
             if once else ""]
    two_panels(record, rows, "Wrong pixels against rays a second", "share of wrong pixels", "rays a second", big, notes,
               out, better_left=False)


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
             f"{part['mesh']}, {whole(n)} rays of each format at its vertices, edges and faces. A ray leaks if it passes "
             "through the surface, and no face is reported there.",
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
             f"{whole(record['speed_pairs'])} pairs; each test in a loop that was compiled around it. "
             "Mark: the median of nanoseconds a test; bar: its quartiles."]
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
    try:
        main()
    except OSError:
        traceback.print_exc()
        sys.exit(74)  # script_cannot_write
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError):
        traceback.print_exc()
        sys.exit(65)  # script_refuses_record
