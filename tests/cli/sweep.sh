#!/usr/bin/env bash
# Sweeps from end to end: thresholds and their witnesses, figures drawn again from the record alone, failure maps and
# their pixels as cases.
source "$(dirname "$0")/common.bash"
cd "$scratch"

expect 0 sweep --method mt-float,sf-double,sf-filtered --axis scale,ulps --count 328 --threads 2 --out run
says out 'sf-filtered: nothing wrong of'
says out 'scale +'
says out ': none (<= '
lacks err 'tribunal'
for file in sweep.json sweep.csv witnesses.jsonl thresholds.svg thresholds.png axis-scale.svg axis-ulps.png; do
  [ -s "run/$file" ] || { echo "no run/$file" >&2; exit 1; }
done
[ ! -e run/plot.log ]

# Any number of threads, the same bytes.
expect 0 sweep --method mt-float,sf-double,sf-filtered --axis scale,ulps --count 328 --threads 3 --out again
for file in sweep.json sweep.csv witnesses.jsonl thresholds.svg axis-scale.svg; do cmp "run/$file" "again/$file"; done

# Every witness is a counterexample to the method that it names, by its own evidence too.
expect 1 replay run/witnesses.jsonl
python3 "$SOURCE_DIR/docs/check_counterexample.py" run/witnesses.jsonl >checked || { cat checked >&2; exit 1; }
[ "$(grep -c '"witness"' run/sweep.json)" -eq "$(wc -l <run/witnesses.jsonl)" ]

