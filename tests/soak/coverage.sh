#!/usr/bin/env bash
# Branch coverage of what decides: 100 %, but for the branches that tests/coverage/exceptions.tsv argues for.
set -euo pipefail
measured=$SCRATCH/coverage
rm -rf "$measured"
mkdir -p "$measured"
python3 "$SOURCE_DIR/tests/coverage/measure.py" "$measured"  # by g++ and its gcov
exec python3 "$SOURCE_DIR/tests/coverage/check.py" "$measured/coverage.json"
