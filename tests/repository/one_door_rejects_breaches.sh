#!/usr/bin/env bash
# The test of the one door passes a sound tree and rejects each planted breach.
set -euo pipefail
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
mkdir -p "$scratch"/{core,exact/base,exact/cli,tracer}
cd "$scratch"
touch main.cpp
printf 'int f = ::open(path, O_WRONLY); renameat(a, b, c, d); fs::remove_all(p);\n' >exact/base/output.cpp
printf 'std::fopen(path.c_str(), "rb"); fs::status(p);\n' >exact/base/files.cpp
printf '// fopen(x)\nstd::filesystem::path(file).filename();\nOutputFile& f = set.open(path);\nx.remove(y);\n' >exact/cli/sound.cpp
bash "$SOURCE_DIR/tests/repository/one_door.sh" .

rejects() {
  printf '%s\n' "$1" >tracer/breach.cpp
  if bash "$SOURCE_DIR/tests/repository/one_door.sh" . 2>report; then
    echo "not rejected: $1" >&2
    exit 1
  fi
  grep -qF 'tracer/breach.cpp:1:' report
}

rejects 'std::ofstream out(path);'
rejects '#include <fstream>'
rejects 'FILE* f = fopen(path, "w");'
rejects 'const int f = open(path.c_str(), O_CREAT);'
rejects 'const int f = ::open(path.c_str(), O_RDONLY);'
rejects 'std::rename(temporary.c_str(), path.c_str());'
rejects 'std::remove(log.c_str());'
rejects 'unlink(path.c_str());'
rejects 'std::filesystem::remove(path);'
rejects 'std::filesystem::rename(a, b);'
rejects 'if (std::filesystem::exists(path)) return;'
rejects 'for (const auto& entry : std::filesystem::directory_iterator(path)) use(entry);'
rejects 'if (fs::is_directory(path)) return;'
rejects 'std::signal(SIGINT, handler);'
rejects 'sigaction(SIGTERM, &action, nullptr);'
echo "every planted breach was rejected"
