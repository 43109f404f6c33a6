#!/usr/bin/env python3
"""The table method × (time, bytes, set-up; wrong by outcome; leaks, parity; t in ulps; smallest witness) as Markdown.

    docs/table_of_methods.py --chart CHART_DIR --fuzz FUZZ_DIR [FUZZ_DIR…] --leak LEAK_DIR [--title TEXT]

Reads what `chart --out`, `fuzz --out` and `leak --out` wrote, and types no figure of its own. One row for each method, kind
of probe and format of the cases: nothing is added up across formats, nor segments with rays. Standard library only.
"""
import argparse
import json
import math
import os
import sys

OUTCOMES = ["false hit", "false miss", "wrong contact", "fault"]
TIMED_HITS = 7  # per cent of the pairs that are timed


def load(directory, name):
    with open(os.path.join(directory, name), encoding="utf-8") as file:
        return json.load(file)


def probe_of(slot):
    """Classes of segments are C001 to C163, of rays R001 to R165."""
    return "ray" if slot.startswith("R") else "segment"


class Row:
    """What fuzz counted for one method, probe and format."""

    def __init__(self):
        self.asked = self.unsupported = self.wrong = self.plain = 0
        self.by_outcome = dict.fromkeys(OUTCOMES, 0)

    def add(self, count):
        self.asked += count["asked"]
        self.unsupported += count["unsupported"]
        self.wrong += count["wrong"]
        for outcome, n in count.get("outcomes", {}).items():
            self.by_outcome[outcome] += n
        self.plain += count.get("severity", {}).get("plain", 0)

    @property
    def judged(self):
        return self.asked - self.unsupported


def rows_of(summaries):
    """(method, probe, fmt) → Row, in the order in which methods come."""
    rows = {}
    for summary in summaries:
        for count in summary["counts"]:
            key = (count["method"], probe_of(count["class"]), count["fmt"])
            rows.setdefault(key, Row()).add(count)
    return {key: row for key, row in rows.items() if row.judged > 0}


def add_histogram(to, ulps):
    """Errors of several families of one format, added up; the largest of the largest."""
    to["equal"] += ulps.get("equal", 0)
    for i, n in enumerate(ulps.get("up_to", [])):
        to["up_to"][i] += n
    to["most"] = max(to["most"], ulps.get("most", 0))


def errors_of(summaries, number):
    """(method, fmt) → histogram of the errors of `t` or `weights`."""
    errors = {}
    for summary in summaries:
        for row in summary.get("errors", {}).get("counts", []):
            if number not in row:
                continue
            empty = {"equal": 0, "up_to": [0] * 67, "most": 0}
            add_histogram(errors.setdefault((row["method"], row["fmt"]), empty), row[number])
    return errors


def bound_of(histogram, percent):
    """0, or the least of ½, 1, 2 … that so many of a hundred errors do not exceed."""
    n = histogram["equal"] + sum(histogram["up_to"])
    within = histogram["equal"]
    if within * 100 >= n * percent:
        return 0
    for i, count in enumerate(histogram["up_to"][:-1]):
        within += count
        if within * 100 >= n * percent:
            return math.ldexp(0.5, i)
    return math.inf


def ulps_cell(histogram):
    if histogram is None or histogram["equal"] + sum(histogram["up_to"]) == 0:
        return "–"
    return " / ".join(f"{x:.3g}" for x in (bound_of(histogram, 50), bound_of(histogram, 99), histogram["most"]))


def leaks_of(summary):
    """(method, fmt) → counts of all its rays."""
    return {(s["name"], trial["fmt"]): s["all"] for trial in summary["trials"] for s in trial["subjects"]}


def per_million(counts, outcome, of):
    if counts is None or outcome not in counts or counts.get(of, 0) == 0:
        return "–"
    return f"{1e6 * counts[outcome] / counts[of]:.0f}"


class Speed:
    """The chart's times; a row without a probe is about segments, or about triangles alone."""

    def __init__(self, chart):
        self.rows = chart["speed"]

    def find(self, method, probe, call):
        for row in self.rows:
            about = row.get("probe") or ("segment" if call != "set-up" else probe)
            if row["method"] == method and row["call"] == call and about == probe:
                if row["percent_hits"] in (TIMED_HITS, None):
                    return row
        return None

    def time(self, method, probe, call):
        row = self.find(method, probe, call)
        return "–" if row is None else f"{row['nanoseconds']['median']:.1f}"

    def size(self, method, probe):
        sizes = [r["bytes"] for c in ("prepared", "batch", "single") if (r := self.find(method, probe, c)) and r["bytes"]]
        return str(sizes[0]) if sizes else "–"


