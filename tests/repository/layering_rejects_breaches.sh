#!/usr/bin/env bash
# The layering test passes a sound tree and rejects each planted breach.
set -euo pipefail
layering=$SOURCE_DIR/tests/repository/layering.sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

sound_tree() {
  rm -rf "$scratch/tree"
  mkdir -p "$scratch"/tree/{core,exact/base,exact,tracer/image,tracer,tests/bench,docs}
  cd "$scratch/tree"
  printf '| room | what |\n|---|---|\n| `core/` | |\n| `exact/base/` | |\n| `exact/` | |\n| `tracer/image/` | |\n| `tracer/` | |\n' \
    >docs/architecture.md
  printf '#include "core/a.h"\n' >exact/base/a.h
  printf '#include "exact/base/a.h"\n' >tracer/image/a.h
  printf '#include <cmath>\n#include <glm/vec3.hpp>\n#include "core/b.h"\n' >core/a.h
  printf '#include <gmpxx.h>\n#include "core/a.h"\n#include "exact/b.h"\n' >exact/a.h
  printf '#include <CGAL/Exact_predicates.h>\n' >exact/cgal_a.cpp
  printf '#include <CGAL/AABB_tree.h>\n' >tests/bench/cgal_tree.cpp
  printf '#include "core/a.h"\n#include "exact/a.h"\n#include "tracer/b.h"\n' >tracer/a.h
  printf '#include "exact/a.h"\n' >main.cpp
}

rejected() {  # WHAT TEXT: the tree as it stands is rejected, with this text
  if bash "$layering" . 2>"$scratch/report"; then
    echo "not rejected: $1" >&2
    exit 1
  fi
  grep -qF "$2" "$scratch/report" || { echo "rejected for another reason: $1" >&2; cat "$scratch/report" >&2; exit 1; }
}

rejects() {  # FILE LINE: a sound tree with this line added to this file
  sound_tree
  printf '%s\n' "$2" >>"$1"
  rejected "$2 in $1" "${2:-$1}"
}

sound_tree
bash "$layering" .
rejects core/a.h '#include "exact/a.h"'
rejects core/a.h '#include "a.h"'
rejects core/a.cpp '#include <gmpxx.h>'
rejects core/a.cpp '  #  include <nlohmann/json.hpp>'
rejects exact/a.cpp '#include "tracer/a.h"'
rejects exact/base/a.cpp '#include "exact/a.h"'
rejects tracer/image/a.h '#include "tracer/a.h"'
rejects tracer/a.h '#include "exact/elsewhere/a.h"'
rejects exact/deep.h '#include <CGAL/Epick.h>'
rejects exact/other.cpp '#include <CGAL/Epick.h>'
rejects exact/cgal_b.cpp '#include <CGAL/AABB_tree.h>'
rejects tracer/a.cpp '#include <gmp.h>'
rejects tracer/a.cpp '#include "tests/help.h"'
rejects tests/a.cpp '#include "help.h"'
rejects main.cpp '#include <CGAL/Epick.h>'
rejects notes.txt ''

sound_tree
mkdir exact/attic
printf '#include "core/a.h"\n' >exact/attic/a.h
rejected "a folder without a row" 'exact/attic'

sound_tree
printf '| `exact/ghost/` | |\n' >>docs/architecture.md
rejected "a row without sources" 'exact/ghost'

sound_tree
printf '| `core/` | |\n' >>docs/architecture.md
rejected "a room listed twice" 'two rows of one room'

sound_tree
: >docs/architecture.md
rejected "no table" 'no table of rooms'
echo "every planted breach was rejected"
