#!/usr/bin/env bash
# Static analysis of all sources (tests/analysis): no finding of clang-tidy or cppcheck that is not argued.
# analysis.sh [ARG…]: as analyse.py takes them, --only REGEX and --tool NAME among others.
set -euo pipefail
exec python3 "$SOURCE_DIR/tests/analysis/analyse.py" "$SCRATCH/analysis" "$@"
