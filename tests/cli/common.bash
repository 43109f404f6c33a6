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

# plugin NAME FLAG… SOURCE: NAME.so
plugin() {
  local name=$1
  shift
  ${CC:-cc} -std=c99 -pedantic -Wall -Wextra -Werror -O2 -ffp-contract=off -shared -fPIC -I "$SOURCE_DIR/exact/plugin" -o "$name.so" "$@" -lm
}
