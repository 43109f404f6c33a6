#!/usr/bin/env bash
# Rays of a mesh out, answers in: the example of docs/examples is judged as the same test here is, planted faults are found
# in the kind of answer that has them, and what is no answer is refused in one line.
source "$(dirname "$0")/common.bash"
cd "$scratch"
cat >notch.off <<'MESH'
OFF
# A box with a pit, so that a ray passes up to four faces; one face has four corners.
9 9 0
0 0 0
2 0 0
0 2 0
2 2 0
0 0 2
2 0 2
0 2 2
2 2 2
1 1 0.25
4 0 2 3 1
3 4 5 8
3 5 7 8
3 7 6 8
3 6 4 8
4 0 1 5 4
4 2 6 7 3
4 0 4 6 2
4 1 3 7 5
MESH
example=$SOURCE_DIR/docs/examples/judge_my_tree.py
expect 0 leak notch.off --rays 900 --seed 3 --rays-out rays
says out '900 rays in rays/binary64.jsonl, aimed at rays/binary64.off'
promises=(--convention transversal --sorted --most-ulps 1 --most-degrees 1e-6)

# judge FORMAT ARG…: the answers in answers.jsonl.
judged() { expect "$1" judge --mesh "rays/$2.off" --rays "rays/$2.jsonl" --answers answers.jsonl "${promises[@]}" "${@:3}"; }

for format in binary64 binary32; do
  python3 "$example" "rays/$format.off" "rays/$format.jsonl" --exact >answers.jsonl
  cp answers.jsonl "right-$format.jsonl"
  judged 0 $format
  for kind in closest any all; do says out "mine-fraction/$kind, $format rays: watertight on these "; done
done

# The same test face by face, in this program and in the example: the same rays leak, by the one judge.
python3 "$example" rays/binary64.off rays/binary64.jsonl >answers.jsonl
judged 1 binary64 --json && cp out there.json
expect 1 leak notch.off --rays 900 --seed 3 --format binary64 --method mt-double --json && cp out here.json
python3 - <<'CHECK'
import json
def tally(file, name):
    rows = json.load(open(file))["trials"][0]["subjects"]
    return next(row for row in rows if row["name"] == name)["all"]
here, there = tally("here.json", "mt-double"), tally("there.json", "mine-float/all")
same = ("rays", "leak", "lost", "false hit", "double hit", "neighbour", "reported twice", "outline")
assert [here[key] for key in same] == [there[key] for key in same], (here, there)
assert here["leak"] > 0 and here["double hit"] > 0
CHECK

# Answers spoilt at random, and an oracle that shares no code with the judge: it counts the same.
for format in binary64 binary32; do
  python3 - right-$format.jsonl >answers.jsonl <<'SPOIL'
import json, random, sys
random.seed(1)
for text in open(sys.argv[1]):
    a = json.loads(text)
    hits = [hit for hit in a["all"] if random.random() > 0.35]
    hits += [{"face": random.randrange(14)} for _ in range(random.random() < 0.3)]
    if random.random() < 0.1:
        random.shuffle(hits)
    a["all"] = hits
    a["any"] ^= random.random() < 0.2
    if random.random() < 0.4:
        a["closest"] = random.choice([None, {"face": random.randrange(14)}, hits[-1] if hits else None])
    print(json.dumps(a))
SPOIL
  judged 1 $format --json && cp out judged.json
  python3 "$SOURCE_DIR/tests/cli/leak_oracle.py" rays/$format.off rays/$format.jsonl answers.jsonl judged.json >counts || { cat counts >&2; exit 1; }
  says counts "'outline': " && lacks counts "'leak': 0,"
done

