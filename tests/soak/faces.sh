#!/usr/bin/env bash
# Faces of a million corners, triangulated: combs, a star with spikes a few ulps wide, corners at distances of all
# exponents, edges that run back along one line. Each must be triangulated, and within a minute of processor time.
set -euo pipefail
corners=${TRIBUNAL_SOAK_CORNERS:-1000000}
tried=0 broke=0
for shape in comb turned-comb star wild zigzag; do
  python3 "$SOURCE_DIR/tests/soak/great_face.py" "$shape" "$corners" >"$SCRATCH/$shape.off"
  TIMEFORMAT=%U
  status=0
  # A method without a test of polygons is given triangles.
  taken=$( { time "$TRIBUNAL" render "$SCRATCH/$shape.off" --method mt-double --size 16x12 --threads 1 \
    -o "$SCRATCH/$shape.png" >"$SCRATCH/out" 2>"$SCRATCH/err"; } 2>&1) || status=$?
  tried=$((tried + 1))
  if [ "$status" -ne 0 ] || awk -v s="$taken" 'BEGIN { exit !(s > 60) }'; then
    broke=$((broke + 1))
    cat "$SCRATCH/err"
  fi
  echo "$shape, $corners corners: exit $status, $taken s of processor time"
  rm "$SCRATCH/$shape.off"
done
echo "tried $tried, broke $broke: faces of $corners corners triangulated"
[ "$broke" -eq 0 ]
