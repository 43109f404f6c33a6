#!/usr/bin/env bash
# Every mutant of what decides (docs/mutation.md): each is killed, or argued equivalent.
set -euo pipefail
export TMPDIR=$SCRATCH
exec python3 "$SOURCE_DIR/tests/mutation/run.py" --jobs "$(nproc)" --cxx "${CXX:-g++}"
