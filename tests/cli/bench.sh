#!/usr/bin/env bash
# `run` names its benchmarks and refuses others; the chart is drawn from a benchmark's JSON.
source "$(dirname "$0")/common.bash"
cd "$scratch"

# run_ends CODE ARG…: `run` ends with this exit code; what it says is left in out and err.
run_ends() {
  local expected=$1 status=0
  shift
  "$root/run" "$@" >out 2>err || status=$?
  [ "$status" -eq "$expected" ] || { echo "run $*: exit $status, expected $expected" >&2; cat err >&2; exit 1; }
}
root=$SOURCE_DIR
run_ends 2 bench nothing && says err 'there are: paper polygon predicate tracer'
run_ends 2 && says err 'usage: ./run build'
run_ends 2 biuld && says err 'no such command: biuld'
run_ends 2 build extra && says err 'build takes no arguments, found: extra'
run_ends 2 test extra && says err 'test takes no arguments, found: extra'
run_ends 0 --help && says out 'usage: ./run build'

# The last result stays until there is a new one: a run that measures nothing leaves it, and nothing beside it. The
# benchmark, cmake and dpkg-query are played by scripts.
root=$scratch/repository
mkdir -p "$root/tests/bench/predicate" "$root/build/release/tests" "$root/data/meshes" "$root/docs" bin
cp "$SOURCE_DIR/run" "$root/run"
cp "$SOURCE_DIR"/docs/{compare,join}_benches.py "$root/docs"
cat >"$root/build/release/tests/predicate_bench" <<'EOF'
#!/bin/sh
file=${1#--benchmark_out=}
: >"$file"
case $3 in
  one | two | -all) echo "{\"benchmarks\": [\"$3\"]}" >"$file" && echo "ratio a_over_b 1.$4 [1.1, 1.3]" ;;
  --benchmark_list_tests) ;;
  *) exit 1 ;;
esac
EOF
printf '#!/bin/sh\n' >bin/cmake
# shellcheck disable=SC2016  # $p is the script's
printf '#!/bin/sh\nfor p; do echo "installed $p"; done\n' >bin/dpkg-query
chmod +x bin/* "$root/build/release/tests/predicate_bench"
PATH=$scratch/bin:$PATH
result=$root/out/bench-predicate.json
# holds WORD: the result is of three processes that wrote it.
holds() { python3 -c 'import json, sys; assert json.load(open(sys.argv[1]))["benchmarks"] == 3 * [sys.argv[2]]' "$result" "$1"; }
run_ends 1 bench predicate none && [ ! -e "$result" ]
run_ends 0 bench predicate one 2 && holds one
run_ends 1 bench predicate none && says err 'out/bench-predicate.json is left as it was' && holds one
run_ends 0 bench predicate --benchmark_list_tests && holds one

# Without a name all are run; a run is held against the one before.
run_ends 0 bench predicate two 3 && says out '1 of 1 medians of this run lie within' && holds two
run_ends 0 bench predicate two 4 && says out 'outside: a_over_b 1.4, before 1.3 [1.1, 1.3]'
mkdir "$root/tests/bench/other"
sed 's/1\.\$4/1.2/' "$root/build/release/tests/predicate_bench" >"$root/build/release/tests/other_bench"
chmod +x "$root/build/release/tests/other_bench"
rm "$result"
run_ends 0 bench -all 2
[ "$(ls "$root/out")" = "$(printf 'bench-%s\n' other.json other.txt predicate.json predicate.txt)" ]

/usr/bin/python3 - <<'PY'
import json
names = ["hits_7/single", "hits_7/epick", "mantissa_fill_8/single", "mantissa_fill_50/single",
         "share_degenerate_1/epick", "share_degenerate_100/epick"]
runs = [{"run_type": "iteration", "run_name": n + "/repeats:2", "items_per_second": 1e7 + i}
        for n in names for i in range(2)]
json.dump({"benchmarks": runs}, open("bench.json", "w"))
PY
/usr/bin/python3 "$SOURCE_DIR/docs/plot_predicate.py" bench.json chart.png
head -c 4 chart.png | grep -q PNG

# The same for polygons.
/usr/bin/python3 - <<'PY'
import json
names = [f"hits_7/{o}/n{n}/{m}" for o in ("convex", "concave") for n in (4, 256) for m in ("sf_filtered", "haines_double")]
runs = [{"run_type": "iteration", "run_name": n + "/repeats:2", "items_per_second": 1e7 + i}
        for n in names for i in range(2)]
json.dump({"benchmarks": runs}, open("polygons.json", "w"))
PY
/usr/bin/python3 "$SOURCE_DIR/docs/plot_polygon.py" polygons.json polygons.png
head -c 4 polygons.png | grep -q PNG