# plant KIND WORDS… CODE: the right answers, changed by a line of Python, are found to be wrong so.
plant() {
  python3 - "$3" >answers.jsonl <<'PLANT'
import json, sys
for k, text in enumerate(open("right-binary64.jsonl")):
    a = json.loads(text)
    exec(sys.argv[1])
    print(json.dumps(a))
PLANT
  judged 1 binary64 --out found
  says out "mine-fraction/$1, binary64 rays: $2" && says found/summary.json '"mesh": "binary64.off"'
  rm -r found
}
plant closest 'watertight on these 900 rays; t beyond its promise' 'c = a["closest"]; c and c.update(t=c["t"] * (1 + 1e-9))'
plant closest 'watertight on these 900 rays; t beyond its promise' 'c = a["closest"]; c and c.update(t="nan")'
plant closest 'watertight on these 900 rays; wrong normals' 'c = a["closest"]; c and k % 7 == 0 and c.update(normal=[-x for x in c["normal"]])'
plant closest 'watertight on these 900 rays; wrong normals' 'c = a["closest"]; c and c.update(normal=[c["normal"][0] * (1 + 1e-4) + 1e-4] + c["normal"][1:])'
plant closest 'watertight on these 900 rays; wrong normals' 'c = a["closest"]; c and c.update(side="back")'
plant closest 'watertight on these 900 rays; wrong closest' 'a["closest"] and a.update(closest={"face": a["all"][-1]["face"]})'
plant closest 'leaks: ' 'a.update(closest=None) if k % 50 == 0 else 0'
plant any 'leaks: ' 'a.update(any=0) if k % 50 == 0 else 0'
plant any 'watertight on these 900 rays; false hits' 'a.update(any=1)'
plant all 'leaks: ' 'del a["all"][:1]'
plant all 'watertight on these 900 rays; double hits' 'a["all"] += a["all"][-1:]'
plant all 'watertight on these 900 rays; wrong order' 'a["all"].reverse()'
plant all 'no leak where it answered, but faults: ' 'k % 9 == 0 and (a.clear() or a.update(id=str(k), method="mine-fraction", status="failed", fault="crashed", detail="SIGSEGV"))'
says out 'crashed (SIGSEGV) on 100 rays'
sed 's/"method.*/"inside":1}/' right-binary64.jsonl >answers.jsonl
judged 1 binary64 && says out 'answers/inside, binary64 rays: wrong about inside and outside: '

# Rays of one's own need not say what they are aimed at, and a case that is written can be replayed.
printf '{"id":"mine","ray":{"o":[1,0.5,9],"d":[0,0,-1]}}\n' >own.jsonl
printf '{"id":"mine","closest":{"face":0,"t":9}}\n' >answers.jsonl
expect 1 judge --mesh notch.off --rays own.jsonl --answers answers.jsonl --out found && says out 'wrong closest'
says found/summary.json '"unsaid"'
expect 0 report found --out page.html --json page.json
says page.json '"command":"tribunal judge --mesh notch.off --rays own.jsonl --answers answers.jsonl --out found"'
"$TRIBUNAL" replay found/cases.jsonl >out || [ $? -eq 1 ]
says out 'answers/closest-closest-binary64-0'

# refused TEXT LINE…: an answer file with these lines is bad input.
refused() {
  printf '%s\n' "${@:2}" >answers.jsonl
  expect 3 judge --mesh notch.off --rays own.jsonl --answers answers.jsonl && says err "$1" && [ "$(wc -l <err)" -eq 1 ]
}
refused 'no ray' '{"id":"yours","any":1}'
refused 'expected a whole number from 0 to 13' '{"id":"mine","closest":{"face":14}}'
refused 'expected a whole number from 0 to 13' '{"id":"mine","closest":{"face":-1}}'
refused 'a second answer' '{"id":"mine","any":1}' '{"id":"mine","any":1}'
refused 'expected 0 or 1' '{"id":"mine","any":2}'
refused 'unknown key' '{"id":"mine","closets":null}'
refused 'expected "closest", "any", "all" or "inside"' '{"id":"mine"}'
refused 'expected three numbers' '{"id":"mine","closest":{"face":0,"normal":[1,2]}}'
refused 'an answer and a status' '{"id":"mine","any":1,"status":"failed"}'
refused 'nothing to judge' '{"id":"mine","status":"failed"}'
printf '{"id":"second","ray":{"o":[1,0.5,9],"d":[0,0,1]}}\n' >>own.jsonl
refused '1 of 2 answers of answers are missing or lack "any", the first to "second"' '{"id":"mine","any":1}' '{"id":"second","all":[]}'
printf '{"id":"x","ray":{"o":[1,1,9],"d":[0,0,0]}}\n' >zero.jsonl
expect 3 judge --mesh notch.off --rays zero.jsonl --answers answers.jsonl && says err 'a direction that is not 0'
printf '{"id":"x","ray":{"o":[1,1,9],"d":[0,0,1]}}\n{"id":"x","ray":{"o":[1,1,9],"d":[0,0,1]}}\n' >twice.jsonl
expect 3 judge --mesh notch.off --rays twice.jsonl --answers answers.jsonl && says err 'it was on line 1'
expect 2 judge --answers answers.jsonl && says err 'expected --cases, or --mesh and --rays'
expect 2 judge --mesh notch.off --answers answers.jsonl
expect 2 judge --cases own.jsonl --answers answers.jsonl --sorted && says err '--mesh'
expect 2 leak notch.off --rays-out rays --method mt-double && says err '--rays-out'
