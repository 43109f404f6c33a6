#!/usr/bin/env bash
# The checkers of docs/ confirm what fuzz finds, and reject a counterexample that blames the wrong answer.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
status=0
# swap_answers FILE: the first finding blames the other answer.
swap_answers() { sed '1s/"answered":0/"answered":2/;1s/"answered":1/"answered":0/;1s/"answered":2/"answered":1/' "$1"; }
"$TRIBUNAL" fuzz --method sf-double,mt-float --count 20000 --out "$scratch" >/dev/null || status=$?
[ "$status" -eq 1 ] || { echo "fuzz: exit $status, expected 1" >&2; exit 1; }
/usr/bin/python3 "$SOURCE_DIR/docs/check_counterexample.py" "$scratch/counterexamples.jsonl"
swap_answers "$scratch/counterexamples.jsonl" >"$scratch/tampered.jsonl"
! /usr/bin/python3 "$SOURCE_DIR/docs/check_counterexample.py" "$scratch/tampered.jsonl" || { echo "tampering passed" >&2; exit 1; }
sed '1s/"abcp":[-01]*/"abcp":7/' "$scratch/counterexamples.jsonl" >"$scratch/signs.jsonl"
! /usr/bin/python3 "$SOURCE_DIR/docs/check_counterexample.py" "$scratch/signs.jsonl" || { echo "a wrong sign passed" >&2; exit 1; }

# The same of polygons; and every exact answer to generated cases, planar or not, is what fractions give.
families=polygon-affine,polygon-ulp,polygon-in-plane,polygon-grid,polygon-warped,polygon-rounded
status=0
"$TRIBUNAL" fuzz --family "$families" --method sf-double,haines-double,feito-double --count 3000 --keep 5 --out "$scratch/rings" >/dev/null || status=$?
[ "$status" -eq 1 ] || { echo "fuzz: exit $status, expected 1" >&2; exit 1; }
polygons=$SOURCE_DIR/docs/check_polygon_counterexample.py
/usr/bin/python3 "$polygons" "$scratch/rings/counterexamples.jsonl"
swap_answers "$scratch/rings/counterexamples.jsonl" >"$scratch/tampered.jsonl"
! /usr/bin/python3 "$polygons" "$scratch/tampered.jsonl" || { echo "tampering passed" >&2; exit 1; }
sed '1s/"planar":true/"planar":false/;t;1s/"planar":false/"planar":true/' "$scratch/rings/counterexamples.jsonl" >"$scratch/tampered.jsonl"
! /usr/bin/python3 "$polygons" "$scratch/tampered.jsonl" || { echo "wrong planarity passed" >&2; exit 1; }
"$TRIBUNAL" cases --family "$families" --count 600 --seed 4 --with-answers --out "$scratch/cases.jsonl"
/usr/bin/python3 "$polygons" "$scratch/cases.jsonl"

# says_and_fails TEXT SCRIPT ARG…: the script of docs/ fails with this one line and no traceback.
says_and_fails() {
  local status=0
  /usr/bin/python3 "$SOURCE_DIR/docs/$2" "${@:3}" >"$scratch/out" 2>"$scratch/err" || status=$?
  [ "$status" -eq 1 ] && [ ! -s "$scratch/out" ] && [ "$(wc -l <"$scratch/err")" -eq 1 ] && grep -qF -- "$1" "$scratch/err" ||
    { echo "$2: exit $status, expected '$1'" >&2; cat "$scratch/out" "$scratch/err" >&2; exit 1; }
}
echo '{"id":"an answer","hit":1}' >"$scratch/answer.jsonl"
echo '{"id":' >"$scratch/broken.jsonl"
for script in check_counterexample.py check_polygon_counterexample.py; do
  says_and_fails 'nothing.jsonl: cannot read: No such file' $script "$scratch/nothing.jsonl"
  says_and_fails 'answer.jsonl:1: expected a case' $script "$scratch/answer.jsonl"
  says_and_fails 'broken.jsonl:1: ' $script "$scratch/broken.jsonl"
  says_and_fails 'holds no cases' $script /dev/null
done
cat "$scratch/counterexamples.jsonl" "$scratch/rings/counterexamples.jsonl" >"$scratch/both.jsonl"
says_and_fails "cases have rings: ask check_polygon_counterexample.py" check_counterexample.py "$scratch/both.jsonl"
/usr/bin/python3 "$polygons" "$scratch/both.jsonl"
sed '1s/"abcp":[-01]*/"abcp":7/' "$scratch/both.jsonl" >"$scratch/signs.jsonl"
! /usr/bin/python3 "$polygons" "$scratch/signs.jsonl" || { echo "a wrong sign passed among polygons" >&2; exit 1; }

# The example of a test of one's own says of polygons and rays that they are not for it.
head -n 40 "$scratch/cases.jsonl" >"$scratch/few.jsonl"
/usr/bin/python3 "$SOURCE_DIR/docs/examples/judge_my_test.py" "$scratch/few.jsonl" >"$scratch/answers.jsonl"
[ "$(grep -c '"status": "unsupported"' "$scratch/answers.jsonl")" -eq 40 ]
says_and_fails 'nothing.jsonl: cannot read: No such file' examples/judge_my_test.py "$scratch/nothing.jsonl"
