#!/usr/bin/env bash
# Every allocation, mapping and thread start of small runs of each command, made to fail once and for good.
set -euo pipefail
exec python3 -B "$SOURCE_DIR/tests/faults/resources.py" --program "$TRIBUNAL" --source "$SOURCE_DIR" --scratch "$SCRATCH" --jobs "$(nproc)"
