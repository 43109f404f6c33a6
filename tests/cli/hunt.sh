#!/usr/bin/env bash
# fuzz from one's own cases, mesh and scene; --until-first; what a run notes of its data; bad data.
source "$(dirname "$0")/common.bash"
cd "$scratch"
cat >mine.jsonl <<'CASES'
{"id":"wall","seg":[[4323,-1230,562],[4322,-1238.5,561]],"tri":[[4321.125,-1234.5,560],[4327.125,-1234.5,560],[4321.125,-1234.5,566]]}
{"id":"up","ray":{"o":[4323,-1234.5,550],"d":[0,0,1]},"tri":[[4321.125,-1234.5,560],[4327.125,-1234.5,560],[4321.125,-1234.5,566]]}
{"id":"near","ray":{"o":[4323,-1230,562],"d":[0.25,-1,0.125],"t":[0.1,4.5]},"tri":[[4321.125,-1234.5,560],[4327.125,-1234.5,560],[4321.125,-1234.5,566]]}
{"id":"floor","fmt":"binary32","seg":[[1,1,1],[1,1,-1]],"tri":[[0,0,0],[4,0,0],[0,4,0]]}
CASES
cat >house.off <<'MESH'
OFF
5 6 0
0 0 0
3.3 0 0
3.3 4.1 0
0 4.1 0
1.7 2.1 2.9
3 0 1 4
3 1 2 4
3 2 3 4
3 3 0 4
3 0 2 1
3 0 3 2
MESH
cat >scene.json <<'SCENE'
{"camera":{"eye":[0.3,-6,1.1],"look_at":[0.2,0,0],"up":[0,0,1],"fov":40,"width":24,"height":18},
 "solids":[{"mesh":"house.off","reflection":0.5}],"lights":[{"position":[5,-5,9]}]}
SCENE

# A method that is right finds nothing; own data alone, its hash, items and counts by class are in the summary.
expect 0 fuzz --method sf-filtered --cases mine.jsonl --mesh house.off --scene scene.json --count 12000 --out right
says out 'own-cases' && says out 'own-mesh' && says out 'own-scene' && lacks out 'affine' && says out 'own-cases: mine.jsonl, 4 used, SHA-256'
says right/summary.json "\"sha256\": \"$(sha256sum <mine.jsonl | cut -d' ' -f1)\"" && says right/summary.json '"items": 4' && says right/summary.json '"class": "R'
# One that is wrong is found out near each of them, as the same bytes for any number of threads.
for data in '--cases mine.jsonl' '--mesh house.off' '--scene scene.json'; do
  # shellcheck disable=SC2086
  expect 1 fuzz --method sf-double $data --count 40000 --threads 1 --out one && mv one/summary.json one.json
  # shellcheck disable=SC2086
  expect 1 fuzz --method sf-double $data --count 40000 --threads 3 --out one && diff one.json one/summary.json
  says one/counterexamples.jsonl '"origin"' && says one/counterexamples.jsonl '"sha256"' && expect 1 replay one/counterexamples.jsonl
done
expect 1 fuzz --method sf-double --cases mine.jsonl --family plain,near --count 40000 && says out 'plain' && says out 'near' && says out 'own-cases'
expect 1 fuzz --method sf-double --cases mine.jsonl --relations --count 20000

# Until the first: one counterexample, the same for any number of threads, and the only thing that is printed.
for threads in 1 2 5; do
  expect 1 fuzz --method mt-double,sf-double --cases mine.jsonl --until-first --threads $threads --out first$threads
  says out 'the first finding, case ' && lacks out 'classes judged' && [ "$(wc -l <first$threads/counterexamples.jsonl)" -eq 1 ]
  diff -r first1 first$threads
done
expect 0 fuzz --method sf-filtered --cases mine.jsonl --until-first --count 5000 && says out 'no finding' && says out 'classes judged'
expect 2 fuzz --cases mine.jsonl --until-first --relations
expect 1 fuzz --method mt-double --until-first && says out 'the first finding'

