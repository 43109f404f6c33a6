#!/usr/bin/env bash
# The bytes of every command of tests/determinism/manifest.txt are the same by 1, 7 and 64 threads, in another working
# folder and a locale with a decimal comma, and where a run was interrupted and went on with other threads.
source "$(dirname "$0")/common.bash"
source "$SOURCE_DIR/tests/determinism/determinism.bash"
make_locale

hashes one --threads 1
# Fewer lines than commands, or two commands with the same bytes, and the comparison would be of nothing.
commands=$(grep -cv '^[#+]' "$SOURCE_DIR/tests/determinism/manifest.txt")
[ "$commands" -ge 18 ] && [ "$(cut -d' ' -f1 "$scratch/one.hashes" | sort -u | wc -l)" -eq "$commands" ]

folder="$scratch/another folder/deeper" in_locale=1 hashes elsewhere --threads 7
same one elsewhere
hashes parts --threads 64 --interrupt --only cases,classify,judge,fuzz,resumed,polygons,relations,leak,render,render-exact
same one parts

# It can fail: another seed is another hash.
mkdir "$scratch/bin"
printf '#!/bin/bash\nexec "%s" "${@/#5/6}"\n' "$TRIBUNAL" >"$scratch/bin/other-seed"
chmod +x "$scratch/bin/other-seed"
hashes other --only resumed -- "$scratch/bin/other-seed"
! same one other 2>/dev/null || { echo "another seed gave the same hash" >&2; exit 1; }
