#!/usr/bin/env bash
# Every source file is as clang-format leaves it.
set -euo pipefail
cd "$SOURCE_DIR"
mapfile -t sources < <(find main.cpp core exact tracer tests -name '*.h' -o -name '*.cpp')
sources+=(exact/report/page/src/*.js exact/report/page/test/*.mjs exact/report/page/build.mjs)
[ ${#sources[@]} -gt 3 ] || { echo "no source files found" >&2; exit 1; }
clang-format --dry-run -Werror "${sources[@]}"
