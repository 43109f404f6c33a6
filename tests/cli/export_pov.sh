#!/usr/bin/env bash
# render --export-pov: the scene for POV-Ray, and, where POV-Ray is installed, the solids that it shows.
source "$(dirname "$0")/common.bash"
cd "$SOURCE_DIR"

for scene in paper-2a mirror-and-prism; do
  expect 0 render "data/scenes/$scene.json" --method sf-filtered --depth 1 -o "$scratch/a.png" --export-pov "$scratch/$scene.pov"
  [ -s "$scratch/$scene.ids.png" ]
  for word in 'camera { perspective' 'light_source {' 'mesh {' 'triangle {'; do
    grep -qF "$word" "$scratch/$scene.pov" || { echo "$scene.pov lacks $word" >&2; exit 1; }
  done
  if command -v povray >/dev/null; then
    /usr/bin/python3 docs/compare_silhouettes.py "$scratch/$scene.pov"
  else
    echo "POV-Ray is not installed: $scene.pov was not drawn"
  fi
done
expect 2 render data/scenes/paper-2a.json --method sf-filtered -o "$scratch/a.png" --export-pov data/scenes/paper-2a.json

# Heat maps lie beside the picture.
expect 0 render data/scenes/paper-2a.json --method sf-filtered --depth 1 -o "$scratch/h.png" --heat
[ -s "$scratch/h.tests.png" ]
[ -s "$scratch/h.stages.png" ]
says out 'heat maps: white is'

# compare_lacks TEXT ARG…: the comparison fails, and says in one line what it lacks.
compare_lacks() {
  ! /usr/bin/python3 docs/compare_silhouettes.py "${@:2}" >"$scratch/out" 2>"$scratch/err" || { echo "compared with nothing" >&2; exit 1; }
  says err "$1" && [ "$(wc -l <"$scratch/err")" -eq 1 ]
}
compare_lacks "$scratch/none.ids.png: cannot read" "$scratch/none.pov"
compare_lacks "no-povray: cannot run: No such file" "$scratch/paper-2a.pov" no-povray
compare_lacks "false failed on " "$scratch/paper-2a.pov" false
mkdir "$scratch/bare" && echo 'raise ImportError' >"$scratch/bare/matplotlib.py"
PYTHONPATH=$scratch/bare compare_lacks 'no module matplotlib' "$scratch/paper-2a.pov"
