#!/usr/bin/env bash
# The page that the program carries is made of the sources beside it, is small, and asks for nothing. Needs no npm.
set -euo pipefail
cd "$SOURCE_DIR/exact/report/page"
fail() { echo "exact/report/page/$1" >&2; exit 1; }

hash_of_sources() {
  for name in build.mjs package-lock.json $(LC_ALL=C ls src | sed 's:^:src/:') style.css template.html; do
    echo "$name"
    cat "$name"
  done | sha256sum | cut -d' ' -f1
}

grep -qF "content=\"$(hash_of_sources)\"" report.html || fail "report.html is not made of src/ as it is: npm ci && npm run build"
[ "$(stat -c %s report.html)" -le 1500000 ] || fail 'report.html has more than 1.5 MB'
[ "$(grep -o '@TRIBUNAL_DATA@' report.html | wc -l)" -eq 1 ] || fail 'report.html has no one place for the data'
! grep -nE 'innerHTML|outerHTML|insertAdjacentHTML|document\.write|\beval\(|new Function|fetch\(|XMLHttpRequest|WebSocket' src/*.js >&2 || fail 'src: names must stay text, and nothing is loaded'
grep -qF "default-src 'none'" report.html || fail 'report.html does not forbid requests'
! grep -nE '"resolved"' package-lock.json >&2 || fail 'package-lock.json names a registry'
for name in three uplot; do grep -qE "^$name [0-9.]+ \(MIT\)" LICENCES.txt || fail "LICENCES.txt lacks $name"; done
