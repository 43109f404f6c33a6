#!/usr/bin/env bash
# Files of any length: constant memory, the order of the cases, the same bytes for any number of threads, and nothing at
# all where a line is wrong, be it the last one.
source "$(dirname "$0")/common.bash"
cd "$scratch"
python=/usr/bin/python3
many=$SOURCE_DIR/tests/cli/many_cases.py

# peak FILE ARG…: runs the program with its output in FILE, expects exit code 0 or 1, prints its peak memory in KiB.
peak() {
  local out=$1 code memory
  shift
  read -r code memory _ < <($python "$SOURCE_DIR/tests/cli/peak.py" "$out" "$TRIBUNAL" "$@")
  [ "$code" -le 1 ] || { echo "tribunal $*: exit $code" >&2; exit 1; }
  echo "$memory"
}

# flat NAME SMALL LARGE: the second figure exceeds the first by no more than 6 MiB.
flat() {
  echo "$1: $2 and $3 KiB"
  [ "$3" -le $(($2 + 6 * 1024)) ] || { echo "$1: its memory grows with the file" >&2; exit 1; }
}

expect 0 cases --count 4000 --with-answers --out base.jsonl
$python "$many" base.jsonl 100000 >small.jsonl
$python "$many" base.jsonl 300000 >large.jsonl
flat classify "$(peak small.out classify --method sf-filtered --in small.jsonl --out small.answers --threads 2)" \
  "$(peak large.out classify --method sf-filtered --in large.jsonl --out large.answers --threads 2)"
flat 'classify to a pipe' "$(peak small.out classify --method sf-filtered --in small.jsonl --threads 2)" \
  "$(peak large.out classify --method sf-filtered --in large.jsonl --threads 2)"
cmp large.answers large.out
flat check "$(peak small.out check small.jsonl --method sf-double --threads 2)" \
  "$(peak large.out check large.jsonl --method sf-double --threads 2)"

# Order, and threads.
$python - <<'PYTHON'
import json
ids = [json.loads(line)["id"] for line in open("large.answers")]
assert ids == [f"case-{k}" for k in range(300000)]
PYTHON
head -n 20000 small.jsonl >some.jsonl
for threads in 1 2 7; do
  expect 0 classify --method sf-filtered,mt-double --in some.jsonl --out "answers-$threads" --threads "$threads"
  expect 1 check some.jsonl --method sf-filtered,sf-double --threads "$threads" && mv out "check-$threads"
  "$TRIBUNAL" classify --method sf-filtered,mt-double --threads "$threads" <some.jsonl >piped
  cmp piped answers-1 && cmp "answers-$threads" answers-1 && cmp "check-$threads" check-1
done

# The last line is wrong, or one in the middle and one after it: one line, that of the first, and no output.
for threads in 1 7; do
  { cat some.jsonl; echo '{"id":"last"}'; } >bad.jsonl
  for out in - answers; do
    expect 3 classify --method sf-filtered --in bad.jsonl --out "$out" --threads "$threads"
    says err 'bad.jsonl:20001: expected exactly one of "seg" and "ray"'
    [ "$(wc -l <err)" -eq 1 ] && [ ! -s out ] && [ ! -e answers ]
  done
  expect 3 check bad.jsonl --method sf-filtered --threads "$threads" && says err 'bad.jsonl:20001: ' && [ ! -s out ]
  { head -n 7000 some.jsonl; echo '{"id":7}'; tail -n 9000 some.jsonl; echo '['; } >bad.jsonl
  expect 3 classify --method sf-filtered --in bad.jsonl --threads "$threads"
  says err 'bad.jsonl:7001: ' && [ "$(wc -l <err)" -eq 1 ] && [ ! -s out ]
done
[ -z "$(find . -name '*tmp*')" ]
# An endless line is refused when it is too long, and a long blank one is blank.
{ head -n 1 some.jsonl; head -c 3000000 /dev/zero; } >zeros.jsonl
expect 3 classify --method sf-filtered --in zeros.jsonl && says err 'zeros.jsonl:2: line longer than 1 MiB' && [ ! -s out ]
{ head -c 3000000 /dev/zero | tr '\0' ' '; echo; head -n 1 some.jsonl; } >blank.jsonl
expect 0 classify --method sf-filtered --in blank.jsonl && [ "$(wc -l <out)" -eq 1 ]

# alike A B: the same report, but for the words of its command, and so for the hashes of its log.
alike() {
  local file
  for file in log.jsonl counterexamples.jsonl certificate.json certificate.md; do
    cmp <(stripped "$1/$file") <(stripped "$2/$file") || { echo "$1/$file and $2/$file differ" >&2; exit 1; }
  done
}
stripped() { [ -s "$1" ] || return 0; tr -d ' \n' <"$1" | sed -E 's/"command":\[[^]]*\],//; s/[0-9a-f]{64}//g'; }