def number_text(x):
    """A coordinate as short as it can be: decimal, or hexadecimal as the file has it."""
    if isinstance(x, str):
        value = float.fromhex(x) if "0x" in x else float(x)
        decimal = f"{value:.17g}"
        return decimal if float(decimal) == value and len(decimal) <= len(x) else x
    return f"{x:.17g}"


def point_text(p):
    return "(" + ", ".join(number_text(x) for x in p) + ")"


def witness_text(case):
    if "ray" in case:
        probe = f"{point_text(case['ray']['o'])} → {point_text(case['ray']['d'])}"
    else:
        probe = "–".join(point_text(p) for p in case["seg"])
    return f"{probe}; {' '.join(point_text(p) for p in case['tri'])}"


def witnesses_of(directories):
    """(method, probe, fmt) → the shortest of the kept counterexamples of the worst severity, and that severity."""
    order = ["plain", "boundary", "extreme"]
    found = {}
    for directory in directories:
        with open(os.path.join(directory, "counterexamples.jsonl"), encoding="utf-8") as file:
            for case in map(json.loads, file):
                finding = case["finding"]
                key = (finding["method"], "ray" if "ray" in case else "segment", case.get("fmt", "binary64"))
                text = witness_text(case)
                rank = (order.index(finding["severity"]), len(text), text)
                if key not in found or rank < found[key]:
                    found[key] = rank
    return {key: f"{order[severity]}: {text}" for key, (severity, _, text) in found.items()}


def per_mille(n, of):
    return "0" if n == 0 else f"{1000 * n / of:.3g}"


def cells(key, row, speed, leaks, t, weights, witnesses):
    method, probe, fmt = key
    leak = leaks.get((method, fmt)) if probe == "ray" else None
    errors = [ulps_cell(e.get((method, fmt))) if probe == "ray" else "–" for e in (t, weights)]
    return [f"`{method}`", f"{probe}, {fmt}",
            speed.time(method, probe, "single"), speed.time(method, probe, "prepared"), speed.time(method, probe, "batch"),
            speed.size(method, probe), speed.time(method, probe, "set-up"),
            str(row.judged), per_mille(row.plain, row.judged),
            *(per_mille(row.by_outcome[o], row.judged) for o in OUTCOMES[:3]),
            per_million(leak, "leak", "rays"), per_million(leak, "parity", "parity_judged"), *errors,
            witnesses.get(key, "none kept" if row.wrong else "–")]


HEADINGS = ["method", "cases", "ns", "ns, prepared", "ns, batch", "bytes", "set-up, ns", "judged", "plain ‰", "false hit ‰",
            "false miss ‰", "wrong contact ‰", "leaks /10⁶", "parity /10⁶", "t, ulps", "weights, ulps", "smallest witness"]


def made_with(chart, summaries, leak):
    e = chart["environment"]
    facts = [f"{e[k]}" for k in ("processor", "compiler", "flags") if k in e]
    seeds = sorted({s["seed"] for s in summaries} | {chart["seed"], leak["seed"]})
    cases = sum(s["cases"] for s in summaries)
    rays = leak["trials"][0]["rays"]
    return (f"{'; '.join(facts)}. Seed {', '.join(map(str, seeds))}; {cases} cases of `fuzz`; {rays} rays a format at "
            f"{os.path.basename(leak['mesh'])}; times at {TIMED_HITS} % hits.")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--chart", required=True, help="what chart --out wrote")
    parser.add_argument("--fuzz", required=True, nargs="+", help="what fuzz --out wrote; one or more")
    parser.add_argument("--leak", required=True, help="what leak --out wrote")
    args = parser.parse_args()
    chart, leak = load(args.chart, "chart.json"), load(args.leak, "summary.json")
    summaries = [load(d, "summary.json") for d in args.fuzz]
    rows = rows_of(summaries)
    if not rows:
        sys.exit("table_of_methods: no method was judged")
    speed, leaks = Speed(chart), leaks_of(leak)
    t, weights = errors_of(summaries, "t"), errors_of(summaries, "weights")
    witnesses = witnesses_of(args.fuzz)
    print(made_with(chart, summaries, leak) + "\n")
    print("| " + " | ".join(HEADINGS) + " |")
    print("|" + "---|" * len(HEADINGS))
    for key, row in rows.items():
        print("| " + " | ".join(cells(key, row, speed, leaks, t, weights, witnesses)) + " |")


if __name__ == "__main__":
    main()
