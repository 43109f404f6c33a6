#!/usr/bin/env bash
# Every command of tests/determinism/manifest.txt, ten times as many cases as the everyday test asks: threads, locale, folder,
# interrupts; and the same bytes from g++ and clang++ at -O0 and -O3 -march=native.
source "$SOURCE_DIR/tests/cli/common.bash"
rmdir "$scratch" && scratch=$SCRATCH
source "$SOURCE_DIR/tests/determinism/determinism.bash"
make_locale
tried=0 broke=0
# compare NAME ONE OPTION…: hashes, held against those of ONE; each command counts.
compare() {
  local name=$1 one=$2 differing
  shift 2
  if ! hashes "$name" "$@"; then
    echo "$name: a command failed" >&2
    tried=$((tried + 1)) broke=$((broke + 1))
    return 0
  fi
  differing=$(grep -vcxFf "$scratch/$one.hashes" "$scratch/$name.hashes" || true)
  tried=$((tried + $(wc -l <"$scratch/$name.hashes"))) broke=$((broke + differing))
  same "$one" "$name" || true
  echo "  $name: $(wc -l <"$scratch/$name.hashes") commands, $differing differ"
}

scale=${TRIBUNAL_DETERMINISM_SCALE:-10}
hashes reference --long --threads 1 --scale "$scale"
for threads in 2 7 64; do compare "threads-$threads" reference --long --threads "$threads" --scale "$scale"; done
compare default reference --long --scale "$scale"
folder="$scratch/another folder/deeper" compare folder reference --long --threads 2 --scale "$scale"
in_locale=1 compare locale reference --long --threads 2 --scale "$scale"
compare interrupted reference --long --threads 2 --interrupt --scale "$scale"

hashes across --across --long --threads 2
for compiler in g++ clang++; do
  for level in "-O0" "-O3 -march=native"; do
    name=$compiler${level%% *}
    build=$SOURCE_DIR/build/determinism/$name
    # No build type: the flags are these and the project's own, -ffp-contract=off among them.
    cmake -G Ninja -S "$SOURCE_DIR" -B "$build" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=None \
      -DCMAKE_CXX_FLAGS="$level -DNDEBUG" -DTRIBUNAL_TESTS=OFF >"$scratch/configure.log"
    cmake --build "$build" --target tribunal -j "$(nproc)" | tail -n 1
    compare "$name" across --across --long --threads 2 -- "$build/tribunal"
  done
done
echo "tried $tried, broke $broke: hashes of $(wc -l <"$scratch/reference.hashes") commands, pictures and pages among them, by 1, 2, 7 and 64 threads, in another locale and folder, interrupted and resumed, and by g++ and clang++ at -O0 and -O3 -march=native"
[ "$broke" -eq 0 ]
