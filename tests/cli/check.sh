#!/usr/bin/env bash
# A case file's own expectations: kept, broken, mistaken themselves, and absent.
source "$(dirname "$0")/common.bash"
cd "$scratch"

cat >cases.jsonl <<'CASES'
{"id":"through","seg":[[0.25,0.25,1],[0.25,0.25,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]],"expect":1}
{"id":"short","seg":[[0.25,0.25,3],[0.25,0.25,1]],"tri":[[0,0,0],[1,0,0],[0,1,0]],"expect":0}
{"id":"in plane","seg":[[0.25,0.25,0],[3,3,0]],"tri":[[0,0,0],[1,0,0],[0,1,0]],"expect":1}
{"id":"silent","seg":[[0.75,0.75,1],[0.75,0.75,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}
CASES
expect 0 check cases.jsonl --method sf-filtered --exact
says out 'sf-filtered: 0 of 3 answers are not what the file expects'
says out '1 of 4 cases expect nothing'

# A transversal test calls the segment in the plane a miss; the file rules, and the line says so.
expect 1 check cases.jsonl --method sf-filtered,mt-double
says out 'in plane  mt-double: expected a hit, found no hit'
says out 'mt-double: 1 of 3 answers'

sed 's/"expect":0/"expect":1/' cases.jsonl >mistaken.jsonl
expect 1 check mistaken.jsonl --method sf-filtered --exact
says out 'short  THE FILE IS WRONG: the case expects a hit'
says out 'short  sf-filtered: expected a hit, found no hit'

grep silent cases.jsonl >nothing.jsonl
expect 3 check nothing.jsonl --method sf-filtered
says err 'nothing to check'
expect 2 check cases.jsonl --method sf-filterd
