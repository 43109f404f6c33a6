#!/usr/bin/env bash
# The layering test passes a sound tree and rejects each planted breach.
set -euo pipefail
layering=$SOURCE_DIR/tests/repository/layering.sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

sound_tree() {
  rm -rf "$scratch/tree"
  mkdir -p "$scratch"/tree/{core,exact,tracer,tests/bench}
  cd "$scratch/tree"
  printf '#include <cmath>\n#include <glm/vec3.hpp>\n#include "core/b.h"\n' >core/a.h
  printf '#include <gmpxx.h>\n#include "core/a.h"\n#include "exact/b.h"\n' >exact/a.h
  printf '#include <CGAL/Exact_predicates.h>\n' >exact/cgal_a.cpp
  printf '#include <CGAL/AABB_tree.h>\n' >tests/bench/cgal_tree.cpp
  printf '#include "core/a.h"\n#include "exact/a.h"\n#include "tracer/b.h"\n' >tracer/a.h
  printf '#include "exact/a.h"\n' >main.cpp
}

rejects() {  # FILE LINE: a sound tree with this line added to this file
  sound_tree
  printf '%s\n' "$2" >>"$1"
  if bash "$layering" . 2>"$scratch/report"; then
    echo "not rejected: $2 in $1" >&2
    exit 1
  fi
  grep -qF "${2:-$1}" "$scratch/report" || { echo "rejected for another reason: $2 in $1" >&2; exit 1; }
}

sound_tree
bash "$layering" .
rejects core/a.h '#include "exact/a.h"'
rejects core/a.h '#include "a.h"'
rejects core/a.cpp '#include <gmpxx.h>'
rejects core/a.cpp '  #  include <nlohmann/json.hpp>'
rejects exact/a.cpp '#include "tracer/a.h"'
rejects exact/deep.h '#include <CGAL/Epick.h>'
rejects exact/other.cpp '#include <CGAL/Epick.h>'
rejects exact/cgal_b.cpp '#include <CGAL/AABB_tree.h>'
rejects tracer/a.cpp '#include <gmp.h>'
rejects tracer/a.cpp '#include "tests/help.h"'
rejects tests/a.cpp '#include "help.h"'
rejects main.cpp '#include <CGAL/Epick.h>'
rejects notes.txt ''
echo "every planted breach was rejected"
