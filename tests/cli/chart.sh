#!/usr/bin/env bash
# The chart: everything is drawn from the record, and what a mark looks like and where it stands follows from it.
source "$(dirname "$0")/common.bash"
cd "$scratch"

# A plugin in binary32, and a method of polygons alone, which has nothing to be judged on among triangles.
sed -e 's/TRIBUNAL_BINARY64/TRIBUNAL_BINARY32/' -e 's/my-mt/my-quick/' "$SOURCE_DIR/docs/examples/moeller_trumbore.c" >quick.c
grep -q TRIBUNAL_BINARY32 quick.c
plugin quick quick.c
methods=my-quick,mt-double,sf-double,sf-filtered,haines-double
expect 0 chart --plugin quick.so --method $methods --count 326 --repetitions 9 --threads 2 --scenes "$SOURCE_DIR/data/scenes/slivers.json" \
  --mesh "$SOURCE_DIR/data/meshes/cow.off" --rays 500 --quick --out charts
says out 'pictures, leaks'
figures='speed-accuracy speed-accuracy-shares speed-accuracy-polygons speed pictures leaks'
for figure in $figures; do
  for ending in svg pdf png; do [ -s charts/$figure.$ending ] || { echo "no $figure.$ending" >&2; exit 1; }; done
done

expect 0 report charts --out page.html --json page.json
says page.json "\"command\":\"tribunal chart --method $methods --seed 1 --count 326 --repetitions 9 --scenes $SOURCE_DIR/data/scenes/slivers.json --mesh $SOURCE_DIR/data/meshes/cow.off --rays 500 --quick --out charts\""

# Drawn again from chart.json alone, without the plugin: the same bytes, nothing measured.
mkdir again
cp charts/chart.json again
expect 0 chart --redraw again
diff -r charts again
sed -i '0,/"title": "Random, 7 % hits"/s//"title": "Random, so many"/' again/chart.json
expect 0 chart --redraw again
! cmp -s charts/speed-accuracy.svg again/speed-accuracy.svg || { echo "not drawn from the record" >&2; exit 1; }
expect 3 chart --redraw nowhere
for given in '--method sf-double' '--seed 2' '--count 5' '--repetitions 9' '--rays 5' '--threads 1'; do
  expect 2 chart --redraw again $given
done

# What cannot be drawn: for want of a module, or because the record is of another version. The first error is kept.
mkdir bare older
echo 'raise ModuleNotFoundError("none", name="matplotlib")' >bare/matplotlib.py
export PYTHONPATH=$PWD/bare
expect 7 chart --redraw again
says err 'python3 with matplotlib'
# For want of memory, wherever it runs out, nothing is said of the record; nor where a figure cannot be written.
echo 'raise MemoryError' >bare/matplotlib.py
expect 7 chart --redraw again && says err 'Python gave up' && grep -q MemoryError again/plot.log
rm bare/matplotlib.py && printf 'import json\ndef load(file): raise MemoryError\njson.load = load\n' >bare/sitecustomize.py
expect 7 chart --redraw again && says err 'Python gave up' && grep -q MemoryError again/plot.log
printf 'import json\ndef load(file): raise OSError(28, "No space left on device")\njson.load = load\n' >bare/sitecustomize.py
expect 5 chart --redraw again && says err 'cannot write the figures' && grep -q 'No space left' again/plot.log
# What Python says is text from elsewhere too.
printf 'import json\ndef load(file): raise KeyError("a\\x1b[31m\\u202e") from Exception("b\\x1b[31m\\u202e\\udcff")\njson.load = load\n' >bare/sitecustomize.py
expect 3 chart --redraw again && grep -q 'Exception: b.u001b' again/plot.log
lacks again/plot.log $'\e'
rm bare/sitecustomize.py
unset PYTHONPATH
sed 's/"yardstick": "mt-double"/"yard": "mt-double"/' charts/chart.json >older/chart.json
expect 3 chart --redraw older
says err 'chart.json: not as this version writes it'
grep -q "KeyError: 'yardstick'" older/plot.log
expect 0 chart --redraw again

