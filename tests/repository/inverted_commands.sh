#!/usr/bin/env bash
# inverted_commands.sh ROOT: `set -e` ignores the failure of a command that `!` inverts, so one that stands alone or at the end
# of a list checks nothing. Prints every such command of the tests' scripts: `|| { …; exit 1; }` must follow on its line.
set -euo pipefail
cd "$1/tests"
scripts=$(find . \( -name '*.sh' -o -name '*.bash' \) | sort)
[ -n "$scripts" ] || { echo "no scripts in tests" >&2; exit 1; }
# shellcheck disable=SC2086  # one word a script
breaches=$(awk -v inverted='(^|&&|[|][|]|;|[{]|(^|[ ;])(do|then|else))[ \t]*![ \t]' '
  !/^[ \t]*#/ && match($0, inverted) && substr($0, RSTART + RLENGTH) !~ /[|][|]/ { print FILENAME ":" FNR ": " $0 }' $scripts)
[ -z "$breaches" ] || { printf 'an inverted command that cannot fail, expected `|| { …; exit 1; }` after it:\n%s\n' "$breaches" >&2; exit 1; }
