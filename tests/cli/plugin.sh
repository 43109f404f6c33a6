#!/usr/bin/env bash
# Methods from shared libraries: the example of docs/ through every command, a planted mistake found and blamed, and
# each way in which a library can be no plugin.
source "$(dirname "$0")/common.bash"
cd "$scratch"

example=$SOURCE_DIR/docs/examples/moeller_trumbore.c
plugin mine "$example"
plugin planted -DPLANTED_MISTAKE "$example"

# The example is a method like any other: it answers as our own Möller–Trumbore does, up to its divisions.
expect 0 methods --plugin mine.so && says out 'my-mt ' && says out 'Moeller & Trumbore 1997'
expect 0 methods --json --plugin ./mine.so && says out '"name":"my-mt","number":"binary64","contract":"segment, ray; any triangle","convention":"transversal","exact":false'
expect 0 methods && lacks out my-mt
cat >cases.jsonl <<'CASES'
{"id":"through","seg":[[0.25,0.25,1],[0.25,0.25,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}
{"id":"short","seg":[[0.25,0.25,3],[0.25,0.25,1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}
{"id":"ray","ray":{"o":[0.25,0.25,3],"d":[0,0,-1]},"tri":[[0,0,0],[1,0,0],[0,1,0]]}
{"id":"beyond","seg":[[0.75,0.75,1],[0.75,0.75,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}
CASES
expect 0 classify --method my-mt --plugin mine.so --in cases.jsonl
diff out - <<'ANSWERS'
{"id":"through","method":"my-mt","hit":1,"status":"ok"}
{"id":"short","method":"my-mt","hit":0,"status":"ok","contact":"none"}
{"id":"ray","method":"my-mt","hit":1,"status":"ok"}
{"id":"beyond","method":"my-mt","hit":0,"status":"ok","contact":"none"}
ANSWERS
cp out answers

# Without --method, every command asks the methods of the plugin, and no plugin is loaded and not asked.
expect 0 classify --plugin mine.so cases.jsonl && cmp out answers
expect 1 fuzz --plugin planted.so --family grazing,sliver --count 20000 && says out 'my-mt: wrong' && lacks out sf-double
expect 0 sweep --plugin mine.so --axis scale --count 164 --out swept && says out 'my-mt: ' && lacks out sf-double
expect 1 certify --plugin planted.so --out certified && says out 'my-mt: refuted'
sed 's/"id":"through"/"expect":1,&/' cases.jsonl >expecting.jsonl
expect 0 check --plugin mine.so expecting.jsonl && says out my-mt
sed 's/my-mt/other-mt/' "$example" >other.c
plugin other other.c
expect 2 certify --plugin mine.so --plugin other.so --out none && says err 'expected one method, found my-mt,other-mt'
expect 0 replay --plugin mine.so cases.jsonl && says out my-mt
expect 1 replay --plugin planted.so cases.jsonl && says out 'WRONG'

# A mistake is found, blamed on the plugin and on nobody else, and shrunk.
expect 1 fuzz --plugin planted.so --method sf-rational,my-mt --family grazing,sliver --count 20000 --threads 3 --out found
says out 'my-mt '
! grep -v '"method":"my-mt"' found/counterexamples.jsonl || { echo "another method was blamed" >&2; exit 1; }
/usr/bin/python3 "$SOURCE_DIR/docs/check_counterexample.py" found/counterexamples.jsonl
expect 1 fuzz --plugin planted.so --method sf-rational,my-mt --family grazing,sliver --count 20000 --threads 1 --out again
diff -r found again
expect 1 replay --plugin planted.so found/counterexamples.jsonl
head -n 1 found/counterexamples.jsonl >first.jsonl
expect 0 shrink --plugin planted.so first.jsonl --out shrunk.jsonl && cmp first.jsonl shrunk.jsonl
expect 3 shrink first.jsonl && says err 'names an unknown method, my-mt, expected one that' && [ "$(wc -l <err)" -eq 1 ]
expect 2 shrink first.jsonl --method nobody && says err 'unknown method nobody'
expect 1 certify --plugin planted.so --method my-mt --out certificate && says out 'my-mt: refuted'
expect 0 chart --plugin mine.so --method my-mt,mt-double --count 600 --repetitions 9 --threads 1 --out charts && says charts/chart.json my-mt

# A relation shows an absolute epsilon where sound tests in binary64 keep it; t is told, and how far off it is.
plugin epsilon -DABSOLUTE_EPSILON=1e-9 "$example"
expect 0 fuzz --relations --plugin mine.so --method my-mt --family plain --count 2000
expect 1 fuzz --relations --plugin epsilon.so --method my-mt --family plain --count 2000 --out relations
/usr/bin/python3 - <<'PYTHON'
import json
rows = [r for r in json.load(open("relations/relations.json"))["relations"] if r["relation"] == "scale"]
assert {(r["fmt"], r["probes"]) for r in rows} == {(f, p) for f in ("binary32", "binary64") for p in ("ray", "segment")}
assert all(20 * r["broken"] > r["asked"] > 100 for r in rows), rows
PYTHON
expect 0 fuzz --plugin mine.so --method my-mt --family plain --count 8000 --out numbers && says out 'my-mt                  plain     binary64   t: half within'

# A library of version 1, compiled with the header of that time, is the same method to the byte; what follows its shorter
# description in memory is not read.
old=$SOURCE_DIR/tests/plugin/version1
${CC:-cc} -std=c99 -pedantic -Wall -Wextra -Werror -O2 -ffp-contract=off -shared -fPIC -I "$old" -o version1.so "$old/moeller_trumbore.c" -lm
expect 0 methods --json --plugin version1.so && grep '"my-mt"' out | sed 's/sha256 [0-9a-f]*//' >of-version1
expect 0 methods --json --plugin mine.so && grep '"my-mt"' out | sed 's/sha256 [0-9a-f]*//' >of-version2
grep -q '"probes":\["segment","ray"\],"triangles":"any"' of-version1
grep -q '"capabilities":\["batch"\]' of-version1
grep -q '"capabilities":\["parameter","batch","prepared triangle"\]' of-version2
for library in version1 mine; do
  expect 1 fuzz --plugin $library.so --method my-mt --family grazing,affine --count 4000 --threads 2 --out fuzzed-$library
done
/usr/bin/python3 - <<'PYTHON'
import json
counts = [json.load(open(f"fuzzed-{library}/summary.json"))["counts"] for library in ("version1", "mine")]
assert counts[0] == counts[1], "the same test, told in two versions, is judged otherwise"
PYTHON

# The example again, with its contract's other values: it culls, and is judged by that; it says so, and does not.
plugin culls -DCULLS "$example"
cat >behind.jsonl <<'CASES'
{"id":"front","seg":[[0.25,0.25,1],[0.25,0.25,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}
{"id":"back","seg":[[0.25,0.25,-1],[0.25,0.25,1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}
CASES
expect 0 methods --plugin culls.so && says out 'segment, ray; any triangle, back faces culled'
expect 0 replay --plugin culls.so behind.jsonl && says out 'right by its contract'
plugin says_so -DSAYS_IT_CULLS "$example"
expect 1 replay --plugin says_so.so behind.jsonl && says out 'WRONG'
expect 1 fuzz --plugin says_so.so --method my-mt --family grazing --count 1000 --out says_so && says says_so/counterexamples.jsonl '"readings":{"culling":"back faces"}'
plugin stale -DFORGETS_WHAT_IT_PREPARED "$example"
expect 1 fuzz --plugin stale.so --method my-mt --count 2000 && says err 'answers otherwise with a prepared triangle'

# Two libraries at once; two of one name.
broken=$SOURCE_DIR/tests/plugin/broken.c
plugin other -DNAME='"other"' "$broken"
expect 0 methods --plugin mine.so --plugin other.so && says out 'my-mt ' && says out 'other '
expect 2 methods --plugin mine.so --plugin planted.so && says err 'planted.so: there is a method called my-mt already'
plugin taken -DNAME='"sf-double"' "$broken"
expect 2 methods --plugin taken.so && says err 'there is a method called sf-double already'
expect 1 fuzz --plugin mine.so --count 4000 && says out 'my-mt: wrong' && lacks out 'sf-double'

# no_plugin FILE MESSAGE: refused with one line that starts with the file and says this.
no_plugin() {
  expect 3 methods --plugin "$1"
  says err "$1: $2"
  [ "$(wc -l <err)" -eq 1 ] && [ ! -s out ] || { echo "$1: expected one line on standard error alone" >&2; exit 1; }
}
# breaks MESSAGE FLAG…: a plugin compiled with these flags is refused.
breaks() {
  plugin bad "${@:2}" "$broken"
  no_plugin bad.so "$1"
}
no_plugin missing.so 'cannot read: No such file'
no_plugin "$scratch" 'is a directory'
echo text >text.so && no_plugin text.so 'cannot be loaded as a shared library: '
: >empty.so && no_plugin empty.so 'cannot be loaded as a shared library: '
echo 'int unrelated;' >unrelated.c && plugin unrelated unrelated.c && no_plugin unrelated.so 'does not export tribunal_plugin_describe'
echo 'int nowhere(void); int undefined(void) { return nowhere(); }' >undefined.c
cc -shared -fPIC -o undefined.so undefined.c && no_plugin undefined.so 'cannot be loaded as a shared library: undefined symbol: nowhere'
breaks 'tribunal_plugin_describe returned NULL' -DNOTHING
breaks 'is made for version 999 of tribunal_plugin.h, expected 1 to 3' -DABI=999 -DNAME=NULL
breaks 'name is NULL' -DNAME=NULL
breaks 'name is "", expected' -DNAME='""'
breaks 'name is "a,b", expected' -DNAME='"a,b"'
breaks 'name is "-x", expected' -DNAME='"-x"'
breaks 'name is "two\u000alines", expected' -DNAME='"two\nlines"'
breaks 'name is "\xff", expected' -DNAME='"\xff"'
breaks 'name is "a23456789012345678901234567890123", expected' -DNAME='"a23456789012345678901234567890123"'
breaks 'contract is NULL' -DABI=1 -DCONTRACT=NULL
breaks 'contract: expected one line' -DABI=1 -DCONTRACT='"two\nlines"'
breaks 'contract: expected one line of UTF-8' -DABI=1 -DCONTRACT='"\xff"'
breaks 'format is 16, expected TRIBUNAL_BINARY32 or TRIBUNAL_BINARY64' -DFORMAT=16
breaks 'convention is 7, expected' -DCONVENTION=7
breaks 'convention is 2, expected TRIBUNAL_CLOSED or TRIBUNAL_TRANSVERSAL' -DABI=1 -DCONVENTION=2
breaks 'operands is 3, expected 0 or a sum' -DMORE='.operands = 3'
breaks 'operands is 8, expected 0 or a sum' -DMORE='.operands = 8'
breaks 'boundary is 4, expected one of TRIBUNAL_BOUNDARY_' -DMORE='.boundary = 4'
breaks 'ends is -1, expected one of TRIBUNAL_ENDS_' -DMORE='.ends = -1'
breaks 'culling is 2, expected one of TRIBUNAL_CULLS_' -DMORE='.culling = 2'
breaks 'tell is NULL, expected a function that tells' -DMORE='.tells_t = 1'
breaks 'tell is NULL, expected a function that tells' -DMORE='.tells_contact = 1'
breaks 'ask_prepared is NULL, expected a function' -DMORE='.prepare = (tribunal_prepare*)(size_t)1'
breaks 'ask is NULL' -DASK=NULL

# What only shows when it is asked.
plugin seven -DANSWER=7 "$broken"
expect 3 fuzz --plugin seven.so --method broken --count 100 --threads 2 && says err 'seven.so: answered 7, expected TRIBUNAL_MISS'
plugin rounding -DCHANGES_ROUNDING "$broken"
expect 4 fuzz --plugin rounding.so --method broken --count 100 --threads 1 && says err 'rounding.so: changed the rounding mode'
plugin segments "$broken"
expect 0 classify --plugin segments.so --method broken --in cases.jsonl && says out '{"id":"ray","method":"broken","status":"unsupported"}'
expect 2 render --plugin segments.so "$SOURCE_DIR/data/scenes/elephant.json" --method broken -o picture.png && says err 'broken does not take rays'
plugin narrow -DFORMAT=TRIBUNAL_BINARY32 "$broken"
echo '{"id":"far","seg":[["0x1p+1000",0,0],[0,0,0]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}' >far.jsonl
expect 0 classify --plugin narrow.so --method broken --in far.jsonl && says out '"status":"unsupported"'

# Libraries linked with -ffast-math may turn on flushing to zero as they load; it is off again before anything is asked.
if [ "$(uname -m)" = x86_64 ]; then
  plugin flushing -DFLUSHES_TO_ZERO "$broken"
  expect 0 classify --plugin flushing.so --method broken --in cases.jsonl
  expect 0 fuzz --plugin flushing.so --method sf-rational,sf-epick --family scale,zeros --count 5000 --threads 2
fi

# It runs in our process: a crash ends it, by signal.
plugin crash -DCRASHES "$broken"
ulimit -c 0
ASAN_OPTIONS=handle_segv=0 expect 139 fuzz --plugin crash.so --method broken --count 100 --threads 2
