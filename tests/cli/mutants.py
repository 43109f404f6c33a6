#!/usr/bin/env python3
"""mutants.py FILE OUT [--seed S] [--count N] [--chained] [--page] -- COMMAND…

Writes to OUT one damaged copy of FILE (JSON Lines, or one JSON value) after the other, and runs COMMAND each time. One
field is changed in one way: removed, null, of another type, negative, huge, nested, named twice, not a number, exchanged
with its neighbour; or a line is removed, repeated or exchanged. With --chained the chain of hashes is made anew, as a
forger would. COMMAND must end with 0, 1, 2, 3 or 8 within ten seconds; where it ends with 2 or 3 it says why in one
line; and no figure that it prints is larger than any that FILE could hold, unless a coordinate was made so: those are
free. With --page it prints the JSON of a page: what the views read of it is there and of the type that it has of FILE as
it was, no figure is negative that was not, and none is larger than FILE could hold. Prints what broke, and counts.
"""
import argparse
import hashlib
import json
import random
import re
import subprocess
import sys

COORDINATES = {"seg", "ray", "tri", "rings", "base", "unit"}
ON_AXES = {"value", "values", "easiest", "stress"}  # of any sign too
# Totals and measurements that nothing else in a record bounds; of a page they may be any that are no less than 0.
UNBOUNDED = {"seed", "cases", "rays", "faces", "polygons", "size", "speed_pairs", "batch", "stretches", "repetitions",
             "bytes", "max", "upper_quartile", "rays_per_second", "n", "asked", "broken", "value", "values", "easiest",
             "face", "most", "most_at", "worst_t_ulps", "made_with", "environment"}
# Work that was done while a picture was made, which no view shows.
NOT_SHOWN = {("record", "methods"), ("record", "solids")}
# What the views of each kind of run read without asking whether it is there.
READ = {
    "chart": ["record.rows", "record.panels", "record.methods"],
    "map": ["record.panels", "record.panels.*.pixels", "record.map"],
    "leak": ["record.trials", "record.trials.*.subjects", "record.trials.*.fmt", "record.trials.*.rays"],
    "render": ["record.pixels.rows", "record.width", "record.height", "record.difference.method"],
    "sweep": ["record.axes.*.name", "record.axes.*.quantity", "record.rows.rows"],
    "certificate": ["record.verdict", "record.method", "record.sampled.rows"],
    "fuzz": ["counts.rows", "totals.rows", "methods"],
}
VERDICTS = {"not refuted", "refuted", "incomplete"}
HUGE = [2**31, 2**32, 2**53, 2**53 + 1, 2**63, 2**64 - 1, 2**64, 10**30]


class Raw(str):
    """Text that is written into the JSON as it stands."""


