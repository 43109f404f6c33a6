#!/usr/bin/env bash
# The test of random streams passes a sound tree and rejects each planted breach.
set -euo pipefail
streams=$SOURCE_DIR/tests/repository/random_streams.sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

sound_tree() {
  rm -rf "$scratch/tree"
  mkdir -p "$scratch"/tree/{a/families,tracer,tests/bench}
  cd "$scratch/tree"
  printf '    {"one", 1},\n    {"many", 10, 5},\n' >a/families/streams.h
  printf 'Draw draw(stream_of("one"), seed, k);  // not Draw draw(7, seed, k)\n' >a/families/one.cpp
  printf 'first = streams_owned_by("many").first;\n' >tracer/many.cpp
  printf 'Draw draw(77, 1, 0);\n' >tests/a_test.cpp
}

rejects() {  # FILE LINE: a sound tree with this line added to this file
  sound_tree
  printf '%s\n' "$2" >>"$1"
  if bash "$streams" . 2>"$scratch/report"; then
    echo "not rejected: $2 in $1" >&2
    exit 1
  fi
}

sound_tree
bash "$streams" .
rejects a/b.cpp 'Draw draw(1001, seed, k);'
rejects tracer/b.h 'Draw(3, seed, k).next();'
rejects a/b.cpp 'Draw draw{21, seed, k};'
rejects tests/bench/b.cpp 'constexpr std::uint32_t ray_stream = 910;'
rejects a/b.cpp 'Draw draw(static_cast<std::uint32_t>(1000 + r), seed, k);'
rejects a/b.cpp 'Draw draw(stream_of("one"), seed, k);'
rejects a/families/streams.h '    {"nobody", 20},'
sound_tree
: >a/families/streams.h
if bash "$streams" . 2>/dev/null; then
  echo "an empty register was accepted" >&2
  exit 1
fi
echo "every planted breach was rejected"
