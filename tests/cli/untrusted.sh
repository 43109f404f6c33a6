#!/usr/bin/env bash
# Untrusted text (control characters, line feeds, directions, bytes that are no UTF-8, markup, 10 kB) through each field
# that a command reads: no byte that steers a terminal, errors of one line, no markup in Markdown and HTML. untrusted.py
# has the fields.
source "$(dirname "$0")/common.bash"
cd "$scratch"
ulimit -c 0

${CXX:-c++} -std=c++17 -O1 -shared -fPIC -I "$SOURCE_DIR" -DFAULT=throws_markup -o markup.so "$SOURCE_DIR/tests/plugin/faulty.cpp"
expect 1 fuzz --method mt-float --count 2000 --keep 1 --out fuzzed
expect 0 sweep --method mt-float --axis sliver --count 200 --out swept
# A record without a key: an error while a line of the page is made, which ended in a destructor of another type.
mkdir cut && sed 's/"easiest"/"x"/' swept/sweep.json >cut/sweep.json
expect 3 report cut --out page.html && says err 'cut/sweep.json: axes[0]: missing "easiest"' && [ "$(wc -l <err)" -eq 1 ]

# Whole files on standard output too: the same JSON, with escapes.
printf '{"id":"x\xc2\x9b\x7f\xe2\x80\xae","seg":[[0.25,0.25,1],[0.25,0.25,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}\n' >steers.jsonl
expect 0 classify --method sf-double --in steers.jsonl && says out '"id":"x\u009b\u007f\u202e"'
cp out steers-answers.jsonl && expect 0 judge --cases steers.jsonl --answers steers-answers.jsonl

# A byte-order mark at the start of a file is no part of it, for every reader; elsewhere in it, it is an error.
mark=$(printf '\xef\xbb\xbf')
# marked FILE: the file again, with a mark before it.
marked() { { printf %s "$mark"; cat "$1"; } >"marked-$1"; }
echo '{"id":"a","seg":[[0.25,0.25,1],[0.25,0.25,-1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]}' >case.jsonl && marked case.jsonl
echo '{"id":"a","hit":1}' >answer.jsonl && marked answer.jsonl
expect 0 judge --cases marked-case.jsonl --answers marked-answer.jsonl
cat case.jsonl marked-case.jsonl >both.jsonl
expect 3 classify --method sf-double --in both.jsonl && says err 'both.jsonl:2: a byte-order mark, expected none but at the start of the file'
echo '{"camera":{"eye":[0,0,5],"look_at":[0,0,0],"up":[0,1,0],"fov":40,"width":4,"height":4},"solids":[{"solid":"marked-solid.json"}]}' >scene.json
echo '{"vertices":[[0,0,0],[1,0,0],[0,1,0]],"faces":[[0,1,2]]}' >solid.json && marked solid.json && marked scene.json
expect 0 render marked-scene.json --method sf-double -o x.png
printf 'OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n' >x.off
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >x.obj
printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >x.ply
printf 'solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n' >x.stl
for mesh in x.off x.obj x.ply x.stl; do
  marked $mesh
  expect 0 render $mesh --method sf-double --size 8x8 -o plain.png
  expect 0 render marked-$mesh --method sf-double --size 8x8 -o marked.png && cmp plain.png marked.png
done
# A log is as the program wrote it, so it has none.
expect 0 judge --cases case.jsonl --answers answer.jsonl --out judged
{ printf %s "$mark"; cat judged/log.jsonl; } >log && mv log judged/log.jsonl
expect 3 verify judged && says err 'log.jsonl:1: not a line as it was written'

/usr/bin/python3 "$SOURCE_DIR/tests/cli/untrusted.py" "${EVERY:-61}" "$TRIBUNAL" ./markup.so fuzzed swept
