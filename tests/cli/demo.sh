#!/usr/bin/env bash
# The whole tour from another folder's point of view: one page of what six commands wrote, which needs nothing else.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$SOURCE_DIR"

# What an earlier demo left is removed, and what it did not write stays. A demo that is interrupted leaves no old page to open.
mkdir -p "$scratch/out/fuzz/old" "$scratch/out/mine" && echo old >"$scratch/out/index.html"
echo '{"counts":[],"methods":[],"classes_judged":{}}' | tee "$scratch/out/fuzz/old/summary.json" >"$scratch/out/mine/summary.json"
status=0
timeout --foreground --preserve-status -s INT 1 "$TRIBUNAL" demo --out "$scratch/out" >"$scratch/log" 2>"$scratch/err" || status=$?
[ "$status" -eq 130 ] || { echo "exit $status of an interrupted demo" >&2; cat "$scratch/log" "$scratch/err" >&2; exit 1; }
[ ! -e "$scratch/out/index.html" ]
[ ! -e "$scratch/out/fuzz/old" ]
[ -e "$scratch/out/mine/summary.json" ]
if grep '^Open ' "$scratch/log"; then exit 1; fi

"$TRIBUNAL" demo --out "$scratch/out" >"$scratch/log"
grep -qxF "Open $scratch/out/index.html" "$scratch/log"

# Fuzz, certify, sweep, render, chart, then report over their directories, and nothing else.
grep '^\$ tribunal' "$scratch/log" | cut -d' ' -f3 | uniq | paste -sd' ' >"$scratch/commands"
echo 'fuzz certify sweep render chart report' | diff - "$scratch/commands"

"${PYTHON:-python3}" - "$scratch/out" "$TRIBUNAL" <<'EOF'
import json, re, subprocess, sys
out, program = sys.argv[1:]
page = open(f"{out}/index.html", encoding="utf-8").read()
assert not re.search(r'(src|href)="?https?:', page), "the page needs the network"
data = json.loads(re.search(r'id="tribunal-data">(.*?)</script>', page, re.S).group(1))
kinds = [run["kind"] for run in data["runs"]]
for kind in ("fuzz", "certificate", "sweep", "map", "render", "chart"):
    assert kind in kinds, kinds
certified = next(name for name, m in data["methods"].items() if m["exact"] and name in data["runs"][0]["methods"])
for kind in ("fuzz", "certificate", "sweep", "map", "render", "chart"):
    assert any(certified in run["methods"] for run in data["runs"] if run["kind"] == kind), f"{certified} is not on trial in {kind}"
exact = [line for line in data["verdicts"] if data["methods"][line["method"]]["exact"]]
assert exact and all(line["wrong"] == 0 and line["level"] in ("nothing", "pictures") for line in exact), exact
assert data["verdicts"][0]["wrong"] > 0 and data["verdicts"][0]["case"] is not None

# What two pictures differ in for another reason than a wrong answer is not blamed on a method.
for run in data["runs"]:
    if run["kind"] == "render":
        blame = run["verdict_pixels"]
        assert blame["against"] == 0 and sum(blame.values()) == run["record"]["difference"]["pixels"], blame

# One wrong answer whole: the first verdict's case replays, and its method is wrong.
shown = data["cases"][data["verdicts"][0]["case"]]
open(f"{out}/one.jsonl", "w").write(json.dumps(shown["case"]) + "\n")
said = subprocess.run([program, "replay", f"{out}/one.jsonl"], capture_output=True, text=True)
assert said.returncode == 1 and re.search(rf"^  {shown['method']} .*WRONG", said.stdout, re.M), said.stdout
EOF

