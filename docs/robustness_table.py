#!/usr/bin/python3
"""Wrong hits and misses by kind of contact, in Markdown: docs/robustness_table.py FUZZ METHOD…

FUZZ is what `tribunal fuzz --out FUZZ` wrote. One row a kind of contact, from data/classes163.tsv and data/ray_classes.tsv; binary64
cases of all families; per mille of the judged cases. Wrong contacts are not counted: only some methods tell the contact.
"""
import collections
import csv
import json
import pathlib
import sys

KINDS = ["passes by", "crosses inside", "meets an edge", "meets a vertex", "ends on the triangle", "runs in the plane",
         "degenerate operands"]
DATA = pathlib.Path(__file__).resolve().parent.parent / "data"


def kind_of(row):
    if row["triangle"] != "tri" or row["probe"] == "pt":
        return "degenerate operands"
    if row["rank"] != "4":
        return "runs in the plane"
    if row["intersection"] == "empty":
        return "passes by"
    end, part = row["touch"].split("/")
    return "ends on the triangle" if end != "int" else {"F": "crosses inside", "E": "meets an edge", "V": "meets a vertex"}[part]


def kinds_of_classes():
    kinds = {}
    for name, probe in (("classes163.tsv", "segment"), ("ray_classes.tsv", "ray")):
        with open(DATA / name, encoding="utf-8") as table:
            for row in csv.DictReader(table, delimiter="\t"):
                kinds[row["id"]] = kind_of({**row, "probe": row[probe], "touch": row["contact"]})
    return kinds


def main(directory, methods):
    kinds, sums = kinds_of_classes(), collections.Counter()
    for count in json.loads(pathlib.Path(directory, "summary.json").read_text(encoding="utf-8"))["counts"]:
        if count["fmt"] != "binary64":
            continue
        key = (kinds[count["class"]], count["method"])
        outcomes = count.get("outcomes", {})
        sums[key + ("judged",)] += count["asked"] - count["unsupported"]
        sums[key + ("false hit",)] += outcomes.get("false hit", 0)
        sums[key + ("false miss",)] += outcomes.get("false miss", 0)
    print("| false hits / false misses, ‰ | n | " + " | ".join(f"`{m}`" for m in methods) + " |")
    print("|---|---|" + "---|" * len(methods))
    for kind in KINDS:
        n = max(sums[kind, m, "judged"] for m in methods)
        cells = []
        for m in methods:
            judged = sums[kind, m, "judged"]
            cells.append("–" if judged == 0 else " / ".join(f"{1000 * sums[kind, m, o] / judged:.3g}" for o in ("false hit", "false miss")))
        print(f"| {kind} | {n:,} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
