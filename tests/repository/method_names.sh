#!/usr/bin/env bash
# method_names.sh ROOT: a method's name stands in the table of methods and on the command line, and nowhere else: code
# asks for roles and capabilities. Prints every string with such a name, or the beginning of one, as file:line:text.
set -euo pipefail
cd "$1"
table=exact/methods/methods.cpp
shelf=exact/methods/shelf.h

# A row {"name", make} is a method; one ShelfRow<Test>{"name"} is two, name-float and name-double.
names=$(sed -nE 's/^ *\{"([a-z0-9-]+)", .*/\1/p; s/^ *ShelfRow<[A-Za-z]+>\{"([a-z0-9-]+)".*/\1-float\n\1-double/p' "$table" "$shelf")
[ "$(wc -w <<<"$names")" -ge 5 ] || { echo "$table: expected a table of methods, one row each" >&2; exit 1; }
whole=$(paste -sd'|' <<<"$names")
first=$(sed -E 's/-(float|double)$//; s/^(sf|cgal)-.*/\1/' <<<"$names" | sort -u | paste -sd'|')

# A name as a whole word within a string; a string that a name begins with ("sf-"); a look-up of any name in the code.
by_name="\"([^\"]*[^a-z0-9\"-])?($whole)([^a-z0-9\"-][^\"]*)?\"|\"($first)-\"|find_method\(\""

# Twice, so that what stands in a comment only falls away in between.
breaches=$(grep -rnE --include='*.h' --include='*.cpp' "$by_name" core exact tracer |
  grep -vE "^($table|$shelf|exact/cli/|tracer/cli/)" | sed 's://.*::' | grep -E "$by_name" || true)
[ -z "$breaches" ] && exit 0
printf 'a method by name, outside the table of methods and the command line (exact/methods/methods.h has roles):\n%s\n' \
  "$breaches" >&2
exit 1
