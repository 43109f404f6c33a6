#!/usr/bin/env bash
# One seed, the same bytes: with 1, 2 and 7 threads, and after interrupts and --resume.
source "$(dirname "$0")/common.bash"
cd "$scratch"

plan=(fuzz --method sf-double,mt-float --seed 3 --count 300000)
expect 1 "${plan[@]}" --threads 1 --out one
expect 1 "${plan[@]}" --threads 2 --out two
expect 1 "${plan[@]}" --threads 7 --out seven
diff -r one two && diff -r one seven

# Interrupted again and again, with another number of threads each time.
interrupted=0
for threads in 1 2 7 2 1 2 7 2 2 2 2; do
  timeout --foreground --preserve-status -s INT 1 "$TRIBUNAL" "${plan[@]}" --threads "$threads" --out parts --resume >out 2>err && status=0 || status=$?
  [ "$status" -ne 1 ] || break
  [ "$status" -eq 130 ] && says out 'INTERRUPTED' && [ ! -e parts/summary.json ] || { cat err; exit 1; }
  interrupted=$((interrupted + 1))
done
[ "$interrupted" -gt 0 ] || { echo "never interrupted" >&2; exit 1; }
[ ! -e parts/summary.json ] && expect 1 "${plan[@]}" --out parts --resume
diff -r one parts
sha256sum one/summary.json two/summary.json seven/summary.json parts/summary.json

# A checkpoint is of its own plan only, and an edited one is refused.
timeout --foreground --preserve-status -s INT 0.5 "$TRIBUNAL" "${plan[@]}" --out other >out 2>err || true
expect 2 fuzz --method sf-double --seed 3 --count 300000 --out other --resume && says err 'other methods, families, seed or count'
sed -i '3s/[0-9]/7/3' other/checkpoint.jsonl
expect 3 "${plan[@]}" --out other --resume && says err 'checkpoint.jsonl:3:'
expect 2 "${plan[@]}" --resume && says err '--out'
