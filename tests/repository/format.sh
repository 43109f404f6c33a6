#!/usr/bin/env bash
# Every source file is as clang-format leaves it.
set -euo pipefail
cd "$SOURCE_DIR"
mapfile -t sources < <(find main.cpp core exact tracer tests -name '*.h' -o -name '*.cpp')
[ ${#sources[@]} -gt 0 ] || { echo "no source files found" >&2; exit 1; }
clang-format --dry-run -Werror "${sources[@]}"
