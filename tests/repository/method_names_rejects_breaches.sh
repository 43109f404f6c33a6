#!/usr/bin/env bash
# The test of method names passes a sound tree and rejects each planted breach.
set -euo pipefail
names=$SOURCE_DIR/tests/repository/method_names.sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

sound_tree() {
  rm -rf "$scratch/tree"
  mkdir -p "$scratch"/tree/{core,exact/cli,exact/methods,tracer/cli,tests}
  cd "$scratch/tree"
  {
    echo 'const std::vector<Row> table = {'
    for name in sf-float sf-double mt-float haines-double cgal-epick; do printf '    {"%s", make},\n' "$name"; done
    echo '};'
  } >exact/methods/methods.cpp
  printf '    ShelfRow<BaldwinWeber>{"baldwin-weber"},\n' >exact/methods/shelf.h
  printf '// The test "sf-double" is naive.\nint x;  ///< e.g. "sf-double"\nauto s = "a half-open sf";\n' >core/a.h
  printf 'auto a = "sf-double";\n' >exact/cli/fuzz.cpp
  printf 'auto a = "--method mt-float";\n' >tracer/cli/demo.cpp
  printf 'auto a = find_method("sf-double");\n' >tests/a.cpp
  printf 'auto r = "msf-double";\nauto q = "sf-doubles";\n' >tracer/a.cpp
}

rejects() {  # FILE LINE: a sound tree with this line added to this file
  sound_tree
  printf '%s\n' "$2" >>"$1"
  if bash "$names" . 2>"$scratch/report"; then
    echo "not rejected: $2 in $1" >&2
    exit 1
  fi
  grep -qF "$2" "$scratch/report" || { echo "rejected for another reason: $2 in $1" >&2; exit 1; }
}

sound_tree
bash "$names" .
rejects tracer/a.cpp 'if (method.name == "sf-double") sift();'
rejects tracer/a.h 'constexpr std::string_view sifted_method = "sf-float";'
rejects exact/a.cpp 'static const Method& cgal = *find_method("cgal-epick");'
rejects exact/a.cpp 'static const Method& other = *find_method("a plugin");'
rejects exact/a.cpp 'for (const char* name : {"sf-float", "x"}) {'
rejects core/a.cpp 'return "the exact test, <code>mt-float</code>, took";'
rejects tracer/a.cpp 'if (m.name.starts_with("mt-")) draw();'
rejects tracer/a.cpp 'text = "see haines-double";'
rejects exact/a.cpp 'if (method.name == "baldwin-weber-float") slow();'
rejects exact/a.cpp 'if (m.name.starts_with("baldwin-weber-")) slow();'
sound_tree
: >exact/methods/methods.cpp
: >exact/methods/shelf.h
if bash "$names" . 2>/dev/null; then
  echo "a table without rows was accepted" >&2
  exit 1
fi
echo "every planted breach was rejected"
