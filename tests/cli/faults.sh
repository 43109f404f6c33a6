#!/usr/bin/env bash
# Every call that touches a file fails once, in runs of three commands that write; tests/soak/output_faults.sh has all.
. "$SOURCE_DIR/tests/cli/common.bash"
cd "$scratch"
. "$SOURCE_DIR/tests/faults/loop.bash"
"$TRIBUNAL" cases --count 20 --family affine --out cases.jsonl
mkdir old && echo old >old/answers.jsonl && ln -s old link
fail_each 28 ENOSPC old classify --method mt-float --in cases.jsonl --out out/answers.jsonl
fail_each 5 EIO none fuzz --method mt-float --count 4000 --family affine --out out
"$TRIBUNAL" fuzz --method mt-double --count 4000 --family affine --out found >out.txt || [ $? -eq 1 ]
fail_each 5 EIO found fuzz --method mt-float --count 4000 --family affine --out out
FAIL_SHORT=1 fail_each 5 short none fuzz --method mt-float --count 4000 --family affine --out out

# The record is sound by itself, if its figures are missing: none of another record stands beside it.
between() { [ ! -e out/thresholds.svg ] && [ "$(grep -c '' <(tree out))" -ge 3 ] && [ -z "$(comm -13 <(echo "$after") <(tree out) | grep -v plot.log)" ]; }
mkdir swept
"$TRIBUNAL" sweep --method mt-float --axis scale --count 328 --seed 2 --out swept >out.txt || true
fail_each 5 EIO swept sweep --method mt-float --axis scale --count 32 --out out
echo "tried $tried, broke $broken"
[ "$broken" -eq 0 ]
