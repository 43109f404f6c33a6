#!/usr/bin/env bash
# Rounding, flush-to-zero, the precision of x87, exceptions that trap, and locales, forced from outside before main, in every new
# thread, and while the program works: it repairs them or refuses (exit 4), and never answers otherwise than in the default
# environment. tests/soak/environment.sh tries more moments.
source "$(dirname "$0")/common.bash"
attempt() { python3 -B "$SOURCE_DIR/tests/faults/environment.py" --program "$TRIBUNAL" --source "$SOURCE_DIR" --scratch "$scratch" "$@"; }

attempt --commands fuzz-threads,render-threads --changes ftz,up,x87-53,traps,c++locale --when start,threads
attempt --commands classify,verify --changes x87-53,all,traps --when start
attempt --commands fuzz --changes up,x87-24,traps,c++locale --when malloc --most 5
attempt --commands fuzz --changes up,x87-24 --when timer --most 18

# A plugin that changes them: refused, or repaired where nothing was computed yet.
cd "$scratch"
localedef -i de_DE -f UTF-8 "$scratch/de_DE.UTF-8"
export LOCPATH=$scratch
broken=$SOURCE_DIR/tests/plugin/broken.c
try() { plugin broken "-D$1" "$broken" || exit 1; shift; expect "$@" --plugin broken.so --method broken,mt-double --family affine --count 2000 --threads 2; }
answers() { grep -v "cases, seed" out; } # that line has the time it took
try PLAIN 1 fuzz && answers >plain
try CHANGES_LOCALE 1 fuzz && diff plain <(answers)
try WANTS_MEMORY 1 fuzz && diff plain <(answers)
for change in CHANGES_PRECISION UNMASKS; do try $change 4 fuzz && says err 'broken.so: changed the rounding mode, precision or exceptions' && [ "$(wc -l <err)" -eq 1 ]; done
try TRAPS 4 fuzz && says err 'exceptions trap' && [ "$(wc -l <err)" -eq 1 ]