def dumps(value):
    if isinstance(value, Raw):
        return str(value)
    if isinstance(value, dict):
        return "{" + ",".join(json.dumps(k, ensure_ascii=False) + ":" + dumps(v) for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ",".join(map(dumps, value)) + "]"
    return json.dumps(value, ensure_ascii=False, separators=(",", ":"))


def paths(value, path=()):
    """Every field: each member of each object and each element of each array."""
    members = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in members:
        yield path + (key,)
        yield from paths(inner, path + (key,))


def holder(value, path):
    for key in path[:-1]:
        value = value[key]
    return value, path[-1]


def replaced(new):
    def change(at, key):
        at[key] = new(at[key]) if callable(new) else new

    return change


def removed(at, key):
    del at[key]


def exchanged(at, key):
    keys = list(at.keys()) if isinstance(at, dict) else list(range(len(at)))
    other = keys[(keys.index(key) + 1) % len(keys)]
    at[key], at[other] = at[other], at[key]


def renamed(at, key):
    if isinstance(at, dict):
        at[key + "?"] = at.pop(key)
    else:
        at.insert(key, at[key])


def named_twice(at, key):
    if isinstance(at, dict):
        at[key] = Raw(dumps(at[key]) + "," + json.dumps(key) + ":" + dumps(at[key]))
    else:
        at[key] = Raw("")


CHANGES = {
    "removed": removed,
    "null": replaced(None),
    "true": replaced(True),
    "text": replaced("somebody else's"),
    "empty text": replaced(""),
    "number": replaced(7),
    "negative": replaced(-1),
    "half": replaced(0.5),
    "more by one": replaced(lambda v: v + 1 if isinstance(v, int) and not isinstance(v, bool) else [v]),
    "array": replaced([]),
    "object": replaced({}),
    "nested": replaced(lambda v: {"a": [v]}),
    "exchanged": exchanged,
    "renamed": renamed,
    "named twice": named_twice,
    "not a number": replaced(Raw("NaN")),
    "infinite": replaced(Raw("1e999")),
    **{str(n): replaced(n) for n in HUGE},
}


def sealed(records):
    text, head = [], "0" * 64
    for record in records + [{"record": "end", "records": len(records)}]:
        line = dumps(record)
        head = hashlib.sha256((head + line).encode()).hexdigest()
        text.append(line[:-1] + ("," if len(line) > 2 else "") + '"sha256":"' + head + '"}\n')
    return "".join(text)


def read(text, chained):
    try:
        return [json.loads(text)], False
    except ValueError:
        records = [json.loads(line) for line in text.splitlines()]
    if chained:
        for record in records:
            del record["sha256"]
        records.pop()
    return records, True


def mutants(records, lines, draw, count):
    """(what, path, records) of so many fields and ways, drawn; lines too, which have no path."""
    fields = [(i, path) for i, record in enumerate(records) for path in paths(record)]
    # Records of one kind have many fields alike: each kind of field is drawn as often.
    kinds = {}
    for i, path in fields:
        record = records[i]
        kind = (record.get("record") if isinstance(record, dict) else None,) + tuple(
            k if isinstance(k, str) else 0 for k in path)
        kinds.setdefault(kind, []).append((i, path))
    for _ in range(count):
        if lines and draw.random() < 0.08:
            i = draw.randrange(len(records))
            way = draw.choice(["removed", "repeated", "exchanged"])
            copy = list(records)
            if way == "removed":
                del copy[i]
            elif way == "repeated":
                copy.insert(i, copy[i])
            else:
                j = (i + 1) % len(copy)
                copy[i], copy[j] = copy[j], copy[i]
            yield f"line {i + 1} {way}", (), copy
            continue
        i, path = draw.choice(kinds[draw.choice(list(kinds))])
        way = draw.choice(list(CHANGES))
        copy = list(records)
        copy[i] = json.loads(json.dumps(records[i]))
        CHANGES[way](*holder(copy[i], path))
        yield f"line {i + 1}, {'.'.join(map(str, path))}: {way}", path, copy


def largest(text):
    return max((int(n) for n in re.findall(r"(?<![0-9a-fx.])\d{1,25}(?![0-9a-f])", text)), default=0)


def kind_of(value):
    return "number" if isinstance(value, (int, float)) and not isinstance(value, bool) else type(value).__name__


def leaves(value, path=()):
    """Every value with its path, in which places of arrays are stars."""
    yield path, value
    for key, inner in value.items() if isinstance(value, dict) else ():
        yield from leaves(inner, path + (key,))
    for inner in value if isinstance(value, list) else ():
        yield from leaves(inner, path + ("*",))


def at(value, path):
    """The values at a path, or None where there is none."""
    if not path:
        return [value]
    if path[0] == "*":
        return [x for inner in value for x in at(inner, path[1:])] if isinstance(value, list) else [None]
    return at(value[path[0]], path[1:]) if isinstance(value, dict) and path[0] in value else [None]


class Page:
    """The JSON of the page of a sound record, which those of damaged ones are held to."""

    def __init__(self, text, most):
        self.kinds, self.negative, self.most = {}, set(), most
        for path, value in leaves(json.loads(text)):
            self.kinds.setdefault(path, set()).add(kind_of(value))
            if kind_of(value) == "number":
                self.most = max(self.most, value)
                if value < 0:
                    self.negative.add(path)

    def wrong(self, text, unbounded):
        page = json.loads(text)
        for run in page["runs"]:
            for path in READ.get(run["kind"], []):
                if None in at(run, path.split(".")):
                    return f"a page without {path}"
            if run["kind"] == "certificate" and run["record"]["verdict"] not in VERDICTS:
                return f"a verdict {run['record']['verdict']!r}"
        for path, value in leaves(page):
            if any(path[2:4] == hidden for hidden in NOT_SHOWN):
                continue
            kind = kind_of(value)
            free = not COORDINATES.isdisjoint(path)  # of any sign, numbers or hex floats
            if path in self.kinds and not free and kind not in self.kinds[path] | {"NoneType"}:
                return f"{kind} at {'.'.join(path)}, where the sound page has {sorted(self.kinds[path])}"
            if kind != "number":
                continue
            if value != value or value in (float("inf"), float("-inf")):
                return f"{value} at {'.'.join(path)}"
            if value < 0 and path not in self.negative and not free and ON_AXES.isdisjoint(path):
                return f"{value} at {'.'.join(path)}"
            if value > self.most and not unbounded:
                return f"{value} at {'.'.join(path)}, where {self.most} is the most"
        return ""


def judge(run, most, page, unbounded):
    """What is wrong with how the command ended; empty if nothing is."""
    if run.returncode not in (0, 1, 2, 3, 8):
        return f"ended with {run.returncode}: {run.stderr[-300:]}"
    if re.search(r"unexpected:|json\.exception", run.stderr):  # what ends a program that was not prepared
        return run.stderr[-300:]
    if run.returncode in (2, 3):
        if len(run.stderr.splitlines()) != 1:
            return f"{run.returncode}, and not one line: {run.stderr[-300:]}"
        return ""
    if page is not None:
        return page.wrong(run.stdout, unbounded)
    figure = largest(run.stdout)
    return f"a figure of {figure}: {run.stdout[:400]}" if figure > most else ""


def main():
    cut = sys.argv.index("--")
    command = sys.argv[cut + 1:]
    parser = argparse.ArgumentParser()
    parser.add_argument("file")
    parser.add_argument("out")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--chained", action="store_true")
    parser.add_argument("--page", action="store_true")
    args = parser.parse_args(sys.argv[1:cut])
    text = open(args.file, encoding="utf-8").read()
    records, lines = read(text, args.chained)
    whole = (lambda r: sealed(r)) if args.chained else (lambda r: "".join(dumps(x) + "\n" for x in r))
    if args.chained and sealed(records) != text:
        sys.exit("mutants.py: the file, sealed anew, has other bytes")
    if not lines:
        whole = lambda r: dumps(r[0])
    most = max(largest(text), 10**7)
    tried, broke, ends = 0, 0, {}
    page = None
    if args.page:
        with open(args.out, "w", encoding="utf-8") as file:
            file.write(text)
        page = Page(subprocess.run(command, capture_output=True, text=True, check=True).stdout, most)
    for what, path, mutant in mutants(records, lines, random.Random(args.seed), args.count):
        with open(args.out, "w", encoding="utf-8") as file:
            file.write(whole(mutant))
        tried += 1
        try:
            run = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=10)
            of_coordinate = not COORDINATES.isdisjoint(path)
            unbounded = of_coordinate or not UNBOUNDED.isdisjoint(path)
            wrong = judge(run, float("inf") if of_coordinate else most, page, unbounded)
            ends[run.returncode] = ends.get(run.returncode, 0) + 1
        except subprocess.TimeoutExpired:
            wrong = "did not end in ten seconds"
        if wrong:
            broke += 1
            print(f"{what}: {wrong}")
    print(f"tried {tried}, broke {broke}: {args.file}, ends {dict(sorted(ends.items()))}")
    if 3 not in ends:
        sys.exit("mutants.py: nothing was refused: the damage is never seen")
    sys.exit(1 if broke else 0)


main()
