#!/usr/bin/env bash
# What `cmake --install` puts in place works away from the build: the program runs, also with a plugin made with the
# installed header, and a project of ten lines finds the package, compiles and answers.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$BUILD_DIR" --prefix "$scratch/prefix" >"$scratch/log"
"$scratch/prefix/bin/tribunal" methods | grep -q sf-rational
cc -std=c99 -shared -fPIC -I "$scratch/prefix/include/tribunal/exact/plugin" -o "$scratch/mine.so" "$SOURCE_DIR/docs/examples/moeller_trumbore.c"
"$scratch/prefix/bin/tribunal" methods --plugin "$scratch/mine.so" | grep -q my-mt
cmake -G Ninja -S "$SOURCE_DIR/tests/consumer" -B "$scratch/build" -DCMAKE_PREFIX_PATH="$scratch/prefix"
cmake --build "$scratch/build"
[ "$("$scratch/build/consumer")" = "float: hit, sf-rational: hit at interior" ]
