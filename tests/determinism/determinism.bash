# Sourced by tests/cli/determinism.sh and tests/soak/determinism.sh, which have sourced tests/cli/common.bash.

# A folder for the commands: the data, and the record of a chart, which is measured once for all of them.
new_folder() {
  mkdir -p "$1"
  ln -s "$SOURCE_DIR/data" "$1/data"
  if [ ! -e "$scratch/chart.json" ]; then
    "$TRIBUNAL" chart --method mt-double,sf-double,sf-filtered --count 326 --repetitions 9 --rays 500 --quick \
      --scenes "$SOURCE_DIR/data/scenes/slivers.json" --out "$scratch/charts" >"$scratch/chart.log" 2>&1 ||
      { cat "$scratch/chart.log" >&2; exit 1; }
    mv "$scratch/charts/chart.json" "$scratch/chart.json"
  fi
  mkdir "$1/charts"
  cp "$scratch/chart.json" "$1/charts"
}

# A locale with a decimal comma and points between thousands, and a library that makes the program speak it, as a library
# that calls setlocale would.
make_locale() {
  mkdir -p "$scratch/locales"
  printf 'LC_NUMERIC\ndecimal_point ","\nthousands_sep "."\ngrouping 3\nEND LC_NUMERIC\n' >"$scratch/comma"
  localedef -c -i "$scratch/comma" "$scratch/locales/comma" >/dev/null 2>&1 || true  # it warns of the other categories
  cat >"$scratch/speak.c" <<'EOC'
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
__attribute__((constructor)) static void speak(void) {
  if (!setlocale(LC_ALL, "") || strcmp(localeconv()->decimal_point, ",") != 0) {
    fputs("no locale with a decimal comma\n", stderr);
    _Exit(9);
  }
}
EOC
  "${CC:-cc}" -shared -fPIC -o "$scratch/speak.so" "$scratch/speak.c"
}

# hashes NAME OPTION… [-- PROGRAM]: those of all commands, in $scratch/NAME.hashes. They run in $folder, or else in
# $scratch/NAME; in the locale where $in_locale is set.
hashes() {
  local name=$1 program=$TRIBUNAL options=() where=${folder:-$scratch/$1} speaking=()
  shift
  while [ $# -gt 0 ]; do
    if [ "$1" = -- ]; then program=$2; break; fi
    options+=("$1")
    shift
  done
  folder=
  new_folder "$where"
  [ -z "${in_locale:-}" ] || speaking=("LOCPATH=$scratch/locales" LC_NUMERIC=comma LC_ALL= "TRIBUNAL_PRELOAD=$(preloaded "$scratch/speak.so")")
  env "${speaking[@]}" python3 "$SOURCE_DIR/tests/determinism/hash.py" "${options[@]}" "$program" "$where" >"$scratch/$name.hashes"
}

# same ONE OTHER: each hash of the second is that of the same command in the first; else says which are not.
same() {
  local differing
  differing=$({ grep -vxFf "$scratch/$1.hashes" "$scratch/$2.hashes" || true; } | sed 's/^[0-9a-f]* //' | paste -sd' ')
  [ -s "$scratch/$2.hashes" ] && [ -z "$differing" ] && return 0
  echo "$1 and $2 differ: $differing" >&2
  return 1
}
