#!/usr/bin/env bash
# report: every kind of result is recognised, the page holds what the records hold, and what it says replays.
source "$(dirname "$0")/common.bash"
cd "$scratch"
ends_well_or_finds() { "$TRIBUNAL" "$@" >out 2>err || [ $? -eq 1 ] || { cat err >&2; exit 1; }; }

# A user's own plugin, in the three commands of the README.
plugin libmine "$SOURCE_DIR/docs/examples/moeller_trumbore.c"
expect 1 fuzz --plugin ./libmine.so --method my-mt,mt-double,sf-filtered --count 6000 --out mine
expect 0 report mine --out mine.html
says out 'my-mt: wrong in' && says out 'sf-filtered: nothing wrong in' && says out '1 results, '

# Everything that can be reported, in directories below one.
mkdir -p 'all/a b' all/bench
cp -r mine "all/a b/it's"
ends_well_or_finds fuzz --relations --method sf-double --count 2000 --out all/relations
ends_well_or_finds cases --count 600 --out cases.jsonl
ends_well_or_finds classify --method mt-double,mt-float --in cases.jsonl --out answers.jsonl
ends_well_or_finds judge --cases cases.jsonl --answers answers.jsonl --convention transversal --out all/judged
ends_well_or_finds sweep --method sf-double,sf-filtered --axis sliver,fill --count 100 --out all/sweep
ends_well_or_finds sweep --method sf-double,sf-float --map vertex --map-size 24 --out all/sweep
ends_well_or_finds leak "$SOURCE_DIR/data/meshes/pig.off" --method mt-float,sf-filtered --rays 3000 --out all/leak
ends_well_or_finds render "$SOURCE_DIR/data/scenes/elephant.json" --size 120x90 --method mt-float --against sf-filtered -o all/elephant.png
echo '{"context":{"host_name":"secret-host","executable":"/secret","num_cpus":2},"benchmarks":[{"name":"x","cpu_time":1.5}]}' >all/bench/bench-x.json
expect 0 report all --out all.html --json all.json
says out '9 results, '

"${PYTHON:-python3}" - "$TRIBUNAL" <<'EOF'
import json, re, subprocess, sys
program = sys.argv[1]
page = open("all.html", encoding="utf-8").read()
text = re.search(r'<script type="application/json" id="tribunal-data">(.*?)</script>', page, re.S).group(1)
data = json.loads(text)
assert data == json.load(open("all.json")), "the page holds the JSON"
assert "<" not in text and "secret" not in text
runs = {run["kind"]: run for run in data["runs"]}
assert set(runs) == {"fuzz", "relations", "certificate", "sweep", "map", "leak", "render", "bench"}, set(runs)
assert sum(run["kind"] == "certificate" for run in data["runs"]) == 2, "a judged method each"

# The worst first: levels never get worse.
levels = "plain fault leaks boundary extreme relations refused incomplete pictures nothing".split()
order = [levels.index(line["level"]) for line in data["verdicts"]]
assert order == sorted(order) and order[0] < order[-1], order

# The table of counts adds up to the record.
record = json.load(open("all/a b/it's/summary.json"))
fuzz = runs["fuzz"]
column = {name: i for i, name in enumerate(fuzz["counts"]["columns"])}
cell = lambda row, name: row[column[name]] if column[name] < len(row) else 0
for name in ("asked", "wrong", "unsupported"):
    assert sum(cell(r, name) for r in fuzz["counts"]["rows"]) == sum(r[name] for r in record["counts"]), name
totals = fuzz["totals"]
at = {name: i for i, name in enumerate(totals["columns"])}
assert sum(r[at["wrong"]] for r in totals["rows"]) == sum(r["wrong"] for r in record["counts"])
assert all(r[at["lower"]] <= r[at["share"]] <= r[at["upper"]] for r in totals["rows"])

# Every case replays by the command beside it, also from a directory whose name has a blank and a quote.
tried = set()
for shown in data["cases"]:
    if shown["run"] in tried:
        continue
    tried.add(shown["run"])
    command = shown["replay"].replace("| tribunal", "| " + program)
    said = subprocess.run(["bash", "-c", command], capture_output=True, text=True)
    assert said.returncode in (0, 1) and shown["case"]["id"] in said.stdout, (command, said)
assert len(tried) >= 5, tried

