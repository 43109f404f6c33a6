#!/usr/bin/env bash
# `run soak` runs the long tests and writes what they tried into a table. The tests, cmake and dpkg-query are played by scripts.
source "$(dirname "$0")/common.bash"
cd "$scratch"
root=$scratch/repository
mkdir -p "$root/tests/soak" "$root/data/meshes" "$root/docs" bin
cp "$SOURCE_DIR/run" "$root/run"
cp "$SOURCE_DIR/docs/soak_table.py" "$root/docs"
printf '#!/bin/sh\n' >bin/cmake
# shellcheck disable=SC2016  # $p is the script's
printf '#!/bin/sh\nfor p; do echo "installed $p"; done\n' >bin/dpkg-query
chmod +x bin/*
PATH=$scratch/bin:$PATH

# soak_test NAME: reads the script NAME.
soak_test() { { echo '#!/bin/sh'; cat; } >"$root/tests/soak/$1.sh" && chmod +x "$root/tests/soak/$1.sh"; }
# run_ends CODE ARG…: `run soak` ends with this exit code; what it says is left in out and err.
run_ends() {
  local expected=$1 status=0
  shift
  "$root/run" soak "$@" >out 2>err || status=$?
  [ "$status" -eq "$expected" ] || { echo "run soak $*: exit $status, expected $expected" >&2; cat out err >&2; exit 1; }
}
# row NAME KEY: a value of its row in soak.json.
row() { python3 -c 'import json, sys; print({r["name"]: r for r in json.load(open(sys.argv[1]))["rows"]}[sys.argv[2]][sys.argv[3]])' "$root/out/soak.json" "$1" "$2"; }
# row_is NAME KEY VALUE
row_is() { [ "$(row "$1" "$2")" = "$3" ] || { echo "row $1: $2 is $(row "$1" "$2"), expected $3" >&2; exit 1; }; }

# A sound one finds its environment and an empty folder of its own.
soak_test sound <<'EOT'
[ -z "$(ls "$SCRATCH")" ] && touch "$SCRATCH/left" || exit 1
[ "$BUILD_DIR/tribunal" = "$TRIBUNAL" ] && [ -n "$CXX" ] && [ -n "$CC" ] && [ -f "$SOURCE_DIR/run" ] || exit 1
echo "tried 1,234, broke 0: answers for ${TRIBUNAL_SOAK_SECONDS:-3600} s"
EOT
run_ends 0
says out 'answers for 3600 s'
row_is sound tried 1234
row_is sound whole True
row_is sound shortened_to None
run_ends 0 sound

# Every way to be broken: by its own count, by its exit code, without a closing line, without a try. Those after it still run.
soak_test broke <<<'echo "tried 9, broke 2: answers"'
soak_test exits <<<'echo "tried 9, broke 0: answers"; exit 3'
soak_test idle <<<'echo "tried 0, broke 0: answers"'
soak_test silent <<<'echo progress'
for name in broke exits idle silent; do
  run_ends 1 "$name"
  row_is "$name" whole False
done
row_is exits exit 3
says out 'ended without its closing line'
run_ends 1
says out 'answers for 3600 s'

# The page is written only on request; what was not run keeps its row, what is gone loses it.
printf 'before\n<!-- The table is written by ./run soak --write -->\n<!-- End of the table -->\nafter\n' >page
cp page "$root/docs/reliability.md"
run_ends 0 sound
cmp page "$root/docs/reliability.md"
run_ends 1 --write
grep -q '^| `broke` | answers | 9 | 2 | [0-9]* s |' "$root/docs/reliability.md"
rm "$root/tests/soak/idle.sh"
soak_test broke <<<'echo "tried 9, broke 0: answers"'
TRIBUNAL_SOAK_SECONDS=5 run_ends 0 --write broke sound
grep -q '^| `broke` | answers | 9 | 0 | [0-9]* s (shortened) |' "$root/docs/reliability.md"
grep -q '^| `sound` | answers for 5 s | 1,234 | 0 | [0-9]* s (shortened) |' "$root/docs/reliability.md"
grep -q '^| `exits` | answers | 9 | 0 (exit 3: unfinished) |' "$root/docs/reliability.md"
lacks repository/docs/reliability.md '`idle`'
[ "$(sed -n '1p;$p' "$root/docs/reliability.md" | paste -sd' ')" = 'before after' ]

run_ends 2 nothing && says err 'no such soak: nothing; there are: broke exits silent sound'
TRIBUNAL_SOAK_SECONDS=0 run_ends 2 && says err 'TRIBUNAL_SOAK_SECONDS: expected a whole number'
