#!/usr/bin/env bash
# Five million cases through classify, check and judge: constant memory, the rate, and every answer in its place.
# TRIBUNAL_SOAK_LINES: how many cases.
set -euo pipefail
cd "$SCRATCH"
lines=${TRIBUNAL_SOAK_LINES:-5000000}
few=$((lines / 50))
python=/usr/bin/python3
tried=0 broke=0

# run NAME EXIT MOST_KIB CASES ARG…: exit code and peak memory must be as said; prints them with the rate.
run() {
  local name=$1 exit=$2 most=$3 cases=$4 code memory wall cpu
  shift 4
  read -r code memory wall cpu < <($python "$SOURCE_DIR/tests/cli/peak.py" out "$TRIBUNAL" "$@" 2>err)
  awk -v name="$name" -v n="$cases" -v m="$memory" -v w="$wall" -v c="$cpu" 'BEGIN {
    printf "%-46s %9d cases  %7.0f MB  %7.1f s  %9.0f a second  %9.0f a CPU second\n", name, n, m / 1000, w, n / w, n / c }'
  tried=$((tried + 1))
  [ "$code" -eq "$exit" ] && [ "$memory" -le "$most" ] && return
  echo "$name: exit $code and $memory KiB, expected $exit and at most $most KiB" && head -3 err
  broke=$((broke + 1))
}

# same FILE FILE
same() {
  tried=$((tried + 1))
  cmp "$1" "$2" || broke=$((broke + 1))
}

"$TRIBUNAL" cases --count 20000 --with-answers --out base.jsonl
$python "$SOURCE_DIR/tests/cli/many_cases.py" base.jsonl "$lines" >cases.jsonl
head -n "$few" cases.jsonl >few.jsonl
ls -l cases.jsonl | awk '{ printf "cases.jsonl: %.0f MB\n", $5 / 1e6 }'
for threads in 1 2; do
  run "classify --threads $threads" 0 65000 "$lines" classify --method sf-filtered --in cases.jsonl --out "answers-$threads" --threads "$threads"
done
same answers-1 answers-2 && rm answers-2
run "classify <FILE >FILE" 0 65000 "$lines" classify --method sf-filtered --in cases.jsonl --threads 2
same answers-1 out
run "classify, one binary64 rival" 0 65000 "$lines" classify --method mt-double --in cases.jsonl --out mt --threads 2
run "check --threads 1" 0 65000 "$lines" check cases.jsonl --method sf-filtered --threads 1
run "judge, answers in order, --threads 1" 0 120000 "$few" judge --cases few.jsonl --answers <(head -n "$few" answers-1) --threads 1
run "judge, answers in order" 0 120000 "$lines" judge --cases cases.jsonl --answers answers-1 --threads 2
tac answers-1 >reversed
run "judge, answers in another order" 0 300000 "$lines" judge --cases cases.jsonl --answers reversed --threads 2
head -n $((lines - 1)) answers-1 >short
run "judge, one answer missing" 3 300000 "$lines" judge --cases cases.jsonl --answers short --threads 2
cat answers-1 answers-1 >twice
run "judge, every answer twice" 3 300000 "$lines" judge --cases cases.jsonl --answers twice --threads 2
sed -n '1,$p' cases.jsonl >bad.jsonl && echo '{' >>bad.jsonl
run "classify, the last line wrong" 3 65000 "$lines" classify --method sf-filtered --in bad.jsonl --out bad --threads 2
tried=$((tried + 1))
[ ! -e bad ] && [ -z "$(find . -name '*tmp*')" ] || broke=$((broke + 1))
echo "tried $tried, broke $broke: runs over $lines cases in files, constant memory, rate, order, refusals"
[ "$broke" -eq 0 ]
