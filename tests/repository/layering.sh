#!/usr/bin/env bash
# layering.sh ROOT: dependencies flow core <- exact <- tracer, CGAL and GMP stay behind their doors, and the top level
# holds what it should. Prints every breach as file:line:include.
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

for room in core exact tracer; do
  [ -n "$(find "$room" -name '*.[hc]*' -print -quit)" ] || { echo "no source files in $room" >&2; exit 1; }
done

breach 'core may use core, the standard library and GLM' \
  < <(includes '' core | except '("core/|<[a-z0-9_]+>|<glm/)')
breach 'exact may use core' < <(includes '"' exact | except '"(core|exact)/')
breach 'tracer may use core and exact' < <(includes '"' tracer | except '"(core|exact|tracer)/')
breach 'includes are written from the root' < <(includes '"' main.cpp tests | except '"(core|exact|tracer|tests)/')
breach 'GMP stays in exact/' < <(includes '<(gmp|mpfr|mpf)' core tracer main.cpp)
breach 'CGAL stays in files named cgal_*.cpp, which are compiled as it needs' \
  < <(includes '<CGAL/' core exact tracer main.cpp tests | grep -vE '^([^:]*/)?cgal_[^/:]*\.cpp:' || true)
breach 'the AABB tree of CGAL is GPL: benchmarks only' \
  < <(includes '<CGAL/AABB' core exact tracer main.cpp tests | grep -v '^tests/bench/' || true)
breach 'not part of the top level' < <(find . -mindepth 1 -maxdepth 1 -printf '%P\n' | grep -vxE \
  'CMakeLists\.txt|core|exact|tracer|tests|data|docs|README\.md|LICENSE|main\.cpp|run|CMakePresets\.json|\.clang-format|\.ci|\.gitignore|\.git|build|out|CMakeUserPresets\.json' || true)

[ "$breaches" -eq 0 ]
