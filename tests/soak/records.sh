#!/usr/bin/env bash
# Thousands of damaged logs, checkpoints and records, field by field, each sealed anew (tests/cli/mutants.sh).
set -euo pipefail
status=0
MUTANTS=${TRIBUNAL_SOAK_MUTANTS:-800} bash "$SOURCE_DIR/tests/cli/mutants.sh" >"$SCRATCH/said" 2>&1 || status=$?
cat "$SCRATCH/said"
read -r tried broke <<<"$(sed -nE 's/^tried ([0-9]+), broke ([0-9]+): .*/\1 \2/p' "$SCRATCH/said" | awk '{ t += $1; b += $2 } END { print t + 0, b + 0 }')"
[ "$status" -eq 0 ] || [ "$broke" -gt 0 ] || broke=1
echo "tried $tried, broke $broke: logs, checkpoints and records of our own, a field of each damaged and the chain made anew"
[ "$status" -eq 0 ]
