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

# What `replay` reads.
expect 1 fuzz --method sf-double --seed 3 --count 20000 --out found
mutants found/counterexamples.jsonl one.jsonl --seed 5 --count $((count / 2)) -- "$TRIBUNAL" replay one.jsonl

# What `report` reads, of every kind: the page's JSON is held to that of the sound record. pages DIR FILE SEED: damages
# the file beside all others of the directory.
pages() {
  rm -rf page && cp -r "$1" page
  mutants "$1/$2" "page/$2" --seed "$3" --count "${4:-$count}" --page -- "$TRIBUNAL" report page --out page.html --json -
}
made() { "$TRIBUNAL" "$@" >out 2>err || [ $? -eq 1 ] || { cat err >&2; exit 1; }; }
pages found summary.json 3
pages found counterexamples.jsonl 4
pages judged certificate.json 6
made sweep --method sf-float --axis fill --count 40 --out swept
pages swept sweep.json 7
made sweep --method sf-double,mt-float --map edge --map-size 16 --out mapped
pages mapped map-edge.json 8 $((3 * count / 5))
made leak "$SOURCE_DIR/data/meshes/octahedron.off" --method mt-float,sf-filtered --rays 600 --out leaked
pages leaked summary.json 9 $((3 * count / 5))
mkdir drawn
made render "$SOURCE_DIR/data/scenes/elephant.json" --size 48x36 --method mt-float --against sf-filtered -o drawn/e.png
pages drawn e.diff.json 10 $((3 * count / 5))
# A chart without its drawings, which take longer than all that is measured here.
mkdir bare
echo 'raise SystemExit(65)' >bare/sitecustomize.py
PYTHONPATH=$PWD/bare "$TRIBUNAL" chart --quick --method mt-double,sf-double --count 163 --repetitions 9 --rays 200 --threads 1 \
  --scenes "$SOURCE_DIR/data/scenes/dark-box.json" --mesh "$SOURCE_DIR/data/meshes/octahedron.off" --out charted >out 2>err || true
grep -q '"leaks"' charted/chart.json || { cat err >&2; exit 1; }
pages charted chart.json 11 $((3 * count / 5))
[ "$failed" -eq 0 ]
