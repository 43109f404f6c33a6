#!/usr/bin/env bash
# Polygons through every command that tries a method: one seed, the same bytes; certificates that are held against their
# log; cases out, answers in; plugins with a polygon test of their own.
source "$(dirname "$0")/common.bash"
cd "$scratch"

# fuzz: 1, 2 and 7 threads, and after interrupts with another number of threads each time.
plan=(fuzz --family polygon-affine,polygon-ulp,polygon-rounded --method haines-double,sf-float --seed 3 --count 12000 --keep 4)
expect 1 "${plan[@]}" --threads 1 --out one
says out 'constructions 774/774' && says one/summary.json 'comb / outer corner / through'
expect 1 "${plan[@]}" --threads 2 --out two
expect 1 "${plan[@]}" --threads 7 --out seven
diff -r one two
diff -r one seven
interrupt_and_resume "${plan[@]}"
diff -r one parts
sha256sum one/summary.json two/summary.json seven/summary.json parts/summary.json
expect 2 fuzz --family polygon-affine --method sf-float --seed 3 --count 12000 --out first-part --resume && says err 'other methods, families, seed or count'
expect 2 fuzz --method sf-float --seed 3 --count 12000 --out first-part --resume && says err 'other methods, families, seed or count'
expect 2 "${plan[@]}" --out first-part && says err 'is of an interrupted run'
sed -i '3s/[0-9]/7/3' first-part/checkpoint.jsonl
expect 3 "${plan[@]}" --out first-part --resume && says err 'checkpoint.jsonl:3:'

# Findings carry every method's answer and replay to the same verdict; shrink leaves them as they are.
says one/counterexamples.jsonl '"answers":{"sf-float":' && says one/counterexamples.jsonl '"made_with":{"program"'
expect 1 replay one/counterexamples.jsonl && says out WRONG && says out 'outer[0] = ('
head -n 1 one/counterexamples.jsonl >first.jsonl
expect 0 shrink first.jsonl --out shrunk.jsonl && cmp first.jsonl shrunk.jsonl

# Relations need no oracle; broken ones leave a query and its change.
expect 1 fuzz --family polygon-affine,polygon-grid --method sf-epick,sf-float --relations --count 2000 --threads 1 --out rel1
expect 1 fuzz --family polygon-affine,polygon-grid --method sf-epick,sf-float --relations --count 2000 --threads 3 --out rel3
diff -r rel1 rel3
says out 'start-vertex'
says rel1/witnesses.jsonl '"id":"sf-float-start-vertex-binary32-segment-2"'
! grep -q sf-epick rel1/witnesses.jsonl || { echo "an exact method broke a relation" >&2; exit 1; }
expect 0 classify --method sf-epick --in rel1/witnesses.jsonl
expect 2 fuzz --family polygon-affine --method mt-double && says err 'mt-double takes no polygons'
expect 2 fuzz --family polygon-affine,ulp --method sf-double && says err 'ask for it apart'
expect 2 fuzz --family polygon-afine --method sf-double && says err 'did you mean "polygon-affine"?'
expect 2 fuzz --family polygon-ulp,polygon-ulp --method sf-double && says err 'named twice'

# Cases out, answers in: polygons alone, and among triangles.
expect 0 cases --family polygon-affine,polygon-warped --count 400 --out cases.jsonl
expect 0 cases --family polygon-affine,polygon-warped --count 400 --with-answers --out answered.jsonl
expect 0 cases --family affine --count 100 --out triangles.jsonl
cat triangles.jsonl >>cases.jsonl
lacks cases.jsonl expect && says answered.jsonl '"expect":'
expect 0 classify --method sf-rational,sf-float --in cases.jsonl --out answers.jsonl
expect 1 judge --cases cases.jsonl --answers answers.jsonl --out judged --threads 2
says out 'sf-rational: not refuted' && says out 'sf-float: refuted' && says out 'outcomes 9/9'
expect 0 verify judged/1-sf-rational && expect 0 verify judged/2-sf-float
expect 1 replay judged/2-sf-float/counterexamples.jsonl
/usr/bin/python3 "$SOURCE_DIR/docs/check_polygon_counterexample.py" judged/2-sf-float/counterexamples.jsonl
head -n 1 answers.jsonl >few.jsonl
expect 3 judge --cases cases.jsonl --answers few.jsonl && says err 'are missing'
expect 2 cases --family polygon-affine --count 2500001 --out x && says err 'at most 2500000 polygons'
head -n 40 answered.jsonl >some.jsonl
sed -n 's/^{"id":"\([^"]*\)".*"expect":\([01]\).*/{"id":"\1","hit":\2}/p' some.jsonl >right.jsonl
expect 0 judge --cases some.jsonl --answers right.jsonl && says out 'binary64: 0 wrong of 20' && says out 'binary32: 0 wrong of 20'

