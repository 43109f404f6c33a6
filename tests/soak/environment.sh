#!/usr/bin/env bash
# The floating-point environment and the locale, changed at start, in threads and at many moments of each command.
set -euo pipefail
exec python3 -B "$SOURCE_DIR/tests/faults/environment.py" --program "$TRIBUNAL" --source "$SOURCE_DIR" --scratch "$SCRATCH" --most 200
