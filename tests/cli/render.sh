#!/usr/bin/env bash
# render from end to end: a real mesh, two methods, the pixels that differ, and replay of the cases behind them.
source "$(dirname "$0")/common.bash"
cd "$SOURCE_DIR"

expect 0 render data/scenes/elephant.json --method mt-float --against sf-rational -o "$scratch/a.png" --stats "$scratch/a.json" --threads 2
[ -s "$scratch/a.png" ]
[ -s "$scratch/a.against.png" ]
[ -s "$scratch/a.diff.png" ]
[ -s "$scratch/a.cases.jsonl" ]
grep -q '"triangle_tests"' "$scratch/a.json"
says out '2 solids, ' && says out ': 1 of 2 solids'
expect 1 replay "$scratch/a.cases.jsonl"
differing=$(wc -l <"$scratch/a.cases.jsonl")
wrong=$(grep -c '^  mt-float .*WRONG' "$scratch/out")
[ "$differing" -gt 50 ] && [ "$wrong" -eq "$differing" ] || { echo "$differing cases exported, mt-float wrong on $wrong" >&2; exit 1; }
! grep -q '^  sf-rational .*WRONG' "$scratch/out" || { echo "sf-rational is blamed" >&2; exit 1; }

# Each differing pixel says why. Secondary rays of two inexact methods start at the same places, so no pixel differs by that;
# some differ by the order of hits alone. An exact method starts them elsewhere.
expect 0 render data/scenes/elephant.json --method mt-float --against badouel-float -o "$scratch/parting.png"
says parting.diff.json '"why": "order"' && says parting.diff.json '"why": "face"' && lacks parting.diff.json '"why": "start"'
says a.diff.json '"why": "start"' && lacks a.diff.json '"wrong": []'
[ "$(grep -c '"why": "face"' "$scratch/a.diff.json")" -eq "$(wc -l <"$scratch/a.cases.jsonl")" ]

# Every exact method draws the same bytes, by any acceleration and number of threads.
for options in 'sf-rational --accel bvh --threads 1' 'sf-epick --accel boxes --threads 2' 'sf-epeck --accel bvh --threads 7'; do
  # shellcheck disable=SC2086  # the words are options
  expect 0 render data/scenes/cube-grid.json --method $options -o "$scratch/exact.png"
  sha256sum <"$scratch/exact.png"
done | sort -u >"$scratch/hashes"
[ "$(wc -l <"$scratch/hashes")" -eq 1 ] || { echo "exact methods draw different pictures" >&2; exit 1; }

/usr/bin/python3 docs/check_counterexample.py "$scratch/a.cases.jsonl"
expect 2 render data/scenes/cube-grid.json --method cgal-epick -o "$scratch/b.png"

# Each output is a file of its own, however its name is written; an option that derives names counts with all of them.
ln -s . "$scratch/link"
# clash FIRST SECOND ARG…: the options of those names would both write one file; nothing is written.
clash() {
  expect 2 render data/scenes/paper-2a.json --method sf-double -o "$scratch/b.png" "${@:3}"
  says err "$1 and $2 would both write" && [ "$(wc -l <"$scratch/err")" -eq 1 ] && [ -z "$(ls "$scratch" | grep '^b\.')" ]
}
clash -o --stats --stats "$scratch/b.png"
clash -o --export-pov --export-pov "$scratch/./b.png"
clash -o --export-pov --export-pov "$scratch/link/b.png"
clash --heat --stats --heat --stats "$scratch/link/../$(basename "$scratch")/b.tests.png"
clash --heat --export-pov --heat --export-pov "$scratch/b.stages.png"
clash --against --stats --against sf-float --stats "$scratch/b.diff.png"
clash --against --export-pov --against sf-float --export-pov "$scratch/b.cases.jsonl"
clash --export-pov --stats --export-pov "$scratch/b.pov" --stats "$scratch/b.ids.png"
clash --export-pov --stats --export-pov "$scratch/b.pov" --stats "$scratch/b.pov"
(cd "$scratch" && expect 2 render "$SOURCE_DIR/data/scenes/paper-2a.json" --method sf-double -o b.png --stats ./b.png && says err './b.png')
expect 0 render data/scenes/paper-2a.json --method sf-double --against sf-float --heat -o "$scratch/b.png" --export-pov "$scratch/b.pov" --stats "$scratch/b.json"
for file in b.png b.tests.png b.stages.png b.against.png b.diff.png b.diff.json b.cases.jsonl b.pov b.ids.png b.json; do says out "/$file" && [ -e "$scratch/$file" ]; done
rm "$scratch"/b.*
echo '{"camera":{"eye":[0,0,9],"look_at":[0,0,0],"up":[0,1,0],"fov":40,"width":9,"height":9},"solids":[{"solid":"'"$SOURCE_DIR"'/data/solids/gear.json"}]}' >"$scratch/gear.json"
expect 0 render "$scratch/gear.json" --method sf-double -o "$scratch/gear.png" && says out ', 1 solid, ' && says out ': 1 of 1 solid'


# A mesh needs no scene: it is framed. A tolerance with a dimension loses all of a small one.
expect 0 render data/meshes/3torus.off --method mt-eps-double --against sf-filtered --scale 1e-6 --size 80x60 -o "$scratch/torus.png"
says out ': 80 x 60 pixels, 1 solid, ' && says out ': 754 of 4800 pixels differ in colour'
expect 0 render data/meshes/3torus.off --method mt-double --against sf-filtered --scale 1e-6 --size 80x60 --camera 0,1e-5,0 -o "$scratch/torus.png"
says out ': 0 of 4800 pixels differ in colour'
expect 0 render data/scenes/paper-2a.json --method sf-double --size 40x30 --camera 3,4,5 -o "$scratch/small.png" && says out ': 40 x 30 pixels'
for options in '--size 4x' '--size 16385x1' '--size 16384x16384' '--camera 1,2' '--camera 0,nan,1' '--scale 0' '--up w'; do
  # shellcheck disable=SC2086  # the words are options
  expect 2 render data/meshes/3torus.off --method sf-double -o "$scratch/refused.png" $options && [ "$(wc -l <"$scratch/err")" -eq 1 ]
done
expect 2 render data/scenes/paper-2a.json --method sf-double --scale 2 -o "$scratch/refused.png" && says err 'are for a mesh'
[ ! -e "$scratch/refused.png" ]

expect 3 render no/such/scene.json --method sf-double -o "$scratch/b.png"
[ ! -e "$scratch/b.png" ]
expect 2 render data/scenes/cube-grid.json --method sf-double --accel octree -o "$scratch/b.png"
expect 5 render data/scenes/cube-grid.json --method sf-double -o /dev/full
expect 2 render data/scenes/cube-grid.json --method sf-double -o /dev/full --heat && says err 'ends in .png'

# What cannot be written is said before the work; polygon tests draw scenes without triangles.
for name in b.jpg b -; do expect 2 render data/scenes/cube-grid.json --method sf-double -o "$scratch/$name" && says err 'ends in .png'; done
expect 5 render data/scenes/cube-grid.json --method sf-double -o "$scratch/c.png" --stats "$scratch/none/c.json"
[ ! -e "$scratch/c.png" ]
expect 2 render data/scenes/paper-2a.json --method haines-double -o "$scratch/b.png" && says err 'takes no triangles, and the scene has 14'
expect 0 render data/scenes/paper-2e.json --method haines-double -o "$scratch/b.png"