# A certificate on polygons, with rings of the user's own, and what it notices.
frame='[[[0,0,0],[9,0,0],[9,9,0],[0,9,0]],[[4,4,0],[6,4,0],[6,6,0],[4,6,0]]]'
echo "{\"id\":\"in the hole\",\"seg\":[[5,5,1],[5,5,-1]],\"rings\":$frame,\"expect\":0}" >mine.jsonl
sed 's/"seg"/"fmt":"binary32","seg"/' mine.jsonl | cat - mine.jsonl >twice.jsonl
expect 1 certify --polygons --method sf-float --cases twice.jsonl --threads 2 --out certificate
says out 'constructions 774/774' && says out 'all rings of 3 to 5 vertices on a 3x3 grid: 0 wrong of 1658442'
says out '  own      binary64: 0 wrong of 0 (-); 1 outside the contract' && says out '  own      binary32: 0 wrong of 1 (0 %)' && says certificate/certificate.md '- binary32: 0 wrong of 1' && says certificate/counterexamples.jsonl '"rings":'
expect 0 verify certificate && says out 'asked again on 217140 cases'
cp -r certificate edited
sed -i '0,/dart \/ outer edge \/ to":\[/s//&1/' edited/log.jsonl
expect 3 verify edited && says err 'edited/log.jsonl:' && says err 'was changed'
cp certificate/log.jsonl edited/log.jsonl
sed -i '0,/"expected":1/s//"expected":0/' edited/counterexamples.jsonl
expect 1 verify edited && says out 'counterexamples.jsonl is not what the log gives'
expect 3 certify --polygons --method sf-float --cases triangles.jsonl --out x && says err 'triangles.jsonl:1: tri: ' && [ ! -e x ]
expect 3 certify --method sf-float --cases mine.jsonl --out x && says err 'mine.jsonl:1: rings: '
expect 2 certify --polygons --method mt-double --out x && says err 'takes no polygons'
sed 's/"expect":0/"expect":1/' mine.jsonl >false.jsonl
expect 3 certify --polygons --method sf-float --cases false.jsonl --out x && says err 'in the hole: the case expects a hit'

# A plugin with a polygon test: like any other, and its mistake is its own.
example=$SOURCE_DIR/docs/examples/crossing_count.c
plugin mine "$example"
plugin planted -DPLANTED_MISTAKE "$example"
expect 0 classify --plugin mine.so --method my-polygons --in mine.jsonl && says out '"hit":0,"status":"ok","contact":"none"'
expect 0 classify --plugin mine.so --method my-polygons --in triangles.jsonl && says out '"status":"unsupported"'
expect 1 fuzz --plugin planted.so --family polygon-affine,polygon-grid --method sf-epick,my-polygons --count 4000 --keep 2 --out found
says out 'my-polygons' && ! grep -v '"method":"my-polygons"' found/counterexamples.jsonl || { echo "another method was blamed" >&2; exit 1; }
says found/counterexamples.jsonl '"fmt":"binary32"'
expect 1 certify --plugin planted.so --method my-polygons --threads 2 --out theirs && says out 'my-polygons: refuted'
expect 0 verify --plugin planted.so theirs && says out 'asked again on 217140 cases'
expect 0 verify theirs && says out 'not asked again: the method is not known here'
no_polygons() { plugin bad "${@:2}" "$SOURCE_DIR/tests/plugin/broken.c" && expect 3 methods --plugin bad.so && says err "bad.so: $1"; }
no_polygons 'tribunal_plugin_describe_polygons returned NULL' -DPOLYGONS=NULL
no_polygons 'ask of polygons is NULL' -DPOLYGONS=\&polygons -DASK_POLYGON=NULL
no_polygons 'restrictions is 9, expected' -DPOLYGONS=\&polygons -DRESTRICTIONS=9
no_polygons 'is made for version 4 of tribunal_plugin.h' -DPOLYGONS=\&polygons -DPOLYGON_ABI=4
plugin seven -DPOLYGONS=\&polygons -DANSWER=7 "$SOURCE_DIR/tests/plugin/broken.c"
expect 3 fuzz --plugin seven.so --family polygon-grid --method broken --count 100 --threads 2 && says err 'seven.so: answered 7'
plugin rounding -DPOLYGONS=\&polygons -DCHANGES_ROUNDING "$SOURCE_DIR/tests/plugin/broken.c"
expect 4 fuzz --plugin rounding.so --family polygon-grid --method broken --count 100 --threads 1 && says err 'changed the rounding mode'
plugin only -DPOLYGONS=\&polygons -DASK=NULL "$SOURCE_DIR/tests/plugin/broken.c"
expect 0 methods --plugin only.so
