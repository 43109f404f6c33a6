#!/usr/bin/env bash
# random_streams.sh ROOT: draws of the program and its benchmarks take their numbers from the register of random streams.
# Prints every draw from another number, and every owner in the register whom nobody or more than one asks for.
# Tests draw for themselves.
set -euo pipefail
cd "$1"
register=$(find . -name streams.h -path '*/families/*' -not -path './build/*' | head -1)
[ -n "$register" ] || { echo "no families/streams.h" >&2; exit 1; }

sources() { find . \( -name '*.h' -o -name '*.cpp' \) -not -path './build/*' -not -path "$register" |
  grep -E '^\./(tests/bench/|[^t]|t[^e])' | sort; }
code() { sources | xargs grep -nE "$1" /dev/null | sed 's:[[:space:]]*//.*::' | grep -E "$1" || true; }

# A number as the first argument of a draw, or as the value of something called a stream.
by_number='\bDraw( [a-z_]+)?[({](static_cast<[^>]*>\()?[0-9]|\bDraw( [a-z_]+)?[({][^"]*\) *\+ *[0-9]|\b([a-z_]+_stream|uint32_t stream) *= *[0-9]'
breaches=$(code "$by_number")
[ -z "$breaches" ] || { printf 'a random stream by number, not from %s:\n%s\n' "$register" "$breaches" >&2; exit 1; }

owners=$(sed -nE 's/^ *\{"([^"]+)", [0-9]+(, [0-9]+)?\},$/\1/p' "$register")
[ "$(wc -l <<<"$owners")" -ge 2 ] || { echo "$register: expected a table of streams, one row each" >&2; exit 1; }
while read -r owner; do
  uses=$(code "(stream_of|streams_owned_by)\(\"$owner\"\)" | wc -l)
  [ "$uses" -eq 1 ] || { echo "random stream \"$owner\": asked for $uses times, expected once" >&2; exit 1; }
done <<<"$owners"
