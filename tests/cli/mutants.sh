#!/usr/bin/env bash
# Our own files, damaged field by field and sealed anew: refused in one line, or read as what they say. Never a crash, an
# endless run or a figure that cannot be. MUTANTS: how many of each file.
source "$(dirname "$0")/common.bash"
cd "$scratch"
count=${MUTANTS:-20}
mutants() { python3 "$SOURCE_DIR/tests/cli/mutants.py" "$@" || failed=1; }
failed=0

# A log of one's own cases, one of a trial, and one of polygons. `verify` finds that the files beside them are others, or
# the log impossible.
"$TRIBUNAL" cases --out cases.jsonl --count 60 >/dev/null 2>&1 || "$TRIBUNAL" cases >cases.jsonl
head -n 40 cases.jsonl >some.jsonl
expect 0 classify --method sf-double --in some.jsonl --out answers.jsonl
"$TRIBUNAL" judge --cases some.jsonl --answers answers.jsonl --out judged >out 2>err || [ $? -eq 1 ] || { cat err >&2; exit 1; }
cp -r judged mutant
mutants judged/log.jsonl mutant/log.jsonl --seed 1 --count $((3 * count)) --chained -- "$TRIBUNAL" verify mutant

# A checkpoint, from which the run goes on: at most to the end of its plan.
plan=(fuzz --method sf-double,mt-float --seed 3 --threads 1)
for n in 60000 200000 1000000 4000000; do
  timeout --preserve-status -s INT .4 "$TRIBUNAL" "${plan[@]}" --count $n --out part >out 2>err || true
  [ ! -e part/checkpoint.jsonl ] || break
done
[ -e part/checkpoint.jsonl ] || { echo "never interrupted" >&2; exit 1; }
mkdir resumed
# Where it is accepted the run is interrupted after a second: what is refused is refused at once.
cat >resume.sh <<END
exec timeout --preserve-status -s INT 1 "$TRIBUNAL" ${plan[*]} --count $n --out resumed --resume
END
cat >resume <<'END'
status=0
bash resume.sh || status=$?
[ $status -ne 130 ] || exit 0
exit $status
END
mutants part/checkpoint.jsonl resumed/checkpoint.jsonl --seed 2 --count $count --chained -- bash resume

# What `report`, `replay` and `shrink` read.
expect 1 fuzz --method sf-double --seed 3 --count 20000 --out found
mkdir page
cp found/* page/
mutants found/summary.json page/summary.json --seed 3 --count $count -- "$TRIBUNAL" report page --out page.html
cp found/* page/
mutants found/counterexamples.jsonl page/counterexamples.jsonl --seed 4 --count $count -- "$TRIBUNAL" report page --out page.html
mutants found/counterexamples.jsonl one.jsonl --seed 5 --count $((count / 2)) -- "$TRIBUNAL" replay one.jsonl
mkdir judged-page
cp judged/* judged-page/
mutants judged/certificate.json judged-page/certificate.json --seed 6 --count $count -- "$TRIBUNAL" report judged-page --out page.html
"$TRIBUNAL" sweep --method sf-float --axis fill --count 40 --out swept >out 2>err || [ $? -eq 1 ] || { cat err >&2; exit 1; }
mkdir swept-page
cp swept/*.json swept/*.jsonl swept-page/
mutants swept/sweep.json swept-page/sweep.json --seed 7 --count $count -- "$TRIBUNAL" report swept-page --out page.html
[ "$failed" -eq 0 ]
