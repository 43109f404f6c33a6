#!/usr/bin/env bash
# Rounding, flush-to-zero, the precision of x87, exceptions that trap, and locales, forced from outside before main, in every new
# thread, and while the program works: it repairs them or refuses (exit 4), and never answers otherwise than in the default
# environment. tests/soak/environment.sh tries more moments.
source "$(dirname "$0")/common.bash"
attempt() { python3 -B "$SOURCE_DIR/tests/faults/environment.py" --program "$TRIBUNAL" --source "$SOURCE_DIR" --scratch "$scratch" "$@"; }

attempt --commands classify,fuzz-threads,render-threads,verify --when start,threads
attempt --commands version,help,methods,cases,judge,check,shrink,replay,leak,sweep-map,report --changes x87-53,all,traps,c++locale --when start
attempt --commands fuzz,render --changes up,daz,x87-24,traps,c++locale --when malloc --most "${MOST:-8}"
attempt --commands fuzz --changes up,ftz,x87-24 --when timer --most 24

# A plugin that changes them: refused, or repaired where nothing was computed yet.
cd "$scratch"
localedef -i de_DE -f UTF-8 "$scratch/de_DE.UTF-8"
export LOCPATH=$scratch
broken=$SOURCE_DIR/tests/plugin/broken.c
try() { plugin broken "-D$1" "$broken"; shift; expect "$@" --plugin broken.so --method broken,mt-double --family affine --count 2000 --threads 2; }
try PLAIN 1 fuzz && cp out plain
try CHANGES_LOCALE 1 fuzz && diff plain out
try WANTS_MEMORY 1 fuzz && diff plain out
for change in CHANGES_PRECISION UNMASKS; do try $change 4 fuzz && says err 'broken.so: changed the rounding mode, precision or exceptions' && [ "$(wc -l <err)" -eq 1 ]; done
try TRAPS 4 fuzz && says err 'exceptions trap' && [ "$(wc -l <err)" -eq 1 ]
