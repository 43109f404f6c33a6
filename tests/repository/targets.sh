#!/usr/bin/env bash
# Code for AVX2 and AVX-512 runs only where the machine has it: its object files hold no static initialiser, which would run
# anywhere, and no weak function that a linker could take for the same one of another file. In $BUILD_DIR.
set -euo pipefail
found=0
while IFS= read -r object; do
  found=$((found + 1))
  if objdump -h "$object" | grep '\.init_array' >/dev/null; then
    echo "$object: has a static initialiser" >&2
    exit 1
  fi
  weak=$(nm -C "$object" | grep -E ' [WuVv] ' | grep -vE '::N_AVX|<N_AVX|batch_avx(2|512)::' || true)
  [ -z "$weak" ] || { printf '%s: weak symbols:\n%s\n' "$object" "$weak" >&2; exit 1; }
done < <(find "$BUILD_DIR" -name '*_avx2.cpp.o' -o -name '*_avx512.cpp.o' | grep -v bench)
[ "$found" -ge 6 ] || { echo "only $found object files for vector targets in $BUILD_DIR" >&2; exit 1; }