# A pixel of a map is a case that can be made from the record alone.
record = runs["map"]["record"]
half, size = record["size"] // 2, record["size"]
for panel, (x, y) in zip(record["panels"], ((3, 20), (19, 2))):
    fmt = panel["fmt"]
    unit, base = float.fromhex(record["unit"][fmt]), record["base"][fmt]
    point = [float.fromhex(v) for v in base["seg"][0]]
    moved = [point[0] + (x - half) * unit, point[1] + (y - half) * unit, point[2]]
    shown = subprocess.run([program, "sweep", "--map", record["map"], "--map-size", str(size), "--method", panel["method"],
                            "--pixel", f"{panel['method']},{x},{y}"], capture_output=True, text=True, check=True).stdout
    case = json.loads(shown.splitlines()[0])
    assert [float.fromhex(v) for v in case["seg"][0]] == moved, (case, moved)
    assert case["seg"][1] == base["seg"][1] and case["tri"] == base["tri"]

# Pictures: a differing pixel is a case, or says why it is none.
render = runs["render"]
pixels, words = render["record"]["pixels"]["rows"], render["record"]["pixels"]["words"]["why"]
why = [words[row[4]] for row in pixels]
assert len(pixels) == render["record"]["difference"]["pixels"]
assert why.count("face") == render["record"]["difference"]["cases"] == render["verdict_pixels"]["method"] - why.count("order")
assert why.count("start") == render["record"]["difference"]["parted_on_start_only"] == render["verdict_pixels"]["start"] > 0
for row, reason in zip(pixels, why):
    assert (row[5] is not None) == (reason == "face")
    if row[5] is not None:
        assert data["cases"][row[5]]["case"]["id"].startswith(f"px-{row[0]}-{row[1]}-")
for key in ("method", "against", "difference"):
    picture = data["images"][render["images"][key]]
    assert (picture["width"], picture["height"]) == (120, 90) and picture["uri"].startswith("data:image/png;base64,iVBOR")
for threshold in runs["sweep"]["record"]["thresholds"]:
    assert data["cases"][threshold["case"]]["case"]["id"] == threshold["witness"]

# Exact signs of what was found are those of the finding, and the answers those of the methods.
for shown in data["cases"]:
    exact = shown["signs"] and shown["signs"]["exact"]
    assert len(shown["answers"]) in (0, len(data["answer_methods"]))
    if exact and shown.get("method") and shown["answers"] and shown.get("answered") is not None and shown["method"] in data["answer_methods"]:
        # A dash: the answer was judged, and the method itself does not take such coordinates.
        letter = shown["answers"][data["answer_methods"].index(shown["method"])]
        assert letter in ("-", str(shown["answered"])), shown["case"]["id"]
EOF

# A sweep: how many of how many, where it begins, and no bound; rays at a mesh apart.
ends_well_or_finds sweep --method sf-double,sf-filtered --axis sliver,fill,afar --count 40 --out swept
expect 0 report swept --out swept.html
says out ' binary64 cases along 2 axes; fails first on the axis ' && says out ' binary64 rays at a mesh along the axis afar'
says out 'sf-filtered: nothing wrong of ' && lacks out 'confidence'

# Commands make their records again, with the options that they hold; where a record lacks one, there is no command.
commands_of() {  # DIR: a line each in the file commands
  expect 0 report "$1" --out one.html --json one.json
  "${PYTHON:-python3}" -c 'import json; [print(run["command"]) for run in json.load(open("one.json"))["runs"]]' >commands
}
remakes() {  # DIR RECORD…: the one command of the directory makes these files again, byte for byte but for the environment
  commands_of "$1" && mkdir kept && (cd "$1" && cp "${@:2}" "$scratch/kept" && rm "${@:2}")
  [ "$(wc -l <commands)" -eq 1 ] || { cat commands >&2; exit 1; }
  sed "s|^tribunal|$TRIBUNAL|" commands >again.sh
  bash again.sh >/dev/null 2>&1 || [ $? -eq 1 ]
  for file in "${@:2}"; do cmp "kept/$file" "$1/$file"; done
  rm -r kept
}
ends_well_or_finds fuzz --relations --method sf-double --family ulp,affine --cases cases.jsonl --count 800 --out again/relations
remakes again/relations relations.json
says commands '--family ulp,affine --cases cases.jsonl' && rm -r again
mkdir again && ends_well_or_finds render "$SOURCE_DIR/data/meshes/pig.off" --size 40x30 --method mt-float --against sf-filtered \
  --scale 1e-6 --camera 1e-6,2e-6,3e-6 --up z --max-cases 3 -o again/pig.png