# An interrupted run goes on with the same data only.
status=0
timeout --foreground --preserve-status -s INT 1 "$TRIBUNAL" fuzz --method sf-rational --cases mine.jsonl --count 900000000 --out part >out 2>err || status=$?
[ "$status" -eq 130 ]
says part/checkpoint.jsonl '"numbers_sha256"'
cp mine.jsonl kept.jsonl
sed -i 's/4322,/4322.5,/' mine.jsonl
expect 2 fuzz --method sf-rational --cases mine.jsonl --count 900000000 --out part --resume && says err 'other data of your own, or changed since'
cp kept.jsonl mine.jsonl
expect 2 fuzz --method sf-rational --cases mine.jsonl --count 900000000 --out part --resume --until-first && says err 'another way to end'

# Polygons, and files that hold both.
echo '{"id":"ring","seg":[[1,1,9],[2,3,-1]],"rings":[[[0,0,7],[12,0,7],[12,8,7],[0,8,7]],[[3,3,7],[6,3,7],[3,5,7]]]}' >rings.jsonl
expect 1 fuzz --method feito-double --cases rings.jsonl --count 8000 && says out 'own-cases'
expect 0 fuzz --method sf-filtered --cases rings.jsonl --family polygon-ulp --count 2000
cat mine.jsonl rings.jsonl >both.jsonl
expect 0 fuzz --method sf-filtered --cases both.jsonl --count 2000 && says out '4 used' && says out 'not used: 1 about polygons'
expect 0 fuzz --method sf-filtered --cases both.jsonl --family polygon-ulp --count 2000 && says out '1 used'
expect 2 fuzz --method sf-filtered --mesh house.off --family polygon-ulp && says err '--mesh and --scene ask about triangles'
expect 2 fuzz --method mt-double --cases rings.jsonl && says err 'mt-double takes no polygons'

# Bad data: one line, and exit code 3; nothing is written.
fails() { expect 3 fuzz --method sf-double "$@" --out bad && [ ! -e bad ] && [ "$(wc -l <err)" -eq 1 ]; }
: >empty.jsonl
fails --cases empty.jsonl && says err 'empty.jsonl: holds no cases'
echo '{"id":"x","seg":[[0,0,1],[0,0]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}' >short.jsonl
fails --cases short.jsonl && says err 'short.jsonl:1:'
fails --cases rings.jsonl --family affine && says err 'holds no case about triangles'
fails --cases nowhere.jsonl
fails --mesh nowhere.off && fails --mesh mine.jsonl && fails --scene nowhere.json && fails --scene mine.jsonl
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 nan\n3 0 1 2\n' >nan.off
fails --mesh nan.off && says err 'nan.off:5:'
sed 's/"look_at":\[0.2,0,0\]/"look_at":[0.3,-12,1.1]/' scene.json >away.json
fails --scene away.json && says err 'no ray of its picture hits a triangle'
expect 2 fuzz --method sf-float --cases mine.jsonl --count 2 --seed x
# A test of rays alone is told of segments alone that nothing was judged.
head -n 1 mine.jsonl >segments.jsonl
cat >rays.c <<'C'
#include "tribunal_plugin.h"
static int ask(int probe, const double* query) { (void)probe; (void)query; return 0; }
static const tribunal_plugin rays = {.abi = TRIBUNAL_PLUGIN_ABI, .name = "rays-only", .summary = "misses every ray",
                                     .format = TRIBUNAL_BINARY64, .convention = TRIBUNAL_CLOSED, .ask = ask,
                                     .operands = TRIBUNAL_NO_SEGMENTS};
const tribunal_plugin* tribunal_plugin_describe(void) { return &rays; }
C
plugin rays rays.c
expect 2 fuzz --plugin rays.so --method rays-only --cases segments.jsonl --count 2000 && says err 'nothing was judged'
expect 1 fuzz --plugin rays.so --method rays-only --cases mine.jsonl --until-first --count 2000 && says out 'the first finding'

expect 0 fuzz --help && says out '--until-first' && says out 'fuzz --cases mine.jsonl'
