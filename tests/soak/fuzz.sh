#!/usr/bin/env bash
# An hour of fuzz over all families: half of it on triangles, half on polygons. The certified test must answer every case
# right, the test in plain doubles must be caught, memory and rate must stay flat (watch_fuzz.py).
set -euo pipefail
seconds=${TRIBUNAL_SOAK_SECONDS:-3600}
half=$(((seconds + 1) / 2))
status=0
for operands in triangles polygons; do
  python3 "$SOURCE_DIR/tests/soak/watch_fuzz.py" "$TRIBUNAL" "$operands" "$half" "$SCRATCH/$operands" || status=1
done
cat "$SCRATCH"/*.say
read -r tried broke <<<"$(cat "$SCRATCH"/*.count | awk '{ tried += $1; broke += $2 } END { print tried + 0, broke + 0 }')"
[ "$status" -eq 0 ] || [ "$broke" -gt 0 ] || broke=1
echo "tried $tried, broke $broke: cases of all families, \`sf-filtered\` against the exact answer, $half s of triangles and $half s of polygons, memory and rate flat"
[ "$status" -eq 0 ]
