#!/usr/bin/env bash
# Numbers that are not finite are tokens of cases: each command that takes cases gives such a case no answer, and no
# error. In scenes and meshes they are errors.
source "$(dirname "$0")/common.bash"
cd "$scratch"
python=/usr/bin/python3

# Every token at every number of every kind of question, in both formats.
$python - <<'PYTHON'
import copy, json
tokens = ['"nan"', '"-nan"', '"NaN"', '"inf"', '"-inf"', '"+Infinity"', '1e999', '-1e309', '"0x1p+1024"', '"-0x1.8p+5000"']
tri, ring = [[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[[0, 0, 0], [4, 0, 0], [0, 4, 0]], [[1, 1, 0], [2, 1, 0], [1, 2, 0]]]
questions = {
    "segment": {"seg": [[0.25, 0.25, 1], [0.25, 0.25, -1]], "tri": tri},
    "ray": {"ray": {"o": [0.25, 0.25, 1], "d": [0, 0, -1]}, "tri": tri},
    "within": {"ray": {"o": [0.25, 0.25, 1], "d": [0, 0, -1], "t": [0, 4]}, "tri": tri},
    "polygon": {"seg": [[0.25, 0.25, 1], [0.25, 0.25, -1]], "rings": ring},
    "polygon-ray": {"ray": {"o": [0.25, 0.25, 1], "d": [0, 0, -1]}, "rings": ring}}
def numbers(value):
    for key in value if isinstance(value, dict) else range(len(value)) if isinstance(value, list) else []:
        if isinstance(value[key], (dict, list)):
            yield from numbers(value[key])
        else:
            yield value, key
finite, cases = [], []
for name, question in questions.items():
    for fmt in ("binary64", "binary32"):
        finite.append({"id": f"finite-{name}-{fmt}", "fmt": fmt, **question})
        for i, token in enumerate(tokens):
            for n in range(len(list(numbers(question)))):
                if name == "within" and n == 7 and token in ('"inf"', '"+Infinity"'):
                    continue  # no bound
                changed = copy.deepcopy(question)
                place, key = list(numbers(changed))[n]
                place[key] = "@"
                text = json.dumps({"id": f"{name}-{fmt}-{i}-{n}", "fmt": fmt, **changed})
                cases.append(text.replace('"@"', token))
open("all.jsonl", "w").write("\n".join(cases) + "\n")
open("finite.jsonl", "w").write("\n".join(map(json.dumps, finite)) + "\n")
PYTHON
[ "$(wc -l <all.jsonl)" -gt 1000 ]
methods=sf-float,sf-double-eps,sf-filtered,sf-epick,sf-epeck,sf-expansion,sf-rational,mt-double,woop-float,haines-double,feito-float,cgal-epick,cgal-epeck

# classify: the status and nothing else, whatever the method takes.
expect 0 classify --method $methods --in all.jsonl --out answers.jsonl
$python - $methods <<'PYTHON'
import json, sys
methods = sys.argv[1].split(",")
ids = [line.split('"')[3] for line in open("all.jsonl")]
answers = [json.loads(line) for line in open("answers.jsonl")]
assert answers == [{"id": i, "method": m, "status": "nonfinite"} for i in ids for m in methods]
PYTHON
cat all.jsonl finite.jsonl >both.jsonl
expect 0 classify --method sf-filtered --in both.jsonl && [ "$(grep -c '"status":"ok"' out)" -eq 10 ]

# A plugin is not asked, at home or isolated: this one ends the program if it is.
cat >abort.c <<'C'
#include <stdlib.h>
#include "tribunal_plugin.h"
static int ask(int probe, const double* query) {
  (void)probe;
  for (int i = 0; i < 15; ++i) {
    if (query[i] - query[i] != 0) abort();
  }
  return TRIBUNAL_MISS;
}
const tribunal_plugin* tribunal_plugin_describe(void) {
  static const tribunal_plugin plugin = {.abi = TRIBUNAL_PLUGIN_ABI,
                                         .name = "aborts",
                                         .summary = "ends the program where a number is not finite",
                                         .format = TRIBUNAL_BINARY64,
                                         .ask = ask};
  return &plugin;
}
C
plugin aborts abort.c
for isolate in '' --isolate; do
  expect 0 classify --plugin ./aborts.so ${isolate:+"$isolate"} --method aborts --in all.jsonl
  [ "$(grep -c '"status":"nonfinite"' out)" -eq "$(wc -l <all.jsonl)" ]
done

# judge: to refuse is right, to answer is wrong, and to say that it is outside the contract is neither.
grep -v rings both.jsonl >cases.jsonl
n=$(grep -vc finite- cases.jsonl)
expect 0 classify --method sf-rational --in cases.jsonl --out right.jsonl
expect 0 judge --cases cases.jsonl --answers right.jsonl --out right
says out "not finite, binary64: $((n / 2)) of $((n / 2)) refused" && says out 'not refuted'
says right/certificate.md "binary32: $((n / 2)) of $((n / 2)) refused" && expect 0 verify right
sed '0,/"status":"nonfinite"/s//"hit":0/' right.jsonl >wrong.jsonl
expect 1 judge --cases cases.jsonl --answers wrong.jsonl --out wrong
says out 'refuted' && says out 'answers 1 cases that are not finite' && says out '1 ANSWERED, the first is segment-binary64-0-0'
says wrong/certificate.json '"answered": 1' && expect 0 verify wrong
sed -i 's/"answered":1/"answered":0/' wrong/log.jsonl && expect 3 verify wrong
sed '0,/nonfinite/s//unsupported/' right.jsonl >unsupported.jsonl
expect 0 judge --cases cases.jsonl --answers unsupported.jsonl && says out "$((n / 2 - 1)) of $((n / 2)) refused"
sed '0,/nonfinite/s//failed/' right.jsonl >failed.jsonl
expect 1 judge --cases cases.jsonl --answers failed.jsonl && says out 'the first is segment-binary64-0-0'
# Nothing else in the file, and nobody but who refuses.
head -n 3 all.jsonl >three.jsonl
expect 0 classify --method mt-float --in three.jsonl --out three-answers.jsonl
expect 0 judge --cases three.jsonl --answers three-answers.jsonl && says out '3 of 3 refused' && says out 'not refuted'

# What a case claims of an answer that it has not, is an error at its line.
for claim in '"expect":0' '"class":"C017"'; do
  sed "2s/^{/{$claim, /" three.jsonl >claims.jsonl
  for command in "classify --method sf-double --in" "check --method sf-double" "replay" "shrink --method sf-double" "judge --answers three-answers.jsonl --cases"; do
    # shellcheck disable=SC2086  # words
    expect 3 $command claims.jsonl && says err 'claims.jsonl:2: ' && says err 'given of a case with a number that is not finite, expected none'
    [ "$(wc -l <err)" -eq 1 ] && [ ! -s out ]
  done
done

# check: each case that is not finite expects to be refused.
expect 0 check all.jsonl --method sf-double,haines-double,cgal-epick --exact
says out "sf-double: 0 of $(wc -l <all.jsonl) answers are not what the file expects"

# replay, as text and as tests to paste.
expect 0 replay three.jsonl
says out 'no exact answer: a number is not finite' && says out 'p = (nan, 0.25' && lacks out WRONG
[ "$(grep -c 'nonfinite$' out)" -gt 30 ]
for language in c gtest python; do
  expect 0 replay cases.jsonl --emit $language && says out 'no test, a number is not finite'
  cp out emitted.$language
done
${CC:-cc} -std=c99 -Wall -Wextra -Werror -fsyntax-only -x c emitted.c
$python emitted.python

# shrink: nothing is wrong, so nothing is smaller. The tokens are written as they are read.
expect 0 shrink all.jsonl --out small.jsonl
expect 0 shrink small.jsonl && cmp out small.jsonl
expect 0 classify --method sf-double --in small.jsonl && [ "$(grep -c nonfinite out)" -eq "$(wc -l <all.jsonl)" ]

# certify and fuzz: beside what they draw.
expect 0 certify --method sf-filtered --cases cases.jsonl --out certificate
says out "not finite, binary64: $((n / 2)) of $((n / 2)) refused" && says certificate/certificate.md '## Your cases with numbers that are not finite'
expect 0 verify certificate
expect 0 fuzz --method sf-filtered --cases cases.jsonl --count 1000 --out fuzzed
says fuzzed/summary.json "$n with numbers that are not finite"
expect 3 fuzz --method sf-filtered --cases three.jsonl --count 1000 && says err 'holds no case about triangles with finite numbers'

# report: results with such a case are shown without it.
mkdir results && cp fuzzed/summary.json results && cat three.jsonl fuzzed/counterexamples.jsonl >results/counterexamples.jsonl
expect 0 report results --out page.html

# Scenes and meshes have none.
for token in '"nan"' '"inf"' 1e999 '"0x1p+1024"'; do
  echo '{"camera":{"eye":[0,0,'"$token"'],"look_at":[0,0,0],"up":[0,1,0],"fov":40,"width":4,"height":4},"solids":[{"vertices":[[0,0,0],[1,0,0],[0,1,0]],"faces":[[0,1,2]]}]}' >scene.json
  expect 3 render scene.json --method sf-double -o x.png && [ "$(wc -l <err)" -eq 1 ]
done
for token in nan inf 1e999 0x1p+1024; do
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 %s\n3 0 1 2\n' $token >mesh.off
  expect 3 leak mesh.off --method sf-double && says err 'mesh.off:5:'
done
