#!/usr/bin/env bash
# layering.sh ROOT: includes run down the table of rooms in docs/architecture.md, CGAL and GMP stay behind their doors, and
# the top level holds what it should. Prints every breach as file:line:include.
set -euo pipefail
cd "$1"
breaches=0

# breach WHY: reports the lines on standard input, if any.
breach() {
  local lines
  lines=$(cat)
  [ -n "$lines" ] || return 0
  printf '%s:\n%s\n' "$1" "$lines" >&2
  breaches=$((breaches + 1))
}

# includes PATTERN PATH…: the include lines whose quoted or bracketed name matches.
includes() {
  local pattern=$1
  shift
  grep -rnE --include='*.h' --include='*.cpp' "^[[:space:]]*#[[:space:]]*include[[:space:]]*$pattern" "$@" || true
}

# except PATTERN: drops the include lines that match.
except() { grep -vE "#[[:space:]]*include[[:space:]]*$1" || true; }

# The rooms, one a line, as the table lists them.
rooms() { sed -nE 's/^\| `([a-z_0-9/]+)\/` \|.*/\1/p' docs/architecture.md; }

# The folders that hold sources.
folders() { find core exact tracer '(' -name '*.h' -o -name '*.cpp' ')' -printf '%h\n' | sort -u; }

[ -n "$(rooms)" ] || { echo "docs/architecture.md: no table of rooms" >&2; exit 1; }

breach 'a folder of sources without a row in the table of rooms' < <(folders | grep -vxFf <(rooms) || true)
breach 'a row in the table of rooms without sources' < <(rooms | grep -vxFf <(folders) || true)
breach 'two rows of one room' < <(rooms | sort | uniq -d)

# Reads the rooms, then include lines; prints those that name a file of a room further down, or of none.
upward() {
  awk 'function folder(path) { sub(/\/[^\/]*$/, "", path); return path }
    NR == FNR { row[$0] = NR; next }
    {
      split($0, part, ":"); split($0, quoted, "\"")
      from = folder(part[1]); to = folder(quoted[2])
      if (!(to in row) || row[to] > row[from]) print
    }' <(rooms) -
}

breach 'a file may include files of its own room and of rooms above it in the table' \
  < <(includes '"' core exact tracer | upward)
breach 'core may use core, the standard library and GLM' \
  < <(includes '' core | except '("core/|<[a-z0-9_]+>|<glm/)')
breach 'includes are written from the root' < <(includes '"' main.cpp tests | except '"(core|exact|tracer|tests)/')
breach 'GMP stays in exact/' < <(includes '<(gmp|mpfr|mpf)' core tracer main.cpp)
breach 'CGAL stays in files named cgal_*.cpp, which are compiled as it needs' \
  < <(includes '<CGAL/' core exact tracer main.cpp tests | grep -vE '^([^:]*/)?cgal_[^/:]*\.cpp:' || true)
breach 'the AABB tree of CGAL is GPL: benchmarks only' \
  < <(includes '<CGAL/AABB' core exact tracer main.cpp tests | grep -v '^tests/bench/' || true)
breach 'not part of the top level' < <(find . -mindepth 1 -maxdepth 1 -printf '%P\n' | grep -vxE \
  'CMakeLists\.txt|core|exact|tracer|tests|data|docs|README\.md|LICENSE|main\.cpp|run|CMakePresets\.json|\.clang-format|\.ci|\.gitignore|\.git|build|out|CMakeUserPresets\.json' || true)

[ "$breaches" -eq 0 ]
