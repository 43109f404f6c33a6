#!/usr/bin/env bash
# Every program in docs/using-the-library.md compiles against the installed package, with warnings as errors, and
# prints what its comments say.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
page=$SOURCE_DIR/docs/using-the-library.md

awk -v dir="$scratch" '
  /^```cpp$/ { file = sprintf("%s/example%d.cpp", dir, ++count); next }
  /^```$/ { file = ""; next }
  file != "" { print > file }' "$page"
examples=("$scratch"/example*.cpp)
[ ${#examples[@]} -ge 5 ] || { echo "only ${#examples[@]} examples found" >&2; exit 1; }

cmake --install "$BUILD_DIR" --prefix "$scratch/prefix" >"$scratch/log"
{
  echo 'cmake_minimum_required(VERSION 3.25)'
  echo 'project(examples LANGUAGES CXX)'
  echo 'find_package(tribunal REQUIRED COMPONENTS tree)'
  for example in "${examples[@]}"; do
    name=$(basename "$example" .cpp)
    echo "add_executable($name $name.cpp)"
    echo "target_compile_options($name PRIVATE -Wall -Wextra -Werror)"
    echo "target_link_libraries($name PRIVATE tribunal::tree)"
  done
} >"$scratch/CMakeLists.txt"
cmake -G Ninja -S "$scratch" -B "$scratch/build" -DCMAKE_PREFIX_PATH="$scratch/prefix" -DCMAKE_CXX_COMPILER="$CXX" \
  -DCMAKE_CXX_FLAGS="$CXXFLAGS" >"$scratch/log"
cmake --build "$scratch/build"

for example in "${examples[@]}"; do
  sed -n 's/.*\/\/ prints: //p' "$example" >"$scratch/expected"
  "$scratch/build/$(basename "$example" .cpp)" | diff "$scratch/expected" - ||
    { echo "$example prints something else" >&2; exit 1; }
done

# The headers that strangers include drag in neither CGAL nor GMP nor Highway.
for header in filtered filtered_polygon batch rounded_parameter crossing; do
  echo "#include \"exact/filtered/$header.h\"" >"$scratch/include.cpp"
  if "$CXX" -std=c++20 -I"$SOURCE_DIR" -M "$scratch/include.cpp" | grep -E 'CGAL|gmp|hwy'; then
    echo "exact/filtered/$header.h includes more than it says" >&2
    exit 1
  fi
done
