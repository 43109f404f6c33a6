#!/usr/bin/env bash
# Every call that touches a file fails once, in runs of three commands that write; tests/soak/output_faults.sh has all.
. "$SOURCE_DIR/tests/cli/common.bash"
cd "$scratch"
. "$SOURCE_DIR/tests/faults/loop.bash"
"$TRIBUNAL" cases --count 20 --family affine --out cases.jsonl
mkdir old && echo old >old/answers.jsonl && ln -s old link
fail_each 28 ENOSPC old classify --method mt-float --in cases.jsonl --out out/answers.jsonl

# Findings of a run whose results cannot be written are kept.
between() { grep -qF '"record":"end"' out/checkpoint.jsonl && [ "$(tree out | grep -v /checkpoint)" = "$([ ! -e out/summary.json ] || echo "$after")" ]; }
mkdir found && for file in summary.json counterexamples.jsonl mine; do echo old >found/$file; done
fail_each 5 EIO none fuzz --method mt-float --count 2000 --family affine --out out
between() { grep -qF '"record":"end"' out/checkpoint.jsonl && [ "$(tree out | grep -v /checkpoint)" = "$([ ! -e out/summary.json ] && tree out | grep /mine || echo "$after")" ]; }
fail_each 5 EIO found fuzz --method mt-float --count 2000 --family affine --out out
between() { false; }
FAIL_SHORT=1 fail_each 5 short none fuzz --method mt-float --count 2000 --family affine --out out

# The record is sound by itself, if its figures are missing: none of another record stands beside it.
between() { [ ! -e out/thresholds.svg ] && [ "$(grep -c '' <(tree out))" -ge 3 ] && [ -z "$(comm -13 <(echo "$after") <(tree out) | grep -v plot.log)" ]; }
mkdir swept
"$TRIBUNAL" sweep --method mt-float --axis scale --count 32 --seed 2 --out swept >out.txt || true
fail_each 5 EIO swept sweep --method mt-float --axis scale --count 32 --out out
echo "tried $tried, broke $broken"
[ "$broken" -eq 0 ]
