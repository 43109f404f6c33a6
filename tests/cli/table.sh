#!/usr/bin/env bash
# The table of methods of docs/results.md, made of small real outputs: its figures are those of the files.
source "$(dirname "$0")/common.bash"
cd "$scratch"

methods=mt-double,mt-float,sf-filtered
expect 0 chart --method $methods --count 600 --repetitions 9 --threads 1 --out chart
expect 1 fuzz --method $methods --count 24000 --threads 2 --keep 40 --out fuzz
says out 'errors of numbers in ulps' && says fuzz/summary.json '"one_case_in": 16'
cat >tetrahedron.off <<'MESH'
OFF
4 4 0
0 0 0
4 0 1
1 4 0
0 1 4
3 0 2 1
3 0 1 3
3 1 2 3
3 0 3 2
MESH
expect 1 leak tetrahedron.off --rays 400 --method mt-float,mt-double,sf-filtered --out leak
table=("$SOURCE_DIR/docs/table_of_methods.py" --chart chart --fuzz fuzz --leak leak)
/usr/bin/python3 "${table[@]}" >table.md

/usr/bin/python3 - <<'PYTHON'
import json

lines = open("table.md", encoding="utf-8").read().splitlines()
head = [c.strip() for c in lines[2].strip("|").split("|")]
rows = [dict(zip(head, (c.strip() for c in line.strip("|").split("|")))) for line in lines[4:]]
assert {(r["method"], r["cases"]) for r in rows} == {
    (f"`{m}`", f"{p}, {f}") for p in ("segment", "ray")
    for m, f in [("mt-double", "binary64"), ("mt-double", "binary32"), ("mt-float", "binary32"),
                 ("sf-filtered", "binary64"), ("sf-filtered", "binary32")]}, rows
fuzz = json.load(open("fuzz/summary.json"))
leak = json.load(open("leak/summary.json"))
for r in rows:
    method, (probe, fmt) = r["method"].strip("`"), r["cases"].split(", ")
    mine = [c for c in fuzz["counts"] if c["method"] == method and c["fmt"] == fmt and (c["class"][0] == "R") == (probe == "ray")]
    judged = sum(c["asked"] - c["unsupported"] for c in mine)
    assert r["judged"] == str(judged)
    wrong = 0
    for outcome in ("false hit", "false miss", "wrong contact"):
        n = sum(c.get("outcomes", {}).get(outcome, 0) for c in mine)
        wrong += n
        assert abs(float(r[outcome + " ‰"]) - 1000 * n / judged) <= 0.005 * 1000 * n / judged, (r, outcome)
    assert (r["smallest witness"] == "–") == (wrong == 0), r
    assert (method == "sf-filtered") == (wrong == 0), r
    if probe == "segment":
        assert r["t, ulps"] == "–" and r["leaks /10⁶"] == "–"
        assert float(r["ns"]) > 0
        continue
    found = [s["all"]["leak"] for t in leak["trials"] if t["fmt"] == fmt for s in t["subjects"] if s["name"] == method]
    assert r["leaks /10⁶"] == (f"{1e6 * found[0] / 400:.0f}" if found else "–"), r
    most = max(e["t"].get("most", 0) for e in fuzz["errors"]["counts"]
               if e["method"] == method and e["fmt"] == fmt and "t" in e)
    assert r["t, ulps"].split(" / ")[2] == f"{most:.3g}", r
    assert (method == "sf-filtered") == (float(r["t, ulps"].split(" / ")[2]) <= 0.5), r
PYTHON

# A figure that changes in a file changes in the table, and a missing file is no table.
sed -i '0,/"false miss": [1-9][0-9]*/s//"false miss": 7777/' fuzz/summary.json
/usr/bin/python3 "${table[@]}" >changed.md
! cmp -s table.md changed.md || { echo "the table does not read what fuzz counted" >&2; exit 1; }
rm leak/summary.json
! /usr/bin/python3 "${table[@]}" >none.md 2>err || { echo "a table without leaks" >&2; exit 1; }
