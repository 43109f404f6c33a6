#!/usr/bin/env bash
# The mesh trial from end to end: exact tests are watertight, others leak; a tree in a library is judged function by
# function, and each fault planted in tests/plugin/mesh.cpp is found in the function that has it.
source "$(dirname "$0")/common.bash"
cd "$scratch"
cat >octahedron.off <<'MESH'
OFF
6 8 0
2 0 0
-2 0 0
0 2 0
0 -2 0
0 0 2
0 0 -2
3 0 2 4
3 2 1 4
3 1 3 4
3 3 0 4
3 2 0 5
3 1 2 5
3 3 1 5
3 0 3 5
MESH
trial=(leak octahedron.off --rays 2000)

expect 0 "${trial[@]}" --method sf-filtered,sf-rational && says out 'sf-filtered, binary64 rays: watertight on these 2000 rays (closed mesh; 2000 of 2000 rays judged, 1'
for basis in ' aimed at vertices and edges, ' ' exactly through one)'; do says out "$basis"; done
# A sliver on which most starts are refused: the claim says how few were judged.
expect 1 "${trial[@]}" --method mt-eps-double,jimenez-double --threads 3 --out leaks
says out 'leaks: ' && says out 'jimenez-double takes no rays of triangles: not asked' && says leaks/mt-eps-double-binary64.ply 'property uchar red'
expect 1 "${trial[@]}" --method mt-eps-double --threads 1 --out again && diff -r leaks again
expect 1 replay leaks/cases.jsonl && says out 'mt-eps-double'
expect 1 "${trial[@]}" --methods mt-eps-double
expect 2 "${trial[@]}" --method jimenez-double && says err 'no method given that takes rays'
head -n 15 octahedron.off | sed 's/6 8 0/6 7 0/' >open.off
expect 0 leak open.off --rays 2000 --method sf-filtered --out open && says out 'it has no inside, and parity is not judged'
expect 0 report open --out page.html && cat out >told && says told 'sf-filtered: no leak on 2000 binary64 rays at open.off, whose surface is open: 3 of '
lacks told watertight
expect 0 leak open.off --rays 2000 --method sf-filtered
lacks out watertight && says out 'sf-filtered, binary64 rays: no leak on these 2000 rays (open mesh; 2000 of 2000 rays judged, '

# tree NAME FLAG…: NAME.so
tree() {
  ${CXX:-c++} -std=c++20 -O1 -ffp-contract=off -shared -fPIC -I "$SOURCE_DIR" "${@:2}" -o "$1.so" "$SOURCE_DIR/tests/plugin/mesh.cpp" -lgmpxx -lgmp
}
# found CODE TEXT FLAG: with this fault planted, the trial ends so and says this.
found() {
  tree wrong "-D$3"
  expect "$1" "${trial[@]}" --format binary64 --plugin wrong.so
  cat out err >both && says both "$2"
}
tree right
expect 0 "${trial[@]}" --format binary64 --plugin right.so
for function in closest any all; do says out "tree/$function, binary64 rays: watertight on these 2000 rays"; done
says out 'tree/inside, binary64 rays: right about inside and outside on these 2000 rays'
expect 2 fuzz --plugin right.so --method tree && says err 'unknown method "tree"'
expect 2 fuzz --plugin right.so && says err 'the plugin has a tree and no test of single triangles'
found 1 'tree/any, binary64 rays: leaks: ' LOSES_FLAT_SLABS
found 1 'tree/closest, binary64 rays: watertight on these 2000 rays; wrong closest ' EXITS_EARLY
found 1 'tree/all, binary64 rays: watertight on these 2000 rays; double hits ' LISTS_TWICE
found 1 'tree/inside, binary64 rays: wrong about inside and outside: ' COUNTS_EDGES
found 1 't beyond its promise' ROUNDS_T
found 3 'closest of a mesh said face 1000000, expected one of 8' NO_SUCH_FACE
found 1 'any of a mesh threw out of boxes' THROWS
found 3 'any of a mesh answered -1, expected 0 or 1' NO_ANSWER
for fault in TURNS_NORMALS BLUNTS_NORMALS WRONG_SIDE; do
  found 1 'tree/closest, binary64 rays: watertight on these 2000 rays; wrong normals ' $fault
  says out 'tree/all, binary64 rays: watertight on these 2000 rays'
done
tree old -DVERSION_2
expect 0 "${trial[@]}" --format binary64 --plugin old.so && lacks out normal

# isolated CODE WHAT COUNT FLAG…: of 2000 rays, so many are marked; the tree fails on each, in all its functions, and the
# run goes on.
isolated() {
  tree wrong "${@:4}"
  expect "$1" "${trial[@]}" --format binary64 --plugin wrong.so --isolate --time-limit 0.1 --out found
  for function in closest any all inside; do
    says out "tree/$function, binary64 rays: "
    says found/cases.jsonl "tree/$function-fault-binary64-" && says found/summary.json "\"$2\": $3"
  done
  [ "$(grep -cF "FAULT: $2 on $3 rays" out)" -eq 4 ] || { cat out >&2; exit 1; }
  says out 'no leak where it answered, but faults: ' && rm -r found
}
expect 0 "${trial[@]}" --format binary64 --plugin right.so --json && cp out here
expect 0 "${trial[@]}" --format binary64 --plugin right.so --json --isolate && cmp here out
tree wrong -DFAULT=throw_text && expect 1 "${trial[@]}" --format binary64 --plugin wrong.so && says err 'threw out of boxes'
expect 1 "${trial[@]}" --format binary64 --plugin wrong.so --isolate --json
marked=$(sed -n 's/.*"threw out of boxes": //p' out | sort -u)
[ "$marked" -ge 3 ] && [ "$marked" -le 20 ] || { echo "marked: $marked" >&2; exit 1; }
isolated 1 'threw out of boxes' "$marked" -DFAULT=throw_text
isolated 1 'crashed (SIGSEGV)' "$marked" -DFAULT=crash
isolated 1 'crashed (SIGABRT)' "$marked" -DFAULT=die
isolated 1 'exited (status 0)' "$marked" -DFAULT=leave
isolated 1 'timed out after 0.1 s' "$marked" -DFAULT=loop
isolated 1 'changed the floating-point environment' "$marked" -DFAULT=round_up
tree wrong -DNO_SUCH_FACE && expect 1 "${trial[@]}" --format binary64 --plugin wrong.so --isolate
says out 'tree/closest, binary64 rays: no answer to any of these 2000 rays' && says out 'said face 1000000, expected one of 8'
tree wrong -DFAULT=crash -DFAULTS_IN_PREPARE
expect 1 "${trial[@]}" --plugin wrong.so --isolate && says err 'wrong.so: prepare of a mesh crashed (SIGSEGV)' && [ "$(wc -l <err)" -eq 1 ]
