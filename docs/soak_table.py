#!/usr/bin/python3
"""What `./run soak` tried, as JSON and as a table.

  soak_table.py add SOAK.json NAME LOG EXIT SECONDS REVISION   the row of one script, from the last line of its log
  soak_table.py show SOAK.json NAME…                           these rows as a table; exit code 1 where anything broke
  soak_table.py write SOAK.json PAGE SCRIPTS NAME…             puts these rows into the table of a page, between its markers;
                                                               rows of other scripts stay while the script is in SCRIPTS
"""
import json
import os
import re
import sys

CLOSING = re.compile(r"^tried ([0-9,]+), broke ([0-9,]+): (\S.*)$")
BEGIN, END = "<!-- The table is written by ./run soak --write -->", "<!-- End of the table -->"
HEAD = ["script", "what was tried", "how often", "how often it broke", "wall clock", "revision"]


def rows_of(path):
    if not os.path.exists(path):
        return {}
    with open(path, encoding="utf-8") as file:
        return {row["name"]: row for row in json.load(file)["rows"]}


def replace(path, text):
    with open(path + ".tmp", "w", encoding="utf-8") as file:
        file.write(text)
    os.replace(path + ".tmp", path)


def row_of(name, log, status, seconds, revision):
    """A script that ends otherwise than with 0, without its closing line or having tried nothing, is broken."""
    with open(log, encoding="utf-8", errors="replace") as file:
        lines = [line for line in file.read().split("\n") if line]
    closing = CLOSING.match(lines[-1]) if lines else None
    tried, broke = (int(closing[i].replace(",", "")) if closing else 0 for i in (1, 2))
    what = closing[3] if closing else "ended without its closing line"
    whole = status == 0 and closing is not None and tried > 0 and broke == 0
    return {"name": name, "what": what, "tried": tried, "broke": broke, "exit": status, "whole": whole,
            "seconds": round(seconds, 1), "shortened_to": os.environ.get("TRIBUNAL_SOAK_SECONDS") or None,
            "revision": revision}


def clock(seconds):
    seconds = round(seconds)
    if seconds < 60:
        return f"{seconds} s"
    if seconds < 5400:
        return f"{seconds // 60} min {seconds % 60:02} s"
    return f"{seconds // 3600} h {seconds % 3600 // 60:02} min"


def cells(row):
    broke = f"{row['broke']:,}"
    if not row["whole"] and row["broke"] == 0:
        broke += f" (exit {row['exit']}: unfinished)"
    took = clock(row["seconds"]) + (" (shortened)" if row["shortened_to"] else "")
    return [f"`{row['name']}`", row["what"].replace("|", "\\|"), f"{row['tried']:,}", broke, took, f"`{row['revision']}`"]


def line(texts):
    return "| " + " | ".join(texts) + " |"


def add(path, name, log, status, seconds, revision):
    rows = rows_of(path)
    rows[name] = row_of(name, log, int(status), float(seconds), revision)
    replace(path, json.dumps({"rows": [rows[key] for key in sorted(rows)]}, indent=1) + "\n")
    return 0


def show(path, *names):
    rows = [rows_of(path)[name] for name in names]
    table = [HEAD] + [[cell.replace("`", "") for cell in cells(row)] for row in rows]
    widths = [max(len(texts[i]) for texts in table) for i in range(len(HEAD))]
    for texts in table:
        print("  ".join(text.ljust(width) for text, width in zip(texts, widths)).rstrip())
    return 0 if all(row["whole"] for row in rows) else 1


def write(path, page, scripts, *names):
    with open(page, encoding="utf-8") as file:
        before, rest = file.read().split(BEGIN)
    table, after = rest.split(END)
    kept = {m[1]: m[0] for m in re.finditer(r"^\| `([^`]+)` .*$", table, re.M)}
    kept |= {name: line(cells(rows_of(path)[name])) for name in names}
    lines = [line(HEAD), line(["---"] * len(HEAD))]
    lines += [kept[name] for name in sorted(kept) if os.path.exists(os.path.join(scripts, name + ".sh"))]
    replace(page, before + BEGIN + "\n\n" + "\n".join(lines) + "\n\n" + END + after)
    return 0


if __name__ == "__main__":
    commands = {"add": add, "show": show, "write": write}
    if len(sys.argv) < 4 or sys.argv[1] not in commands:
        sys.exit(__doc__)
    sys.exit(commands[sys.argv[1]](*sys.argv[2:]))
