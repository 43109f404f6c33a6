#!/usr/bin/env bash
# The checker of docs/ confirms what fuzz finds, and rejects a counterexample that blames the wrong answer.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0
"$TRIBUNAL" fuzz --method sf-double,mt-float --count 20000 --out "$scratch" >/dev/null || status=$?
[ "$status" -eq 1 ] || { echo "fuzz: exit $status, expected 1" >&2; exit 1; }
/usr/bin/python3 "$SOURCE_DIR/docs/check_counterexample.py" "$scratch/counterexamples.jsonl"
sed '1s/"answered":0/"answered":2/;1s/"answered":1/"answered":0/;1s/"answered":2/"answered":1/' "$scratch/counterexamples.jsonl" >"$scratch/tampered.jsonl"
! /usr/bin/python3 "$SOURCE_DIR/docs/check_counterexample.py" "$scratch/tampered.jsonl" || { echo "tampering passed" >&2; exit 1; }
sed '1s/"abcp":[-01]*/"abcp":7/' "$scratch/counterexamples.jsonl" >"$scratch/signs.jsonl"
! /usr/bin/python3 "$SOURCE_DIR/docs/check_counterexample.py" "$scratch/signs.jsonl" || { echo "a wrong sign passed" >&2; exit 1; }
