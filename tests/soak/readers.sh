#!/usr/bin/env bash
# The targets of tests/fuzz by libFuzzer, with address and undefined-behaviour sanitizers: ten minutes each, or
# TRIBUNAL_SOAK_SECONDS for each, as many at a time as there are cores. They start from data/corpora; what they find that
# is new stays in $SCRATCH/NAME, and an input that breaks one in $SCRATCH/broken. Any crash, leak, hang, use of a
# gigabyte, or difference between the certified test and the reference fails.
set -euo pipefail
seconds=${TRIBUNAL_SOAK_SECONDS:-600}
build=$SCRATCH/build
targets=${TRIBUNAL_FUZZ_TARGETS:-$(cd "$SOURCE_DIR/data/corpora" && echo *)}
mkdir -p "$SCRATCH/broken"

cmake -S "$SOURCE_DIR" --preset fuzz -B "$build" >"$SCRATCH/configure.txt"
# shellcheck disable=SC2046,SC2086  # one word a target
cmake --build "$build" -j "$(nproc)" --target $(printf 'fuzz_%s ' $targets) >"$SCRATCH/build.txt" || { tail -n 40 "$SCRATCH/build.txt" >&2; exit 1; }

# feed NAME: the lines that libFuzzer says go to NAME.txt.
feed() {
  local name=$1
  mkdir -p "$SCRATCH/$name"
  "$build/tests/fuzz/fuzz_$name" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=1024 -malloc_limit_mb=512 \
    -max_len=16384 -print_final_stats=1 -artifact_prefix="$SCRATCH/broken/$name-" \
    "$SCRATCH/$name" "$SOURCE_DIR/data/corpora/$name" >"$SCRATCH/$name.txt" 2>&1 && echo whole >"$SCRATCH/$name.end" ||
    echo broken >"$SCRATCH/$name.end"
}
export -f feed
export SCRATCH SOURCE_DIR build seconds
# shellcheck disable=SC2086
printf '%s\n' $targets | xargs -P "$(nproc)" -I{} bash -c 'feed {}'

tried=0 broke=0
for name in $targets; do
  runs=$(sed -nE 's/^stat::number_of_executed_units: *([0-9]+)/\1/p' "$SCRATCH/$name.txt")
  [ -n "$runs" ] && [ "$runs" -gt 0 ] || { runs=0; echo broken >"$SCRATCH/$name.end"; }
  echo "$name: $runs inputs in $seconds s, $(cat "$SCRATCH/$name.end")"
  tried=$((tried + runs))
  [ "$(cat "$SCRATCH/$name.end")" = whole ] || { broke=$((broke + 1)); tail -n 30 "$SCRATCH/$name.txt"; }
done
echo "tried $tried, broke $broke: inputs to readers and to the certified test, by libFuzzer with ASan and UBSan, $seconds s each of $(wc -w <<<"$targets") targets"
[ "$broke" -eq 0 ]
