#!/usr/bin/env bash
# Plugins that fail, each alone in our process and isolated: crash, exit, exception, loop, nonsense, chatter, answers that
# change. Whatever is wrong with the plugins of tests/plugin/faulty.cpp is a fault, so counts are counts of faults.
source "$(dirname "$0")/common.bash"
cd "$scratch"
ulimit -c 0
export ASAN_OPTIONS=handle_segv=0:handle_abort=0

# faulty NAME FLAG…: NAME.so
faulty() {
  local name=$1
  shift
  ${CXX:-c++} -std=c++17 -O1 -shared -fPIC -I "$SOURCE_DIR" "$@" -o "$name.so" "$SOURCE_DIR/tests/plugin/faulty.cpp"
}
hunt=(fuzz --method faulty --family affine --seed 2 --count 400)
polygon_hunt=(fuzz --method faulty --family polygon-grid --seed 2 --count 120)

# wrong: how many answers the last fuzz calls wrong, in all.
wrong() { awk '$1 == "faulty" { sum += $5 } END { print sum + 0 }' out; }

# ends CODE TEXT COMMAND…: without --isolate the first fault ends the command with this code and one line that says so.
ends() {
  local code=$1 text=$2
  shift 2
  expect "$code" "$@" && says err "$text" && [ "$(wc -l <err)" -eq 1 ] && lacks out 'cases, seed'
}

# goes_on FAULT DETAIL NAME FLAG…: isolated, the fault is found on every case that has it, of triangles and of polygons; all
# cases are asked, by any number of threads to the same end, and replay, classify, judge and the certificate say what fuzz said.
goes_on() {
  local fault=$1 detail=$2 name=$3
  local isolate=(--plugin "$name.so" --isolate "${@:4}")
  expect 1 "${hunt[@]}" "${isolate[@]}" --keep 1 --threads 2 --out found
  says out "FAULT: faulty $fault, in" && says out '400 cases, seed 2' && [ ! -s err ]
  [ "$(wrong)" -eq "$due" ] || { echo "$name: $(wrong) wrong, expected $due" >&2; exit 1; }
  says found/summary.json "\"fault\": \"$fault\"" && lacks found/counterexamples.jsonl '"answered"'
  says found/counterexamples.jsonl "\"fault\":\"$fault\"" && says found/counterexamples.jsonl "$detail"
  expect 1 "${hunt[@]}" "${isolate[@]}" --keep 1 --out again --threads 1 && diff -r found again
  head -n 1 found/counterexamples.jsonl >first.jsonl
  expect 1 replay "${isolate[@]}" first.jsonl && says out "WRONG: $fault" && says out "$detail"
  expect 1 classify "${isolate[@]}" --method faulty --in first.jsonl && says out "\"status\":\"failed\""
  says out "\"fault\":\"$fault\"" && cp out answers.jsonl
  expect 1 judge --cases first.jsonl --answers answers.jsonl --out judged && says out "FAULT    $fault, in 1 of"
  says judged/certificate.md "- $fault, in 1 of" && says judged/certificate.json "\"$fault\": 1"
  expect 0 verify judged
  rm -r found again judged
  expect 1 "${polygon_hunt[@]}" "${isolate[@]}" --keep 1 --threads 2 --out found
  says out "FAULT: faulty $fault, in" && says out '120 cases, seed 2' && says found/counterexamples.jsonl "$detail"
  rm -r found
}

# Of 400 cases, how many are marked.
faulty seven -DFAULT=answers_seven
ends 3 'seven.so: answered 7, expected' "${hunt[@]}" --plugin seven.so
expect 1 "${hunt[@]}" --plugin seven.so --isolate && due=$(wrong)
[ "$due" -ge 4 ] && [ "$due" -le 30 ] || { echo "$due cases are marked" >&2; exit 1; }
goes_on 'gave no answer' 7 seven

faulty crash -DFAULT=crash
expect 139 "${hunt[@]}" --plugin crash.so
goes_on crashed SIGSEGV crash

faulty crash_in_batch -DFAULT=aborts -DBATCH=ask_batch
expect 134 "${hunt[@]}" --plugin crash_in_batch.so
goes_on crashed SIGABRT crash_in_batch

faulty throws -DFAULT=throws
ends 1 'throws.so: threw no memory left, on {' "${hunt[@]}" --plugin throws.so && says err '"tri"'
ends 1 'throws.so: threw no memory left, on {' "${polygon_hunt[@]}" --plugin throws.so && says err '"rings"'
goes_on threw 'no memory left' throws

