#!/usr/bin/env bash
# SIGINT and SIGTERM in every phase: 130 and 143 at once, nothing half written, findings kept. tests/soak/signals.sh sends
# them to every command at many more moments.
. "$SOURCE_DIR/tests/cli/common.bash"
cd "$scratch"
. "$SOURCE_DIR/tests/faults/signals.bash"
"$TRIBUNAL" cases --count 2000 --family affine --out cases.jsonl
"$TRIBUNAL" classify --method mt-float --in cases.jsonl --out answers.jsonl

send_at_moments 2 classify --method sf-rational --in cases.jsonl --out out/answers.jsonl
send_at_moments 3 judge --cases cases.jsonl --answers answers.jsonl --out out
send_at_moments 2 cases --count 20000 --out out/cases.jsonl
send_at_moments 2 leak "$SOURCE_DIR/data/meshes/pig.off" --method mt-float --format binary32 --rays 20000 --out out
send_at_moments 2 fuzz --relations --method mt-float --count 4000 --out out

# While figures are drawn, by a script that ignores SIGTERM: no success, no figure, nothing temporary, and no child.
mkdir drawing
"$TRIBUNAL" sweep --method mt-float --axis scale --count 32 --out drawing >out.txt || true
rm drawing/*.svg drawing/*.png
cat >stubborn <<'SCRIPT'
#!/bin/sh
trap '' TERM INT
echo $$ >child
echo '<svg/>' >"$3/thresholds.svg"
sleep 5 & wait; sleep 5
SCRIPT
chmod +x stubborn
${CC:-cc} -std=gnu11 -O1 -shared -fPIC -o failing_calls.so "$SOURCE_DIR/tests/faults/failing_calls.c" -ldl
for signal in TERM INT; do
  rm -f child
  FAIL_PYTHON=$PWD/stubborn LD_PRELOAD=$PWD/failing_calls.so "$TRIBUNAL" sweep --redraw drawing >out 2>err & pid=$!
  wait_until '[ -s child ]'
  kill -$signal $pid
  sleep 0.1
  kill -$signal $pid  # does not leave what is temporary
  status=0
  wait $pid || status=$?
  [ "$status" -eq "$(code_of $signal)" ] || { echo "while figures are drawn: exit $status" >&2; cat err >&2; exit 1; }
  says err 'not all figures are drawn'
  [ "$(ls drawing)" = "$(printf '%s\n' plot.py sweep.csv sweep.json witnesses.jsonl)" ] && none_left
  wait_until '[ ! -d "/proc/$(cat child)" ]'
done

# Findings survive a second signal, also while a slow test finishes its block of cases; the third ends at once.
cat >slow.c <<'SOURCE'
#define _DEFAULT_SOURCE
#include <unistd.h>

#include "tribunal_plugin.h"

static int ask(int probe, const double x[15]) {
  (void)probe;
  usleep(300);
  return x[0] + x[4] + x[8] > 0 ? TRIBUNAL_HIT : TRIBUNAL_MISS;
}

const tribunal_plugin* tribunal_plugin_describe(void) {
  static const tribunal_plugin plugin = {
    .abi = TRIBUNAL_PLUGIN_ABI,
    .name = "slow",
    .summary = "takes its time",
    .reference = "none",
    .format = TRIBUNAL_BINARY64,
    .convention = TRIBUNAL_CLOSED,
    .ask = ask,
  };
  return &plugin;
}
SOURCE
plugin slow slow.c
slow=(fuzz --plugin ./slow.so --method slow --family affine --count 1000000 --out kept)
begin() { "$TRIBUNAL" "$@" >out 2>err & pid=$!; sleep 0.7; }
begin "${slow[@]}"
kill -INT $pid && sleep 0.05 && kill -INT $pid
status=0
wait $pid || status=$?
[ "$status" -eq 130 ] || { echo "two signals: exit $status" >&2; cat err >&2; exit 1; }
says out 'the same command with --resume goes on' && says err 'one more signal ends at once'
grep -qF '"record":"finding"' kept/checkpoint.jsonl && [ "$(ls kept)" = checkpoint.jsonl ]
before=$(sha256sum kept/checkpoint.jsonl)
begin "${slow[@]}" --resume
kill -TERM $pid && sleep 0.05 && kill -TERM $pid && sleep 0.05 && kill -TERM $pid
status=0
wait $pid || status=$?
[ "$status" -eq 143 ] && [ "$(sha256sum kept/checkpoint.jsonl)" = "$before" ] && none_left

# A signal while findings are shrunk, when all cases are done, loses none of them: --resume has nothing to do but shrink.
plan=(fuzz --method mt-float,sf-float,woop-float,badouel-float --count 20000 --keep 1000 --out shrunk)
"$TRIBUNAL" "${plan[@]}" >out 2>err & pid=$!
wait_until '[ -e shrunk/checkpoint.jsonl ] || [ ! -d /proc/$pid ]'
kill -INT $pid
status=0
wait $pid || status=$?
[ "$status" -eq 130 ] && says out 'INTERRUPTED' && [ "$(ls shrunk)" = checkpoint.jsonl ]
expect 1 "${plan[@]}" --resume
cp -r shrunk resumed
rm -r shrunk
expect 1 "${plan[@]}"
diff -r shrunk resumed
none_left
