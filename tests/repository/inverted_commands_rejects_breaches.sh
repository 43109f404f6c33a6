#!/usr/bin/env bash
# The test of inverted commands passes a sound tree and rejects each planted breach.
set -euo pipefail
inverted=$SOURCE_DIR/tests/repository/inverted_commands.sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$scratch/tests/cli"

sound() {
  sed 's/NOT/!/' >"$scratch/tests/cli/a.sh" <<'SCRIPT'
NOT grep -q x out || { echo "x" >&2; exit 1; }
if NOT cmp -s a b; then exit 1; fi
says out x && NOT grep -v y out || exit 1
[ ! -e no ] && [ "$a" != b ]
# NOT is ignored
SCRIPT
}

rejects() {  # LINE: a sound script with this line added; NOT stands for the inversion
  sound
  printf '%s\n' "${1/NOT/!}" >>"$scratch/tests/cli/a.sh"
  if bash "$inverted" "$scratch" 2>"$scratch/report"; then
    echo "not rejected: $1" >&2
    exit 1
  fi
}

sound
bash "$inverted" "$scratch"
rejects 'NOT grep -q x out'
rejects '  NOT cmp -s a b'
rejects 'says out y && NOT grep -q x out'
rejects 'says out y || NOT grep -q x out'
rejects 'for f in a b; do NOT grep -q x $f; done'
rm "$scratch/tests/cli/a.sh"
if bash "$inverted" "$scratch" 2>/dev/null; then
  echo "a tree without scripts was accepted" >&2
  exit 1
fi
echo "every planted breach was rejected"
