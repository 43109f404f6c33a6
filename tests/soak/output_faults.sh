#!/usr/bin/env bash
# Every call that touches a file fails once, in a small run of every command that writes, with three kinds of error.
. "$SOURCE_DIR/tests/cli/common.bash"
cd "$scratch"
. "$SOURCE_DIR/tests/faults/loop.bash"
"$TRIBUNAL" cases --count 20 --family affine --out cases.jsonl
"$TRIBUNAL" classify --method mt-float --in cases.jsonl --out answers.jsonl
"$TRIBUNAL" fuzz --method mt-float --count 4000 --family affine --keep 1 --out found >said || [ $? -eq 1 ]
head -n 1 found/counterexamples.jsonl >wrong.jsonl
mkdir old && echo old >old/answers.jsonl
scene=$SOURCE_DIR/data/scenes/cube.json
[ -e "$scene" ] || scene=$(find "$SOURCE_DIR/data/scenes" -name '*.json' | sort | head -n 1)
printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n' >tetra.off

# made NAME ARG…: NAME holds an earlier result of a command that writes to out/.
made() {
  local name=$1
  shift
  rm -rf out
  "$TRIBUNAL" "$@" >said 2>err || [ $? -eq 1 ] || { cat err >&2; exit 1; }
  mv out "$name"
}
both() {  # ARG…: with nothing there before, and over the result of the same command with another seed or method
  fail_each "$error" "$name" none "$@"
  fail_each "$error" "$name" earlier "$@"
}

while read -r error name; do
  rm -rf earlier
  fail_each "$error" "$name" old classify --method mt-float --in cases.jsonl --out out/answers.jsonl
  fail_each "$error" "$name" old cases --count 5 --out out/answers.jsonl
  fail_each "$error" "$name" old shrink wrong.jsonl --method mt-float --out out/answers.jsonl

  made earlier judge --cases cases.jsonl --answers answers.jsonl --convention open --out out
  both judge --cases cases.jsonl --answers answers.jsonl --out out
  rm -rf earlier && made earlier fuzz --method mt-float --count 4000 --seed 2 --family affine --out out
  between() { [ -e out/checkpoint.jsonl ]; }  # findings of a run whose results cannot be written are kept
  both fuzz --method mt-float --count 4000 --family affine --out out
  between() { false; }
  rm -rf earlier && made earlier fuzz --relations --method mt-float --count 400 --seed 2 --out out
  both fuzz --relations --method mt-float --count 400 --out out
  rm -rf earlier && made earlier leak tetra.off --method woop-float,mt-float --rays 2000 --seed 2 --out out
  both leak tetra.off --method mt-float --rays 2000 --out out
  rm -rf earlier && made earlier leak tetra.off --rays-out out --rays 10 --seed 2
  both leak tetra.off --rays-out out --rays 10
  rm -rf earlier && made earlier fuzz --method mt-float --count 4000 --family affine --out out
  fail_each "$error" "$name" earlier report out --out out/page.html --json out/page.json

  # A record is sound by itself where its figures are missing: none of another record stands beside it.
  between() { [ -z "$(find out -name '*.svg')" ] && [ -z "$(comm -13 <(echo "$after") <(tree out) | grep -v plot.log)" ]; }
  rm -rf earlier && made earlier sweep --method mt-float --axis scale --count 32 --seed 2 --out out
  both sweep --method mt-float --axis scale --count 32 --out out
  between() { false; }
done <<'ERRORS'
5 EIO
28 ENOSPC
13 EACCES
ERRORS
FAIL_SHORT=1 fail_each 5 short none fuzz --method mt-float --count 4000 --family affine --out out
echo "tried $tried, broke $broken: calls that touch files, each failing once, in runs of nine commands"
[ "$broken" -eq 0 ]