# judge: answers in the order of the cases, each method's by itself, and in no order, give the same report.
head -n 6000 small.jsonl >judged.jsonl
expect 0 classify --method sf-double,mt-float,sf-rational --in judged.jsonl --out ordered.jsonl
expect 0 classify --method sf-double --in judged.jsonl --out one.jsonl
shuf --random-source=judged.jsonl ordered.jsonl >shuffled.jsonl
sort -s -t'"' -k8,8 ordered.jsonl >grouped.jsonl
expect 1 judge --cases judged.jsonl --answers ordered.jsonl --out ordered --threads 2
for answers in shuffled grouped; do
  expect 1 judge --cases judged.jsonl --answers $answers.jsonl --out $answers --threads 2
  for method in sf-double mt-float sf-rational; do alike ordered/*-$method $answers/*-$method; done
done
expect 1 judge --cases judged.jsonl --answers ordered.jsonl --out alone --threads 1 && diff -r ordered alone
expect 1 judge --cases - --answers ordered.jsonl --out piped-cases <judged.jsonl
for method in 1-sf-double 2-mt-float 3-sf-rational; do alike ordered/$method piped-cases/$method; done
mkfifo pipe
for threads in 1 2; do
  shuf --random-source=base.jsonl one.jsonl >pipe &
  expect 1 judge --cases judged.jsonl --answers pipe --out "piped-$threads" --threads $threads
  alike ordered/1-sf-double "piped-$threads"
done
$python "$many" base.jsonl 24000 >longer.jsonl
expect 0 classify --method sf-rational --in longer.jsonl --out longer.answers
expect 0 classify --method sf-rational --in judged.jsonl --out judged.answers
flat judge "$(peak small.out judge --cases judged.jsonl --answers judged.answers --threads 2)" \
  "$(peak large.out judge --cases longer.jsonl --answers longer.answers --threads 2)"

# A report of any number of wrong answers is written and verified in memory that does not grow with them.
wrong() { $python -c 'import json, sys
for line in open(sys.argv[1]):
    a = json.loads(line)
    print(json.dumps({"id": a["id"], "hit": 1 - a["hit"]}))' "$1"; }
$python "$many" base.jsonl 1500 >few.jsonl && expect 0 classify --method sf-rational --in few.jsonl --out few.right && wrong few.right >few.wrong
$python "$many" base.jsonl 6000 >more.jsonl && expect 0 classify --method sf-rational --in more.jsonl --out more.right && wrong more.right >more.wrong
flat 'judge, all wrong' "$(peak small.out judge --cases few.jsonl --answers few.wrong --threads 2 --out few)" \
  "$(peak large.out judge --cases more.jsonl --answers more.wrong --threads 2 --out more)"
[ "$(wc -l <more/counterexamples.jsonl)" -eq 6000 ] && [ "$(stat -c %s more/log.jsonl)" -gt 8000000 ]
flat verify "$(peak small.out verify few)" "$(peak large.out verify more)"

# Refusals, whatever the order: the cases' first line that is wrong, then the answers'. In time and memory in proportion.
$python - <<'PYTHON'
answers = [f'{{"id":"case-{k}","hit":0}}\n' for k in range(6000)]
def write(name, lines): open(name, "w").writelines(lines)
write("twice.jsonl", answers[:50] + answers)
write("extra.jsonl", answers + ['{"id":"stranger","hit":0}\n'])
write("short.jsonl", answers[:-2])
write("method-each.jsonl", [f'{{"id":"case-{k % 6000}","method":"m{k}","hit":0}}\n' for k in range(60000)])
PYTHON
for threads in 1 7; do
  expect 3 judge --cases judged.jsonl --answers twice.jsonl --threads $threads && says err 'twice.jsonl:51: a second answer of answers to "case-0"'
  expect 3 judge --cases judged.jsonl --answers extra.jsonl --threads $threads && says err 'extra.jsonl:6001: answers "stranger", which is no case'
  expect 3 judge --cases judged.jsonl --answers short.jsonl --threads $threads && says err '2 of 6000 answers of answers are missing, the first to "case-5998"'
  { cat judged.jsonl; sed -n 17p judged.jsonl; } >again.jsonl
  { cat one.jsonl; sed -n 17p one.jsonl; } >again.answers
  expect 3 judge --cases again.jsonl --answers again.answers --threads $threads && says err 'again.jsonl:6001: id "case-16" again, it was on line 17; expected one case an id'
done
read -r code memory wall _ < <($python "$SOURCE_DIR/tests/cli/peak.py" out "$TRIBUNAL" judge --cases judged.jsonl --answers method-each.jsonl 2>err)
says err '5999 of 6000 answers of m0 are missing, the first to "case-1"'
[ "$code" -eq 3 ] && [ "$memory" -le 150000 ] && [ "${wall%.*}" -le 10 ] || { echo "refused in $wall s and $memory KiB" >&2; exit 1; }
