#!/usr/bin/env bash
# methods, classify, fuzz, shrink, replay and certify from end to end, with input written by hand.
source "$(dirname "$0")/common.bash"
cd "$scratch"

expect 0 methods && says out sf-rational && says out 'Möller & Trumbore 1997'
expect 0 methods --json && says out '"name":"mt-float"'

cat >cases.jsonl <<'EOF'
{"id":"through","seg":[[0.25,0.25,1],[0.25,0.25,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}
{"id":"corner","fmt":"binary32","seg":[[0,0,"0x1p+0"],[0,0,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}

{"id":"in the plane","ray":{"o":[-1,0.25,0],"d":[1,0,0]},"tri":[[0,0,0],[1,0,0],[0,1,0]]}
{"id":"point on point","seg":[[1,2,3],[1,2,3]],"tri":[[1,2,3],[1,2,3],[1,2,3]]}
EOF
expect 0 classify --method sf-rational,mt-double --in cases.jsonl
diff out - <<'EOF'
{"id":"through","method":"sf-rational","hit":1,"status":"ok","class":"C016","contact":"interior","at":"between","side":"front"}
{"id":"through","method":"mt-double","hit":1,"status":"ok"}
{"id":"corner","method":"sf-rational","hit":1,"status":"ok","class":"C017","contact":"vertex","at":"between","side":"front"}
{"id":"corner","method":"mt-double","hit":1,"status":"ok"}
{"id":"in the plane","method":"sf-rational","hit":1,"status":"ok","class":"R077","contact":"coplanar"}
{"id":"in the plane","method":"mt-double","hit":0,"status":"ok","contact":"none"}
{"id":"point on point","method":"sf-rational","hit":1,"status":"ok","class":"C163","contact":"coplanar","at":"source"}
{"id":"point on point","method":"mt-double","hit":0,"status":"ok","contact":"none"}
EOF
"$TRIBUNAL" classify --method sf-epick --out answers.jsonl <cases.jsonl
[ "$(wc -l <answers.jsonl)" -eq 4 ]
"$TRIBUNAL" classify cases.jsonl --methods sf-epick | cmp - answers.jsonl
expect 0 replay cases.jsonl && says out 'right by its convention'
expect 0 replay cases.jsonl --method sf-double,mt-double && says out mt-double && lacks out sf-rational
expect 2 replay cases.jsonl --method sf-duoble && says err 'did you mean "sf-double"?'
for command in 'classify cases.jsonl' 'check cases.jsonl' 'certify --out none'; do
  # shellcheck disable=SC2086  # words
  expect 2 $command && says err 'no method given, expected --method'
done
expect 2 classify --method sf-duoble --in cases.jsonl && says err 'did you mean "sf-double"?'
expect 2 classify --method quadric --in cases.jsonl && says err 'unknown method "quadric", expected one that `tribunal methods` lists'
expect 2 classify --method sf-double --in cases.jsonl --out cases.jsonl && says err 'same file'
expect 3 classify --method sf-double --in nothing.jsonl && says err 'nothing.jsonl: cannot read'
echo '{"id":"x","sag":[]}' >typo.jsonl
expect 3 classify --method sf-double --in typo.jsonl && says err 'typo.jsonl:1: unknown key "sag", did you mean "seg"?'
echo '{"id":"x","id":"y","seg":[[0,0,1],[0,0,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}' >twice.jsonl
expect 3 classify --method sf-double --in twice.jsonl && says err 'twice.jsonl:1: key "id" twice in one object'
echo '{"id":"liar","seg":[[0,0,1],[0,0,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]],"expect":0}' >liar.jsonl
expect 1 replay liar.jsonl && says out 'THE FILE IS WRONG: the case expects no hit'
expect 5 classify --method sf-double --in cases.jsonl --out /dev/full

expect 0 fuzz --method sf-rational,sf-epick --count 3000 && says out 'classes judged  sf-rational: binary64 '
expect 1 fuzz --method sf-double --family affine --seed 7 --count 20000 --threads 1 --out one
expect 1 fuzz --method sf-double --family affine --seed 7 --count 20000 --threads 5 --out five
diff -r one five
expect 1 fuzz --method sf-double --family affine --seed 8 --count 20000 --out other
! cmp -s one/summary.json other/summary.json || { echo "another seed, the same cases" >&2; exit 1; }
head -n 1 one/counterexamples.jsonl >first.jsonl
expect 1 replay first.jsonl && says out 'WRONG' && says out 'exact {"abcp"'
expect 0 shrink first.jsonl --out again.jsonl
cmp first.jsonl again.jsonl || { echo "a shrunk case shrank again" >&2; exit 1; }
expect 0 fuzz --relations --method sf-rational --count 5000 && says out 'vertex-order'
expect 1 fuzz --relations --method sf-double --count 20000 --out relations
expect 1 replay relations/witnesses.jsonl
expect 2 fuzz --count 0 && says err 'expected a number above 0'
expect 2 fuzz --seed -1 && says err 'expected a whole number'
expect 2 fuzz --threads 0

# Every option that takes a number refuses a negative one, and words, with one line that says what it expects.
"$TRIBUNAL" --help | sed -n 's/^  \([a-z]\+\)  .*/\1/p' >commands
[ "$(wc -l <commands)" -ge 15 ]
numbers=0
while read -r command; do
  "$TRIBUNAL" "$command" --help >help
  while read -r option; do
    [ "$option" != --scale ] || continue  # a mesh may be mirrored
    for value in -3 -0x3 three nan; do
      expect 2 "$command" "$option" "$value" && says err "found $value" && says err 'expected a'
      [ "$(wc -l <err)" -eq 1 ]
    done
    numbers=$((numbers + 1))
  done < <(sed -n 's/^ *\(-[a-z],\)\?\(--[a-z-]\+\)[^ ]* \(UINT\|INT\|FLOAT\).*/\2/p' help)
done <commands
[ "$numbers" -ge 30 ] || { echo "only $numbers options take a number" >&2; exit 1; }
expect 2 fuzz --family afine && says err 'did you mean "affine"?'
expect 2 fuzz --family xyzzy && says err 'unknown family "xyzzy", expected one that `tribunal fuzz --help` lists'
expect 2 fuzz --count 5 --seconds 5
timeout --foreground --preserve-status -s INT 2 "$TRIBUNAL" fuzz --method sf-epick --seconds 60 >out 2>err && status=0 || status=$?
[ "$status" -eq 130 ] || { echo "interrupted fuzz: exit $status, expected 130" >&2; exit 1; }

expect 1 certify --method mt-float --out certificate --cases cases.jsonl
says out 'mt-float: refuted' && says certificate/certificate.md '## Not covered' && says certificate/certificate.json '"verdict": "refuted"'
expect 1 replay certificate/counterexamples.jsonl
expect 3 certify --method sf-rational --out liar --cases liar.jsonl && says err 'liar: the case expects no hit'
expect 2 certify --method sf-double,mt-float --out certificate
expect 5 certify --method sf-double --out /proc/nowhere
