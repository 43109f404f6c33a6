#!/usr/bin/env bash
# The test of definitions passes a sound tree and rejects each planted breach.
set -euo pipefail
check=$SOURCE_DIR/tests/repository/one_definition.sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

sound_tree() {
  rm -rf "$scratch/tree"
  mkdir -p "$scratch"/tree/{core,exact,tracer}
  cd "$scratch/tree"
  printf 'namespace tribunal {\n\nstruct Line {\n};\nclass Ahead;\n\n}  // namespace tribunal\n' >core/a.h
  printf 'namespace tribunal::leak {\n\nstruct Line {\n};\n\n}  // namespace tribunal::leak\n' >exact/a.h
  printf 'namespace tribunal {\nnamespace {\n\nstruct Line {\n};\n\n}  // namespace\n}  // namespace tribunal\n' >tracer/a.cpp
  printf 'class Ahead;\n' >tracer/b.h
}

rejects() {  # FILE LINE: a sound tree with this definition in namespace tribunal in a file of its own
  sound_tree
  printf 'namespace tribunal {\n\n%s\n};\n\n}  // namespace tribunal\n' "$2" >"$1"
  if bash "$check" . 2>"$scratch/report"; then
    echo "not rejected: $2 in $1" >&2
    exit 1
  fi
  grep -qF "$1:3" "$scratch/report" || { echo "rejected for another reason: $2 in $1" >&2; exit 1; }
}

sound_tree
bash "$check" .
rejects exact/b.h 'struct Line {'
rejects exact/b.cpp 'class Line {'
rejects tracer/b.cpp 'class Line : public Base {'
rejects tracer/b.cpp 'enum class Line : int {'
echo "every planted breach was rejected"
