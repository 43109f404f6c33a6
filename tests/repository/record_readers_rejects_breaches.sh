#!/usr/bin/env bash
# The test of record readers passes a sound tree and rejects each planted breach.
set -euo pipefail
readers=$SOURCE_DIR/tests/repository/record_readers.sh
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

sound_tree() {
  rm -rf "$scratch/tree"
  mkdir -p "$scratch"/tree/{core,exact/base,exact/report,tracer}
  cd "$scratch/tree"
  : >main.cpp
  echo 'return value.get<double>();' >exact/base/record.cpp
  echo 'return Json::parse(text);' >exact/base/json.cpp
  printf 'auto a = r.text("name");\nauto b = row["n"];\nauto c = limit.value();\n// json.get<int>() throws\n' >exact/report/a.cpp
}

rejects() {  # FILE LINE: a sound tree with this line added to this file
  sound_tree
  printf '%s\n' "$2" >>"$1"
  if bash "$readers" . 2>"$scratch/report"; then
    echo "not rejected: $2 in $1" >&2
    exit 1
  fi
  grep -qF "$2" "$scratch/report" || { echo "rejected for another reason: $2 in $1" >&2; exit 1; }
}

sound_tree
bash "$readers" .
rejects exact/report/a.cpp 'const auto n = row["n"].get<std::uint64_t>();'
rejects exact/report/a.cpp 'const auto n = row.at("n");'
rejects exact/report/b.h 'const auto n = row.value("n", 0);'
rejects tracer/a.cpp 'row["n"].get_to(n);'
rejects tracer/a.cpp 'const std::string& s = value.get_ref<const std::string&>();'
rejects exact/report/a.cpp 'const std::string name = row["name"];'
rejects core/a.h 'auto j = Json::parse(text);'
echo "every planted breach was rejected"
