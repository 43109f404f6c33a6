#!/usr/bin/env bash
# One seed, the same bytes: with 1, 2 and 7 threads, and after interrupts and --resume.
source "$(dirname "$0")/common.bash"
cd "$scratch"

plan=(fuzz --method sf-double,mt-float --seed 3 --count 3000000)
expect 1 "${plan[@]}" --threads 1 --out one
expect 1 "${plan[@]}" --threads 2 --out two
expect 1 "${plan[@]}" --threads 7 --out seven
diff -r one two
diff -r one seven

interrupt_and_resume "${plan[@]}"
diff -r one parts
sha256sum one/summary.json two/summary.json seven/summary.json parts/summary.json

# A checkpoint is of its own plan only, and an edited one is refused.
expect 2 fuzz --method sf-double --seed 3 --count 3000000 --out first-part --resume && says err 'other methods, families, seed or count'
sed -i '3s/[0-9]/7/3' first-part/checkpoint.jsonl
expect 3 "${plan[@]}" --out first-part --resume && says err 'checkpoint.jsonl:3:'
expect 2 "${plan[@]}" --resume && says err '--out'
