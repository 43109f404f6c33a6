#!/usr/bin/env bash
# `run` names its benchmarks and refuses others; the chart is drawn from a benchmark's JSON.
source "$(dirname "$0")/common.bash"
cd "$scratch"

status=0
"$SOURCE_DIR/run" bench nothing 2>err || status=$?
[ $status -eq 2 ] && says err 'there are: polygon predicate tracer'

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
