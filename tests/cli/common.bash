# Sourced by the scripts beside it.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# expect CODE ARG…: runs the program, checks its exit code; its output is left in $scratch/out and $scratch/err.
expect() {
  local expected=$1 status=0
  shift
  "$TRIBUNAL" "$@" >"$scratch/out" 2>"$scratch/err" || status=$?
  [ "$status" -eq "$expected" ] || { echo "tribunal $*: exit $status, expected $expected" >&2; cat "$scratch/out" "$scratch/err" >&2; exit 1; }
}

# says FILE TEXT: the file of $scratch holds the text.
says() { grep -qF -- "$2" "$scratch/$1" || { echo "expected '$2' in $1:" >&2; cat "$scratch/$1" >&2; exit 1; }; }

# lacks FILE TEXT: the file of $scratch does not hold the text.
lacks() { ! grep -qF -- "$2" "$scratch/$1" || { echo "unexpected '$2' in $1:" >&2; cat "$scratch/$1" >&2; exit 1; }; }

# preloaded LIBRARY: what LD_PRELOAD must be to load it: a sanitizer's runtime, where the program has one, comes first.
preloaded() { ldd "$TRIBUNAL" | awk -v library="$1" '$1 ~ /^lib[at]san/ { printf "%s:", $3 } END { print library }'; }

# plugin NAME FLAG… SOURCE: NAME.so
plugin() {
  local name=$1
  shift
  ${CC:-cc} -std=c99 -pedantic -Wall -Wextra -Werror -O2 -ffp-contract=off -shared -fPIC -I "$SOURCE_DIR/exact/plugin" -o "$name.so" "$@" -lm
}

# interrupt_and_resume ARG…: runs the command with --out parts --resume, a second at a time and with another number of
# threads each time, until it is done and ends with 1; where the first second suffices for all of it, half as long at a
# time, and so on. What the first part left stays in first-part.
interrupt_and_resume() {
  local status threads seconds parts=0
  for seconds in 1 .5 .25 .125; do
    for threads in 1 2 7 2 1 2 7 2 2 2 2; do
      timeout --foreground --preserve-status -s INT "$seconds" "$TRIBUNAL" "$@" --threads "$threads" --out parts --resume >out 2>err && status=0 || status=$?
      [ "$status" -ne 1 ] || break
      [ "$status" -eq 130 ] && says out 'INTERRUPTED' && [ ! -e parts/summary.json ] || { cat err >&2; exit 1; }
      [ -e first-part ] || cp -r parts first-part
      parts=$((parts + 1))
    done
    [ "$parts" -eq 0 ] || break
    rm -r parts
  done
  [ "$parts" -gt 0 ] || { echo "never interrupted" >&2; exit 1; }
  [ -e parts/summary.json ] || expect 1 "$@" --out parts --resume
}