faulty throws_in_batch -DFAULT=throws_number -DBATCH=ask_batch
ends 1 'throws_in_batch.so: threw an exception of its own, on {' "${hunt[@]}" --plugin throws_in_batch.so && says err '"tri"'
goes_on threw 'an exception of its own' throws_in_batch

faulty exits -DFAULT=exits
ends 1 'a plugin ended the program' "${hunt[@]}" --plugin exits.so
ends 1 'a plugin ended the program' "${polygon_hunt[@]}" --plugin exits.so
goes_on exited 'status 0' exits

faulty rounds -DFAULT=rounds_up
ends 4 'rounds.so: changed the rounding mode' "${hunt[@]}" --plugin rounds.so
goes_on 'changed the floating-point environment' fault rounds

faulty loops -DFAULT=loops
timeout -k 1 2 "$TRIBUNAL" "${hunt[@]}" --plugin loops.so >out 2>err && { echo 'the loop ended' >&2; exit 1; }
goes_on 'timed out' 'after 0.2 s' loops --time-limit 0.2

# Chatter on standard output is ours no more; bytes on our own socket are a fault, where one was meant to be answered.
faulty prints -DFAULT=prints
expect 2 "${hunt[@]}" --plugin prints.so && says out garbage && says err "nothing was judged"  # it refuses everything
expect 2 "${hunt[@]}" --plugin prints.so --isolate && lacks out garbage && says err garbage && says out '400 cases, seed 2'
faulty writes -DFAULT=writes_everywhere
goes_on 'gave no answer' 'wrote to our socket' writes

# Answers that change: the same with and without isolation, but for which they are.
for batch in nullptr ask_batch; do
  faulty unsteady -DFAULT=is_unsteady -DEVERY=1 -DBASE=TRIBUNAL_MISS -DBATCH=$batch
  for way in '' --isolate; do
    expect 1 "${hunt[@]}" --plugin unsteady.so $way --threads 1 --out found && says out 'FAULT: faulty answers'
    says found/summary.json '"fault": "answers' && says out '400 cases, seed 2'
    rm -r found
  done
done

# A batch function that fails for what no case of it does alone.
faulty company -DFAULT=none -DBATCH=crashes_in_company
expect 134 "${hunt[@]}" --plugin company.so
expect 1 "${hunt[@]}" --plugin company.so --isolate --keep 1 --out found && says out 'FAULT: faulty crashed'
says found/counterexamples.jsonl 'once, not when asked again' && rm -r found

# A plugin that answers is answered for in the same bytes, isolated or not.
example=$SOURCE_DIR/docs/examples/moeller_trumbore.c
for flag in -DSOUND -DPLANTED_MISTAKE; do
  plugin mine "$flag" "$example"
  for way in '' --isolate; do
    "$TRIBUNAL" fuzz --plugin mine.so $way --method my-mt --family grazing,sliver --count 20000 --out "found$way" >/dev/null || [ $? -eq 1 ]
  done
  diff -r found found--isolate
  rm -r found found--isolate
done

# What cannot be loaded is refused as ever; what dies as it is loaded, in one line.
expect 3 methods --plugin missing.so --isolate && says err 'missing.so: cannot read: No such file'
faulty on_load -DFAULT=none -DCRASHES_ON_LOAD
expect 3 methods --plugin on_load.so --isolate && says err 'on_load.so: crashed (SIGABRT) as it was loaded'
expect 2 fuzz --method sf-double --isolate && says err '--plugin'

# Children that come after the first must introduce the library as it did: one thread has a child that crashes, and the next
# one promises something else.
faulty changes -DFAULT=crash -DCHANGES=culling
expect 3 "${hunt[@]}" --plugin changes.so --isolate --threads 2
says err 'changes.so: describes itself in another way each time it is loaded' && [ "$(wc -l <err)" -eq 1 ]
expect 2 fuzz --plugin seven.so --method faulty --time-limit 1 && says err '--isolate'
expect 2 fuzz --plugin seven.so --method faulty --isolate --time-limit 0

# No child outlives the program.
sleep 0.2
for process in /proc/[0-9]*; do
  [ "$(readlink "$process/cwd" || true)" != "$scratch" ] || [ "$(cat "$process/comm")" != tribunal ] || { echo "$process is left" >&2; exit 1; }
done
