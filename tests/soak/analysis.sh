#!/usr/bin/env bash
# clang-tidy (clang-tidy.yaml) over core, exact, tracer and main.cpp, and cppcheck over the same: no finding. analysis.sh [REGEX]:
# only the files whose path matches.
set -euo pipefail
only=${1:-.}
configured=$SCRATCH/analysis
cmake -S "$SOURCE_DIR" -B "$configured" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Release -DTRIBUNAL_TESTS=OFF \
  -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >/dev/null
tried=0 broke=0

# sources: the files compiled, those with CGAL last, since each takes a minute.
sources() {
  python3 - "$configured/compile_commands.json" "$SOURCE_DIR" "$only" <<'PYTHON'
import json, pathlib, re, sys
commands, root, only = sys.argv[1:]
files = {pathlib.Path(c["file"]).resolve() for c in json.load(open(commands))}
ours = sorted((f for f in files if f.is_relative_to(pathlib.Path(root).resolve()) and "/embedded/" not in str(f)),
              key=lambda f: (f.name.startswith("cgal_"), str(f)))
print(*(f for f in ours if re.search(only, str(f))), sep="\n")
PYTHON
}

mapfile -t files < <(sources)
[ "${#files[@]}" -gt 0 ] || { echo "analysis: no file matches" >&2; exit 1; }
for file in "${files[@]}"; do
  tried=$((tried + 1))
  echo "clang-tidy ${file#"$SOURCE_DIR"/}"
  clang-tidy -p "$configured" --config-file="$SOURCE_DIR/tests/soak/clang-tidy.yaml" --quiet "$file" 2>"$SCRATCH/clang-tidy.err" || {
    grep -E 'error:' "$SCRATCH/clang-tidy.err" || true
    broke=$((broke + 1))
  }
done

echo "cppcheck"
tried=$((tried + 1))
grep -vE '^#|^$' "$SOURCE_DIR/tests/soak/cppcheck-suppressions.txt" >"$SCRATCH/suppressions"
cppcheck --project="$configured/compile_commands.json" --enable=warning,performance,portability --inline-suppr \
  --suppressions-list="$SCRATCH/suppressions" --error-exitcode=1 --quiet -j "$(nproc)" \
  "${files[@]/#/--file-filter=}" || broke=$((broke + 1))
echo "tried $tried, broke $broke: files under clang-tidy, and cppcheck over these"
[ "$broke" -eq 0 ]
