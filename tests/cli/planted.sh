#!/usr/bin/env bash
# The program with planted bugs: fuzz finds them as it would find anyone's, and leaves the sound method beside alone.
source "$(dirname "$0")/common.bash"
cd "$scratch"
TRIBUNAL=$PLANTED

expect 0 methods && says out "Jimenez's branch w = 0 as ported"
for bug in planted-jimenez-w0 planted-filter-64 planted-cgal-unguarded; do
  expect 1 fuzz --method "$bug,sf-rational" --seed 97 --count 8000 --out found
  ! grep -E '^sf-rational .* [1-9][0-9]* +[0-9.]+ %$' out || { echo "sf-rational is blamed for $bug" >&2; exit 1; }
  head -n 1 found/counterexamples.jsonl >first.jsonl && says first.jsonl "\"method\":\"$bug\""
  expect 1 replay first.jsonl && says out WRONG
done
for bug in planted-stops-early planted-hole-edges planted-one-plane; do
  expect 1 fuzz --method "$bug,sf-epick,sound-polygon" --family polygon-affine,polygon-grid,polygon-warped --seed 97 --count 3000 --keep 3 --out rings
  ! grep -v "\"method\":\"$bug\"" rings/counterexamples.jsonl || { echo "another is blamed for $bug" >&2; exit 1; }
  expect 1 replay rings/counterexamples.jsonl && says out WRONG
done
expect 0 fuzz --method sound-jimenez,sound-filter,sound-expansion --seed 97 --count 8000
expect 4 fuzz --method sf-double,planted-environment --count 8000
says err 'planted-environment changed the floating-point environment'
expect 1 certify --method planted-jimenez-w0 --out certificate && says out 'refuted'
