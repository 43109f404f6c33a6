#!/usr/bin/env bash
# cases and judge from end to end: a test in Python that is linked with nothing is judged, and each kind of bad input
# is refused at its line.
source "$(dirname "$0")/common.bash"
cd "$scratch"
python=/usr/bin/python3
example=$SOURCE_DIR/docs/examples/judge_my_test.py

# Cases are a function of family, format, seed and number, and say nothing of the answer unless asked.
expect 0 cases --count 3260 --family affine,ulp --out cases.jsonl
[ "$(wc -l <cases.jsonl)" -eq 3260 ]
[ "$(cut -d'"' -f4 cases.jsonl | sort -u | wc -l)" -eq 3260 ]
says cases.jsonl '"id":"affine-binary64-0"' && says cases.jsonl '"id":"ulp-binary32-814"' && says cases.jsonl 'family affine, seed 1, case 17"'
lacks cases.jsonl '"expect"' && lacks cases.jsonl '"class"'
expect 0 cases --count 1630 --family affine,ulp && head -n 1630 cases.jsonl | cmp - out
expect 0 cases --count 8 --family affine --fmt binary32 --seed 2 && lacks out binary64 && says out 'seed 2'
expect 0 cases --count 3260 --family affine,ulp --with-answers --out known.jsonl
$python - <<'PYTHON'
import json
plain, known = ([json.loads(line) for line in open(f)] for f in ("cases.jsonl", "known.jsonl"))
assert all(k.pop("expect") in (0, 1) and k.pop("class") and k == p for p, k in zip(plain, known))
PYTHON
expect 2 cases --count 0
expect 2 cases --family afine && says err 'did you mean "affine"?'
expect 2 cases --fmt binary16
expect 5 cases --count 5 --out /dev/full

# A naive test in Python fails where sf-double does; with fractions in place of floats, the same lines never do.
expect 0 cases --family affine --fmt binary64 --count 2624 --out affine.jsonl
$python "$example" affine.jsonl >naive.jsonl
expect 1 judge --cases affine.jsonl --answers naive.jsonl --out naive
says out 'mine-float: refuted' && says out "most in  C"
# The result says how it was made, as the one of a mesh does, and the page of a report tells it.
says naive/certificate.json '"command": [' && says naive/log.jsonl '"command":["judge","--cases","affine.jsonl","--answers","naive.jsonl"]'
expect 0 report naive --out page.html --json page.json && says page.json 'tribunal judge --cases affine.jsonl --answers naive.jsonl'
expect 0 verify naive && says out 'not asked again: its answers came from a file'
says naive/certificate.md '## Your own cases' && lacks naive/certificate.md '## Sampled' && lacks naive/certificate.json upper_95
$python "$SOURCE_DIR/docs/check_counterexample.py" naive/counterexamples.jsonl
expect 1 judge --cases affine.jsonl --answers naive.jsonl --out one --threads 1 && diff -r naive one
$python - <<'PYTHON'
import json
wrong = [json.loads(line) for line in open("naive/counterexamples.jsonl")]
rows = json.load(open("naive/certificate.json"))["own_cases"]
assert sum(row["n"] + row["unsupported"] for row in rows) <= 2624 and 80 < len(rows) <= 163
assert sum(row["k"] for row in rows) == len(wrong) > 100
answers = {a["id"]: a for a in map(json.loads, open("naive.jsonl"))}
assert all(answers[w["id"]]["hit"] == w["finding"]["answered"] != w["expect"] for w in wrong)
PYTHON
$python "$example" --exact affine.jsonl >exact.jsonl
expect 0 judge --cases affine.jsonl --answers exact.jsonl && says out mine-fraction

# What classify writes can be judged, several methods in one file, and agrees with what fuzz says of the same cases.
expect 0 classify --method sf-double,sf-rational --in affine.jsonl --out two.jsonl
expect 1 judge --cases affine.jsonl --answers two.jsonl --out two && says out sf-rational
expect 0 verify two/1-sf-double && says out 'not asked again: its answers came from a file'
expect 1 fuzz --method sf-double --family affine --count 5248 --out fuzzed
$python - <<'PYTHON'
import json
judged = {row["class"]: row["k"] for row in json.load(open("two/1-sf-double/certificate.json"))["own_cases"]}
fuzzed = {row["class"]: row["wrong"] for row in json.load(open("fuzzed/summary.json"))["counts"]
          if row["fmt"] == "binary64"}
assert judged == fuzzed and len(judged) == 328
PYTHON

# Conventions: a segment in the plane.
echo '{"id":"flat","seg":[[0.25,0.25,0],[0.5,0.25,0]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}' >flat.jsonl
echo '{"id":"flat","hit":0}' >miss.jsonl
expect 1 judge --cases flat.jsonl --answers miss.jsonl && says out 'answers: refuted'
expect 0 judge --cases flat.jsonl --answers miss.jsonl --convention transversal
# A contact with an edge: an open boundary owes a miss, and a half-open one owes nothing of a face alone.
echo '{"id":"flat","seg":[[0.25,0,1],[0.25,0,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}' >edge.jsonl
expect 1 judge --cases edge.jsonl --answers miss.jsonl && says out 'answers: refuted; wrong on boundaries only: 1 of 1 (your own binary64)'
expect 0 judge --cases edge.jsonl --answers miss.jsonl --convention open && says out 'nothing wrong of 1'
expect 3 judge --cases edge.jsonl --answers miss.jsonl --convention half-open && says err 'nothing to judge'
expect 1 judge --cases edge.jsonl --answers miss.jsonl --convention half-open --boundary closed
expect 0 judge --cases edge.jsonl --answers miss.jsonl --boundary open && says out 'nothing wrong of 1'
expect 3 judge --cases edge.jsonl --answers miss.jsonl --boundary unspecified
expect 3 judge --cases flat.jsonl --answers miss.jsonl --convention unspecified && says err 'nothing to judge'
# The other readings: ends of the probe, faces seen from behind, degenerate operands.
echo '{"id":"flat","hit":1}' >hit.jsonl
echo '{"id":"flat","seg":[[0.25,0.25,1],[0.25,0.25,0]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}' >end.jsonl
expect 1 judge --cases end.jsonl --answers miss.jsonl
expect 0 judge --cases end.jsonl --answers miss.jsonl --ends open --out ends
expect 1 judge --cases end.jsonl --answers hit.jsonl --ends open --out ends && says ends/counterexamples.jsonl '"readings":{"ends":"open"}'
expect 0 verify ends
expect 3 judge --cases end.jsonl --answers miss.jsonl --ends unspecified
echo '{"id":"flat","ray":{"o":[0.25,0.25,-1],"d":[0,0,1]},"tri":[[0,0,0],[1,0,0],[0,1,0]]}' >behind.jsonl
expect 1 judge --cases behind.jsonl --answers miss.jsonl
expect 0 judge --cases behind.jsonl --answers miss.jsonl --culls
expect 1 judge --cases behind.jsonl --answers hit.jsonl --culls

# A test that culls owes nothing of polygons, and that is said; a case that was declined is counted once.
cat >mixed.jsonl <<'CASES'
{"id":"a","seg":[[0.25,0.25,1],[0.25,0.25,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}
{"id":"b","seg":[[0.25,0.25,1],[0.25,0.25,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}
{"id":"p","seg":[[0.25,0.25,1],[0.25,0.25,-1]],"rings":[[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]]}
CASES
cat >declined.jsonl <<'ANSWERS'
{"id":"a","method":"m","hit":1,"status":"ok"}
{"id":"b","method":"m","status":"unsupported"}
{"id":"p","method":"m","hit":1,"status":"ok"}
ANSWERS
expect 0 judge --cases mixed.jsonl --answers declined.jsonl --culls
says out '  own      binary64: 0 wrong of 1 (0 %); 1 outside the contract; 1 refused' && says out '1 of 1 polygons are not judged: a test that culls'
expect 0 judge --cases mixed.jsonl --answers declined.jsonl
says out '  own      binary64: 0 wrong of 2 (0 %); 1 refused' && lacks out 'outside the contract' && lacks out 'not judged'
tail -n 1 mixed.jsonl >polygon.jsonl
tail -n 1 declined.jsonl >polygon-hit.jsonl
expect 3 judge --cases polygon.jsonl --answers polygon-hit.jsonl --culls && says err 'with --culls none is owed about pierced polygons'
echo '{"id":"flat","seg":[[0,0,1],[0,0,-1]],"tri":[[0,0,0],[1,0,0],[0.5,0,0]]}' >thin.jsonl
expect 1 judge --cases thin.jsonl --answers miss.jsonl
expect 3 judge --cases thin.jsonl --answers miss.jsonl --no-degenerate && says err 'nothing to judge'
# Rays with bounds are judged: as closed at them, or as --bounds says.
for t in '0.5,2' '1,2'; do
  echo '{"id":"flat","ray":{"o":[0.25,0.25,1],"d":[0,0,-1],"t":['$t']},"tri":[[0,0,0],[1,0,0],[0,1,0]]}' >"within-$t.jsonl"
  expect 1 judge --cases "within-$t.jsonl" --answers miss.jsonl && says out 'answers: refuted'
  expect 0 judge --cases "within-$t.jsonl" --answers hit.jsonl && says out 'nothing wrong of 1'
done
expect 0 judge --cases within-1,2.jsonl --answers miss.jsonl --bounds open
expect 1 judge --cases within-1,2.jsonl --answers hit.jsonl --bounds open
expect 1 judge --cases within-0.5,2.jsonl --answers miss.jsonl --bounds open
expect 3 judge --cases within-1,2.jsonl --answers hit.jsonl --bounds unspecified
# A contact is judged where it is told.
echo '{"id":"flat","hit":1,"contact":"edge"}' >edge-told.jsonl && echo '{"id":"flat","hit":1,"contact":"vertex"}' >vertex-told.jsonl
expect 0 judge --cases edge.jsonl --answers edge-told.jsonl
expect 1 judge --cases edge.jsonl --answers vertex-told.jsonl --out told && says out '1 wrong contact; 1 boundary'
$python "$SOURCE_DIR/docs/check_counterexample.py" told/counterexamples.jsonl && expect 0 verify told
echo '{"id":"flat","hit":1}' | "$TRIBUNAL" judge --cases flat.jsonl --answers - >out

# refused MESSAGE LINE…: a file of these answers to case "flat" is bad input.
refused() {
  printf '%s\n' "${@:2}" >bad.jsonl
  expect 3 judge --cases flat.jsonl --answers bad.jsonl --out nothing
  says err "$1"
  [ "$(wc -l <err)" -eq 1 ] && [ ! -s out ] && [ ! -e nothing ] || { echo "$1: expected one line and no output" >&2; exit 1; }
}
refused 'bad.jsonl:1: answers "steep", which is no case'"'"'s id' '{"id":"steep","hit":1}'
refused 'bad.jsonl:3: a second answer of answers to "flat"' '{"id":"flat","hit":1}' '' '{"id":"flat","hit":1}'
refused 'bad.jsonl:1: missing "hit"' '{"id":"flat"}'
refused 'bad.jsonl:1: missing "id"' '{"hit":1}'
refused 'bad.jsonl:1: hit: expected 0 or 1, found true' '{"id":"flat","hit":true}'
refused 'bad.jsonl:1: hit: given with a status' '{"id":"flat","hit":1,"status":"unsupported"}'
refused 'bad.jsonl:1: status: expected "ok", "nonfinite", "unsupported" or "failed", found "fine"' '{"id":"flat","hit":1,"status":"fine"}'
refused 'bad.jsonl:1: unknown key "hits", did you mean "hit"?' '{"id":"flat","hits":1}'
refused 'bad.jsonl:1: method: expected 1 to 32 of a-z A-Z' '{"id":"flat","hit":1,"method":7}'
refused 'bad.jsonl:1: not valid JSON' '{"id":"flat","hit":1'
refused 'bad.jsonl: no answer is "ok"' '{"id":"flat","status":"unsupported"}'
: >bad.jsonl && expect 3 judge --cases flat.jsonl --answers bad.jsonl && says err 'bad.jsonl: holds no answers'
head -n 2616 exact.jsonl >short.jsonl
expect 3 judge --cases affine.jsonl --answers short.jsonl && says err 'short.jsonl: 8 of 2624 answers of mine-fraction are missing, the first to "affine-binary64-2616"'
cat flat.jsonl flat.jsonl >double.jsonl
expect 3 judge --cases double.jsonl --answers miss.jsonl && says err 'double.jsonl:2: id "flat" again, it was on line 1'
sed 's/"tri"/"expect":0,"tri"/' flat.jsonl >liar.jsonl
expect 3 judge --cases liar.jsonl --answers miss.jsonl && says err 'flat: the case expects no hit'
expect 3 judge --cases nothing.jsonl --answers miss.jsonl && says err 'nothing.jsonl: cannot read'
expect 2 judge --cases - --answers - && says err 'both standard input'
expect 2 judge --cases flat.jsonl
expect 2 judge --cases flat.jsonl --answers miss.jsonl --convention ajar

# The worst is first, whatever its format and its target: here a triangle's case of binary32, after extreme ones of binary64.
cat >mixed.jsonl <<'CASES'
{"id":"huge","seg":[[1e300,1e300,1e300],[1e300,1e300,-1e300]],"tri":[[0,0,0],[4e300,0,0],[0,4e300,0]]}
{"id":"ring","seg":[[0.25,0.25,1],[0.25,0.25,-1]],"rings":[[[0,0,0],[1,0,0],[0,1,0]]]}
{"id":"edge","fmt":"binary32","seg":[[0.5,0.5,1],[0.5,0.5,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}
{"id":"plain","fmt":"binary32","seg":[[0.25,0.25,1],[0.25,0.5,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}
CASES
for id in huge ring edge plain; do echo '{"id":"'$id'","hit":0}'; done >all_miss.jsonl
expect 1 judge --cases mixed.jsonl --answers all_miss.jsonl --out mixed
[ "$(grep -o '^{"id":"[a-z]*"' mixed/counterexamples.jsonl | cut -d'"' -f4 | tr '\n' ' ')" = 'plain ring edge huge ' ]
expect 0 verify mixed
# t and the weights of hits, where answers have them: how far off they are, in ulps of the exact value.
cat >rays.jsonl <<'CASES'
{"id":"a","ray":{"o":[0.25,0.5,3],"d":[0,0,-1]},"tri":[[0,0,0],[1,0,0],[0,1,0]]}
{"id":"b","ray":{"o":[0.25,0.5,6],"d":[0,0,-2]},"tri":[[0,0,0],[1,0,0],[0,1,0]]}
{"id":"miss","ray":{"o":[5,5,3],"d":[0,0,-1]},"tri":[[0,0,0],[1,0,0],[0,1,0]]}
CASES
cat >numbers.jsonl <<'ANSWERS'
{"id":"a","hit":1,"t":3,"weights":[0.25,0.5]}
{"id":"b","hit":1,"t":"0x1.8000000000002p+1","weights":[0.5,0.25]}
{"id":"miss","hit":0}
ANSWERS
expect 0 judge --cases rays.jsonl --answers numbers.jsonl --out numbers
says out 'ulps     t, binary64: half within 0, 99 % within 2, at most 2 ulps (case 1), of 2; the most in your own cases'
says out 'weights, binary64: half within 0, 99 % within 4.5e+15'
expect 0 verify numbers
sed 's/,"t":3,/,/' numbers.jsonl >no-t.jsonl
expect 3 judge --cases rays.jsonl --answers no-t.jsonl && says err 'given without "t"'
sed 's/"hit":0/"hit":0,"t":1/' numbers.jsonl >miss-t.jsonl
expect 3 judge --cases rays.jsonl --answers miss-t.jsonl && says err 'given of what is no hit'

# Of several methods, none has a directory with a result before all are written: here a directory is in a file's place.
expect 0 classify --method sf-filtered,mt-float --in "$SOURCE_DIR/data/cases/rival-witnesses.jsonl" --out of-two.jsonl
mkdir -p half/2-mt-float/certificate.json
expect 5 judge --cases "$SOURCE_DIR/data/cases/rival-witnesses.jsonl" --answers of-two.jsonl --out half
says err 'half/2-mt-float/certificate.json: cannot write' && [ -z "$(find half -type f)" ]