# Where marks stand and what they look like, by the script's own functions.
/usr/bin/python3 - <<'PYTHON'
import json
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, "charts")
import plot
import plot_marks as marks

record = json.load(open("charts/chart.json"))
by_name = plot.Methods(record).by_name
assert marks.arithmetic_of(by_name["my-quick"]) == "binary32" and by_name["my-quick"]["maker"] == "plugin"
assert marks.arithmetic_of(by_name["sf-filtered"]) == "certified"
assert marks.arithmetic_of(by_name["mt-double"]) == "binary64"
assert len({shape for shape, _ in marks.ARITHMETIC.values()}) == 4, "in greyscale, shapes tell arithmetic"
assert len({fill for _, fill, _ in marks.MAKERS.values()}) == 4, "and fills tell makers"

# One wrong of many stands above none wrong of few, and of more than that.
some = {"left": 0.9, "x": 1, "right": 1.1}
rows = [{"method": "mt-double", **some, "wrong": 1, "n": 10**9, "share": 1e-9, "lower": 2.5e-11, "upper": 5.6e-9},
        {"method": "sf-filtered", **some, "wrong": 0, "n": 50, "share": 0, "lower": 0, "upper": 0.06},
        {"method": "sf-double", **some, "wrong": 0, "n": 10**9, "share": 0, "lower": 0, "upper": 3e-9}]
ax = marks.plt.figure(figsize=(2, 2)).add_axes((0.2, 0.2, 0.7, 0.7))
ax.set_xscale("log")
ax.set_xlim(0.1, 10)
scale = marks.Scale(rows)
points = {p["name"]: p for p in marks.draw_panel(ax, rows, plot.Methods(record), scale)}
for none in ("sf-filtered", "sf-double"):
    assert points[none]["y"] < scale.floor < points["mt-double"]["low"] < points["mt-double"]["y"], points
assert points["sf-filtered"]["text"].endswith("*") and not points["sf-double"]["text"].endswith("*"), "judged on fewer"

# The frontier has those than which none is better both ways.
row = lambda name, x, share: {"x": x, "share": share, "name": name}
assert [p["name"] for p in marks.frontier_of([row("a", 1, 0.5), row("b", 2, 0.6), row("c", 3, 0)], True)] == ["a", "c"]
assert [p["name"] for p in marks.frontier_of([row("a", 1, 0.5), row("b", 2, 0.6), row("c", 3, 0)], False)] == ["c"]

# Who has nothing to be judged on is named, and so is who was judged on less.
panels = [p for p in record["panels"] if p["figure"] == "main"]
notes = "\n".join(plot.unjudged_notes(record, plot.Methods(record), panels))
assert "haines-double" in notes and "all panels of binary64 cases: 1 my-quick" in notes.replace("; ", ", "), notes
PYTHON

# A signal while figures are drawn is no success.
rm -f again/plot.log
"$TRIBUNAL" chart --redraw again >out 2>err & pid=$!
for _ in $(seq 500); do compgen -G "again/.tribunal-*/plot.log" >globbed && break; sleep 0.02; done
kill -TERM $pid
status=0
wait $pid || status=$?
[ "$status" -eq 143 ] || { echo "a signal while drawing: exit $status" >&2; exit 1; }
says err interrupted

# A signal while scenes are drawn loses nothing of what was measured before.
"$TRIBUNAL" chart --method mt-double,mt-float --count 326 --repetitions 9 --scenes "$SOURCE_DIR/data/scenes" --mesh none --out cut >out 2>err & pid=$!
for _ in $(seq 3000); do [ -e cut/chart.json ] && break; sleep 0.02; done
kill -TERM $pid
status=0
wait $pid || status=$?
[ "$status" -eq 143 ] || { echo "a signal while scenes are drawn: exit $status" >&2; exit 1; }
says err 'chart.json holds the parts before'
expect 0 chart --redraw cut
lacks out pictures
says out 'speed-accuracy-shares, speed, each'
[ ! -e cut/speed-accuracy-polygons.svg ]
