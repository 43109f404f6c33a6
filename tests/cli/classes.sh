#!/usr/bin/env bash
# classify on the representatives of all 163 classes: hit and class by every exact kernel, degenerate operands included.
set -euo pipefail
cd "$SOURCE_DIR"
"$TRIBUNAL" classify --method sf-rational,sf-filtered,sf-epeck,sf-epick,sf-expansion --in data/cases/classes163.jsonl | /usr/bin/python3 -c '
import json, sys
expected = {c["id"]: c for c in map(json.loads, open("data/cases/classes163.jsonl"))}
answers = [json.loads(line) for line in sys.stdin]
for a in answers:
    case = expected[a["id"]]
    assert (a["status"], a["hit"], a["class"]) == ("ok", case["expect"], case["class"]), a
assert len(answers) == 5 * 163, len(answers)
print(len(answers), "answers right")'
