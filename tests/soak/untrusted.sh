#!/usr/bin/env bash
# Untrusted text through each field of every command, all of it; the everyday suite makes one run in 61.
set -euo pipefail
cd "$SCRATCH"
EVERY=1 bash "$SOURCE_DIR/tests/cli/untrusted.sh"
