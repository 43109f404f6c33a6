#!/usr/bin/env bash
# SIGINT and SIGTERM at many moments of runs of every command that takes time.
. "$SOURCE_DIR/tests/cli/common.bash"
cd "$scratch"
. "$SOURCE_DIR/tests/faults/signals.bash"
moments=${MOMENTS:-24}
"$TRIBUNAL" cases --count 60000 --out cases.jsonl
"$TRIBUNAL" classify --method mt-float --in cases.jsonl --out answers.jsonl
"$TRIBUNAL" fuzz --method mt-float --count 200000 --keep 300 --out found >said || [ $? -eq 1 ]
"$TRIBUNAL" certify --method mt-float --out certificate >said || [ $? -eq 1 ]
mesh=$SOURCE_DIR/data/meshes/pig.off scene=$SOURCE_DIR/data/scenes/elephant.json
send_at_moments "$moments" classify --method sf-rational --in cases.jsonl --out out/answers.jsonl
send_at_moments "$moments" cases --count 1000000 --out out/cases.jsonl
send_at_moments "$moments" judge --cases cases.jsonl --answers answers.jsonl --out out
send_at_moments "$moments" shrink found/counterexamples.jsonl --out out/small.jsonl
send_at_moments "$moments" certify --method mt-float --out out
send_at_moments "$moments" fuzz --method mt-float,mt-double --count 1000000 --out out
send_at_moments "$moments" fuzz --relations --method mt-float --count 100000 --out out
send_at_moments "$moments" sweep --method mt-float --axis scale,sliver --count 20000 --out out
send_at_moments "$moments" leak "$mesh" --method mt-float,sf-filtered --out out
send_at_moments "$moments" render "$scene" --method mt-float --against sf-filtered -o out/picture.png
send_at_moments "$moments" report found certificate --out out/page.html
may_hold() { [ -e "$1/chart.json" ] && [ -z "$(find "$1" -name '*.svg')" ]; }
send_at_moments "$moments" chart --quick --mesh none --scenes none --out out

# Without files of output.
for command in "verify certificate --rerun" "check cases.jsonl --method sf-rational --exact"; do
  for signal in INT TERM; do
    for pause in 0.1 0.5 1; do
      # shellcheck disable=SC2086
      "$TRIBUNAL" $command >said 2>err & pid=$!
      sleep $pause
      kill -$signal $pid 2>/dev/null || true
      status=0
      wait $pid || status=$?
      tried=$((tried + 1))
      [ "$status" -eq "$(code_of $signal)" ] || [ "$status" -le 3 ] || { echo "$command: exit $status" >&2; exit 1; }
    done
  done
done
echo "tried $tried, broke 0: signals at moments of runs of fourteen commands"
