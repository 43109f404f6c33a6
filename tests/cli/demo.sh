#!/usr/bin/env bash
# The whole tour from another folder's point of view: every picture that the page names exists, and what it shows replays.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$SOURCE_DIR"
"$TRIBUNAL" demo --out "$scratch/out" >"$scratch/log"
page=$scratch/out/index.html
grep -o 'src="[^"]*"' "$page" | cut -d'"' -f2 | sort -u >"$scratch/images"
[ "$(wc -l <"$scratch/images")" -ge 6 ]
while read -r image; do
  [ -s "$scratch/out/$image" ] || { echo "the page shows $image, which does not exist" >&2; exit 1; }
done <"$scratch/images"
! grep -qE 'https?://' "$page" || { echo "the page needs the network" >&2; exit 1; }
grep -q 'not refuted' "$page"
status=0
"$TRIBUNAL" replay "$scratch/out/counterexample.jsonl" >"$scratch/replayed" || status=$?
[ "$status" -eq 1 ] && grep -q 'sf-double .*WRONG' "$scratch/replayed"

