#!/usr/bin/env bash
# Memory or threads that the system does not give: exit 7 and one line, or the right result. tests/soak/resources.sh tries every
# allocation, this a sample.
source "$(dirname "$0")/common.bash"

python3 -B "$SOURCE_DIR/tests/faults/resources.py" --program "$TRIBUNAL" --source "$SOURCE_DIR" --scratch "$scratch" \
  --most 4 --copies 1000 --commands version,help,classify,cases,judge,check,fuzz,fuzz-threads,shrink,replay,render,render-threads,leak,report,isolated

# Without one thread more, --threads 1 works.
cd "$scratch"
cc -shared -fPIC -O1 -o faults.so "$SOURCE_DIR/tests/faults/resources.c" -ldl
scene=$SOURCE_DIR/data/scenes/mirror-and-prism.json
no_threads() { LD_PRELOAD=$scratch/faults.so FAULT_WHAT=threads FAULT_ON=after FAULT_AT=1 "$TRIBUNAL" render "$scene" --threads "$1" --method sf-filtered -o image.png >out 2>err; }
no_threads 1
status=0
no_threads 2 || status=$?
[ "$status" -eq 7 ] && says err 'tribunal: cannot start a thread' && [ "$(wc -l <err)" -eq 1 ]

# Less and less address space, as `ulimit -v` gives it. Below some limit the system's loader finds none for the libraries.
limits=0
for limit in $(seq 400 -25 25); do
  status=0
  (
    ulimit -v $((limit * 1024))
    "$TRIBUNAL" classify --method sf-filtered,sf-epeck,sf-rational --in "$SOURCE_DIR/data/cases/classes163.jsonl" >answers 2>err
  ) || status=$?
  if [ "$status" -eq 127 ] || grep -q 'error while loading shared libraries' err; then break; fi
  limits=$((limits + 1))
  [ "$status" -eq 0 ] || [ "$status" -eq 7 ] || { echo "$limit MiB: exit $status" >&2; cat err >&2; exit 1; }
  [ "$status" -eq 0 ] || [ "$(wc -l <err)" -eq 1 ] || { echo "$limit MiB: not one line" >&2; cat err >&2; exit 1; }
done
[ "$limits" -gt 3 ] || { echo "the program never ran under a limit" >&2; exit 1; }
