#!/usr/bin/env bash
# What every command shares: help, version, usage errors, and output that cannot be written.
source "$(dirname "$0")/common.bash"
one_line_error() { [ "$(wc -l <"$scratch/err")" -eq 1 ] && [ ! -s "$scratch/out" ]; }

expect 0 --help && says out fuzz
expect 0 --version && says out 'tribunal 0.1'
for command in methods classify fuzz cases judge shrink replay certify render chart demo; do
  expect 0 "$command" --help && says out "tribunal $command"
  expect 2 "$command" --no-such-flag && says err "(see tribunal $command --help)" && one_line_error
done
expect 2 && says err fuzz
expect 2 no-such-command && says err '(see tribunal --help)' && one_line_error
expect 2 classify --method && one_line_error

status=0
"$TRIBUNAL" --help >/dev/full 2>"$scratch/err" || status=$?
[ "$status" -eq 5 ] || { echo "full disk: exit $status, expected 5" >&2; exit 1; }

mkfifo "$scratch/pipe"
exec 3<>"$scratch/pipe" 4>"$scratch/pipe" 3<&- # nobody reads what is written to 4
status=0
"$TRIBUNAL" methods >&4 2>"$scratch/err" || status=$?
[ "$status" -eq 5 ] || { echo "closed pipe: exit $status, expected 5" >&2; exit 1; }

# A file that cannot be written has the name that was asked for, not that of the temporary one.
expect 5 classify --method sf-double --in "$SOURCE_DIR/data/cases/classes163.jsonl" --out "$scratch/none/answers.jsonl"
says err 'none/answers.jsonl: cannot write: No such file or directory' && one_line_error