remakes again pig.diff.json pig.cases.jsonl
rm -r again
expect 1 certify --method sf-double --budget quick --cases cases.jsonl --out again && commands_of again && says commands None && lacks commands tribunal
ends_well_or_finds sweep --method sf-double --axis afar --count 20 --mesh "$SOURCE_DIR/data/meshes/cow.off" --out again/own
ends_well_or_finds sweep --method sf-double --axis afar --count 20 --out again/torus
commands_of again/own && says commands None
commands_of again/torus && says commands 'tribunal sweep --method sf-double --axis afar --seed 1 --count 20 --out again/torus'
expect 1 leak "$SOURCE_DIR/data/meshes/cow.off" --method mt-eps-double --format binary64 --rays 700 --seed 3 --every-face --out again/leak
remakes again/leak summary.json cases.jsonl
says commands '--method mt-eps-double --format binary64 --seed 3 --rays 700 --every-face --out again/leak'

# The same bytes again; fewer cases on request, and the rest is counted.
expect 0 report all --out again.html && cmp all.html again.html
expect 0 report all --out few.html --max-cases 7
says out ', 7 cases' && says out 'left out: '

# Nothing to report, records that no command wrote, and options that clash: one line each, and no page.
mkdir empty broken
expect 3 report empty --out no.html && says err 'empty: holds no result, expected a file that fuzz,' && [ "$(wc -l <err)" -eq 1 ]
expect 3 report nowhere --out no.html && says err 'nowhere: cannot be read as a directory'
expect 2 report --out no.html && says err 'no directory given'
expect 2 report all --out x.html --json ./x.html && says err 'would both write'
expect 2 report all --out x.html --classes ./x.html && says err 'would both write'
expect 2 report --json x.html --classes ./x.html && says err 'would both write'
[ ! -e x.html ]
expect 0 report mine --out x.html --classes - && lacks out 'results, '
"${PYTHON:-python3}" -m json.tool out >/dev/null
ln -s mine linked
expect 0 report . ./mine mine/../mine linked --out x.html
cp out of-all
expect 0 report . --out x.html && cmp out of-all
sed 's/"asked": [0-9]*/"asked": "many"/' mine/summary.json >broken/summary.json
expect 3 report all broken --out no.html && says err 'broken/summary.json: counts[0].asked: expected a whole number' && [ "$(wc -l <err)" -eq 1 ]
head -c 1000 mine/summary.json >broken/summary.json
expect 3 report broken --out no.html && [ "$(wc -l <err)" -eq 1 ]
cp mine/summary.json broken && echo '{"id":"x","seg":[[0,0,0]],"tri":[]}' >broken/counterexamples.jsonl
expect 3 report broken --out no.html && says err 'broken/counterexamples.jsonl:1:'
mkdir -p deep/1/2/3/4/5/6/7/8/9/10/11/12/13/14/15/16/17/18/19/20 && cp -r mine deep/mine
expect 0 report deep --out deep.html
(ulimit -n 14 && expect 3 report deep --out no.html && says err ': cannot be read' && [ "$(wc -l <err)" -eq 1 ])
cp mine/summary.json deep/1 && ln -s nowhere deep/summary.json && ln -s summary-loop.json deep/summary-loop.json && expect 0 report deep --out deep.html
ln -s counterexamples.jsonl deep/1/counterexamples.jsonl  # to itself
expect 3 report deep --out no.html && says err 'deep/1/counterexamples.jsonl: cannot read: ' && [ "$(wc -l <err)" -eq 1 ]
[ ! -e no.html ]

# Terminals are not steered by names.
mkdir escape
sed 's/my-mt/my\\u001b[31mt/' mine/summary.json >escape/summary.json
expect 2 report escape --out $'escape\033[31m.html' && says err 'found "escape\u001b[31m.html"' && lacks err $'\033'
expect 0 report escape --out escape.html && says out 'my\u001b[31mt: wrong in' && lacks out $'\033'

# The atlas in docs/ is the one that the program's classes make.
"${PYTHON:-python3}" "$SOURCE_DIR/docs/atlas.py" "$TRIBUNAL" drawn
diff -r drawn/atlas "$SOURCE_DIR/docs/atlas"
diff drawn/atlas.md "$SOURCE_DIR/docs/atlas.md"
