#!/usr/bin/env bash
# one_definition.sh ROOT: no two classes have one name with linkage. The linker keeps one of their destructors for both, and
# nothing says so until an exception runs the wrong one. Prints the definitions of each such name as file:line.
set -euo pipefail
cd "$1"

# Definitions stand at the left margin, namespaces are closed by `}  // namespace NAME`; those without a name keep theirs.
definitions() {
  find core exact tracer '(' -name '*.h' -o -name '*.cpp' ')' -print0 | sort -z | xargs -0 awk '
    FNR == 1 { depth = 0 }
    /^namespace.*\{$/ { space[++depth] = NF == 2 ? "(anonymous)" : $2; next }
    /^}  \/\/ namespace/ { if (depth > 0) --depth; next }
    /^(struct|class|union|enum class|enum) [A-Za-z_0-9]+ [^;<]*\{/ {
      name = $1 == "enum" && $2 == "class" ? $3 : $2
      path = ""
      for (i = 1; i <= depth; ++i) path = path space[i] "::"
      if (path !~ /anonymous/) print path name, FILENAME ":" FNR
    }'
}

twice=$(definitions | awk '{ places[$1] = places[$1] "\n  " $2; ++n[$1] } END { for (k in n) if (n[k] > 1) print k ":" places[k] }')
[ -z "$twice" ] && exit 0
printf 'classes of one name, of which the linker makes one:\n%s\n' "$twice" >&2
exit 1
