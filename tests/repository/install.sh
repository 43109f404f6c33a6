#!/usr/bin/env bash
# What `cmake --install` puts in place works away from the build: the program runs, also with a plugin made with the
# installed header; every installed header compiles by itself; and a project of ten lines finds each component of the
# package, compiles, answers, and is linked against what the component needs and nothing else.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cmake --install "$BUILD_DIR" --prefix "$scratch/prefix" >"$scratch/log"
include=$scratch/prefix/include/tribunal
"$scratch/prefix/bin/tribunal" methods | grep sf-rational >"$scratch/found"
cc -std=c99 -shared -fPIC -I "$include/exact/plugin" -o "$scratch/mine.so" "$SOURCE_DIR/docs/examples/moeller_trumbore.c"
"$scratch/prefix/bin/tribunal" methods --plugin "$scratch/mine.so" | grep my-mt >"$scratch/found"

headers=0
while IFS= read -r header; do
  "$CXX" -std=c++20 -I "$include" -fsyntax-only -x c++ "$header"
  headers=$((headers + 1))
done < <(find "$include" -name '*.h')
[ "$headers" -ge 30 ] || { echo "only $headers headers installed" >&2; exit 1; }

# What a program may need beside the libraries of C and C++.
beyond_the_language() { objdump -p "$1" | awk '/NEEDED/ { print $2 }' | grep -vE '^lib(stdc\+\+|m|c|gcc_s|c\+\+|unwind)\.|^ld-' | sort | tr '\n' ' '; }

consumer() {  # COMPONENT ANSWER LIBRARIES: it prints the answer and needs no other libraries
  cmake -G Ninja -S "$SOURCE_DIR/tests/consumer" -B "$scratch/$1" -DCMAKE_PREFIX_PATH="$scratch/prefix" -Dcomponent="$1" \
    -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_CXX_FLAGS="$CXXFLAGS" >>"$scratch/log"
  cmake --build "$scratch/$1"
  local answer needed
  answer=$("$scratch/$1/consumer")
  [ "$answer" = "$2" ] || { echo "$1: answers $answer, expected $2" >&2; exit 1; }
  needed=$(beyond_the_language "$scratch/$1/consumer")
  [[ "$needed" =~ ^($3)$ ]] || { echo "$1: needs $needed, expected $3" >&2; exit 1; }
}

consumer predicates '111 interior' 'libgmp[.]so[.0-9]* |libgmp[.]so[.0-9]* libgmpxx[.]so[.0-9]* '
consumer tree '1 at 2' 'libgmp[.]so[.0-9]* (libgmpxx[.]so[.0-9]* )?libtbb[.]so[.0-9]* '
consumer testbed 'float: hit, sf-rational: hit at interior' '.*libgmp.*'
