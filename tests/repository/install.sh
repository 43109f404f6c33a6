#!/usr/bin/env bash
# What `cmake --install` puts in place works away from the build: the program runs, and a project of ten lines finds
# the package, compiles and answers.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$BUILD_DIR" --prefix "$scratch/prefix" >"$scratch/log"
"$scratch/prefix/bin/tribunal" methods | grep -q sf-rational
cmake -G Ninja -S "$SOURCE_DIR/tests/consumer" -B "$scratch/build" -DCMAKE_PREFIX_PATH="$scratch/prefix"
cmake --build "$scratch/build"
[ "$("$scratch/build/consumer")" = "float: hit, sf-rational: hit at interior" ]
