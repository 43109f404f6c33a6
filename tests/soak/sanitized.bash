# Sourced by asan.sh and tsan.sh.
set -euo pipefail
cd "$SOURCE_DIR"

# flags_of PRESET: those that its build compiles with.
flags_of() { sed -n 's/^CMAKE_CXX_FLAGS:STRING=//p' "build/$1/CMakeCache.txt"; }

# A sanitizer that is not there finds nothing: this program must not end well under the flags of the preset.
# catches PRESET NAME: reads the program.
catches() {
  local status=0
  cat >"$SCRATCH/$2.cpp"
  # shellcheck disable=SC2046  # one word a flag
  "$CXX" -std=c++20 -w -g $(flags_of "$1") "$SCRATCH/$2.cpp" -o "$SCRATCH/$2" -pthread
  "$SCRATCH/$2" >"$SCRATCH/$2.out" 2>&1 || status=$?
  [ "$status" -ne 0 ] || { echo "$1 does not catch $2" >&2; exit 1; }
}

# configure PRESET
configure() { cmake --preset "$1" -DCMAKE_CXX_COMPILER="$CXX" >"$SCRATCH/configure.log" || { cat "$SCRATCH/configure.log"; exit 1; }; }

# run_suite PRESET WHAT [CTEST ARG…]: builds all, runs the tests, ends with the closing line. A test that did not run, for
# want of a mesh or of anything else, has failed.
run_suite() {
  local preset=$1 what=$2 began built ended status=0 log=$SCRATCH/tests.xml all passed
  shift 2
  began=$SECONDS
  cmake --build --preset "$preset" -j "$(nproc)"
  built=$SECONDS
  ctest --preset "$preset" --output-junit "$log" "$@" || status=$?
  ended=$SECONDS
  all=$(grep -c '^\s*<testcase ' "$log" || true)
  passed=$(grep -c '^\s*<testcase .*status="run"' "$log" || true)
  echo "tried ${all:-0}, broke $((${all:-0} - ${passed:-0})): $what; built in $(((built - began) / 60)) min, run in $(((ended - built) / 60)) min"
  [ "$status" -eq 0 ] && [ "${passed:-0}" -gt 0 ] && [ "$passed" -eq "$all" ]
}