# Drawn again from the record alone, by the program and by the script beside it.
mkdir drawn
cp run/sweep.json drawn
expect 0 sweep --redraw drawn
for file in thresholds.svg axis-scale.svg axis-ulps.svg; do cmp "run/$file" "drawn/$file"; done
rm drawn/*.svg drawn/*.png
/usr/bin/python3 drawn/plot.py drawn/sweep.json drawn
cmp run/thresholds.svg drawn/thresholds.svg

# The figure of an axis joins measured rates alone; a bound is drawn apart, as one.
/usr/bin/python3 - <<'PYTHON'
import json, math, sys
sys.path.insert(0, "drawn")
import plot
record = json.load(open("drawn/sweep.json"))
joined = bounds = 0
for axis in record["axes"]:
    rows = [r["wrong"] for r in record["rows"] if r["axis"] == axis["name"]]
    rates = {w["share"] for w in rows if w["k"]}
    upper = {w["upper"] for w in rows if not w["k"]}
    for ax in plot.axis_figure(record, axis).axes:
        for line in ax.lines:
            ys = [y for y in line.get_ydata() if not math.isnan(y)]
            if line.get_linestyle() not in ("None", "") and line.get_linewidth() > 1:
                assert set(ys) <= rates, (axis["name"], ys)
                joined += len(ys)
            elif line.get_marker() == plot.BOUND:
                assert set(ys) <= upper and line.get_markerfacecolor() == "white", (axis["name"], ys)
                bounds += len(ys)
assert joined > 20 and bounds > 20, (joined, bounds)
PYTHON
mkdir empty
expect 3 sweep --redraw empty

# By default only the methods that take what the axis asks.
expect 0 sweep --axis vertices --count 40 --out polygons
lacks out 'mt-double'
expect 2 sweep --axis vertices --method mt-double --out no
says err 'none of the axes asks what it takes'
expect 2 sweep --axis slivers --out no
says err 'sliver'
expect 2 sweep --axis scale,scale --out no
[ ! -e no ]

# A failure map: pixels as text, a picture, and each pixel a case that replays as the map says.
expect 0 sweep --map edge --map-size 64 --method sf-float,sf-double,mt-double,sf-filtered --out maps
says out 'sf-filtered'
[ -s maps/map-edge.svg ]
[ -s maps/map-edge.png ]
python3 - maps/map-edge.json >pixels <<'PYTHON'
import json, sys
m = json.load(open(sys.argv[1]))
assert all(len(p["pixels"]) == 64 and all(len(r) == 64 for r in p["pixels"]) for p in m["panels"])
for p in m["panels"]:
    seen = {}
    for y, row in enumerate(p["pixels"]):
        for x, c in enumerate(row):
            seen.setdefault(c, (x, y))
    for c, (x, y) in seen.items():
        print(p["method"], c, x, y)
PYTHON
grep -q '^sf-double [+-]' pixels
! grep -q '^sf-filtered [+-]' pixels || { echo "an exact method has wrong pixels" >&2; exit 1; }
while read -r method c x y; do
  expect 0 sweep --map edge --map-size 64 --pixel "$method,$x,$y"
  mv out pixel.jsonl
  "$TRIBUNAL" replay pixel.jsonl >replayed || true
  verdict=$(grep "^ *$method " replayed)
  case $c in
    [-+c]) [[ $verdict == *WRONG* ]] ;;
    *) [[ $verdict == *right* ]] ;;
  esac || { echo "pixel $x,$y of $method is '$c', replay says $verdict" >&2; exit 1; }
done <pixels
expect 2 sweep --map edge --map-size 64 --pixel sf-double,64,0
says err 'expected a number from 0 to 63'
expect 2 sweep --map edge --pixel sf-double
expect 2 sweep --map corner
expect 0 sweep --redraw maps

# The same of rays: the record has a name of its own, and its pixels replay as they are drawn.
expect 0 sweep --map vertex --probe ray --map-size 32 --method mt-double,sf-filtered --out maps
[ -s maps/map-vertex-ray.svg ]
[ ! -e maps/map-vertex.json ]
python3 - maps/map-vertex-ray.json >pixels <<'PYTHON'
import json, sys
m = json.load(open(sys.argv[1]))
assert m["probe"] == "ray"
wrong = [(x, y) for y, row in enumerate(m["panels"][0]["pixels"]) for x, c in enumerate(row) if c in "+-"]
print(*wrong[0])
PYTHON
read -r x y <pixels
expect 0 sweep --map vertex --probe ray --map-size 32 --pixel "mt-double,$x,$y"
says out '"ray"'
mv out pixel.jsonl
expect 1 replay pixel.jsonl
[[ $(grep '^ *mt-double ' out) == *WRONG* ]]
expect 2 sweep --probe ray --axis scale
expect 0 sweep --redraw maps
says out 'map-vertex-ray.json'

# A mesh seen from afar: its record is that of any axis, it is written, and another one can be given.
expect 0 sweep --axis afar --method mt-double,sf-filtered --count 60 --threads 2 --out afar
says out 'sf-filtered: nothing wrong of'
says out 'double hit'
for file in sweep.json witnesses.jsonl afar.off axis-afar.svg axis-afar.png thresholds.svg; do [ -s "afar/$file" ]; done
grep -q '^afar,binary64,0,mt-double,ray,parity,' afar/sweep.csv
! grep -q '^afar,.*,segment,' afar/sweep.csv || { echo "segments on an axis of rays" >&2; exit 1; }
grep -q '"operands":"mesh"' afar/sweep.json
mkdir redrawn
cp afar/sweep.json redrawn
expect 0 sweep --redraw redrawn
cmp afar/axis-afar.svg redrawn/axis-afar.svg
expect 0 sweep --axis afar --mesh afar/afar.off --method mt-double,sf-filtered --count 60 --threads 3 --out again-afar
cmp afar/afar.off again-afar/afar.off
cmp <(cut -d, -f1-8 afar/sweep.csv) <(cut -d, -f1-8 again-afar/sweep.csv)
cp afar/afar.off 'a$b_{$.off'  # no formula in the figure
expect 0 sweep --axis afar --mesh 'a$b_{$.off' --method sf-filtered --count 3 --out odd-name
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >open.off
expect 3 sweep --axis afar --mesh open.off --out no
says err 'open.off'
expect 2 sweep --axis scale --mesh afar/afar.off --out no
says err '--mesh'
[ ! -e no ]

# The compiler as an axis: strict builds change nothing, contracted ones do, and the figure comes from the record.
expect 0 sweep --axis compiler --method mt-double,woop-double --count 2000 --out built
says out 'g++-contracted'
says out 'mt-double'
python3 - built/compilers.json <<'PYTHON'
import json, sys
r = json.load(open(sys.argv[1]))
changed = {(row["method"], row["build"]): row["changed"] for row in r["rows"]}
assert changed["mt-double", "g++-O2"] == 0 and changed["mt-double", "g++-contracted"] > 10, changed
PYTHON
expect 0 sweep --redraw built
[ -s built/compilers.png ]
expect 2 sweep --axis compiler --method sf-filtered --out no
says err 'is not among the methods that are compiled again'
