#!/usr/bin/env bash
# record_readers.sh ROOT: JSON values become texts and numbers behind one door, exact/base/record.h, which checks types and
# bounds and says where. Prints every conversion elsewhere as file:line:text.
set -euo pipefail
cd "$1"
[ -f exact/base/record.cpp ] || { echo "exact/base/record.cpp: expected the readers of records" >&2; exit 1; }

# The library's conversions and its look-ups that throw; texts and numbers initialised by a member of a value.
conversion='\.(get|get_ref|get_ptr)<|\.get_to\(|\.at\("[^"]*"\)|\.value\("[^"]*", |Json::parse\(|(std::string|std::uint64_t|std::size_t|double|int|bool) [a-z_]+ = [a-z_.()]+\["[^"]*"\];'
breaches=$(grep -rnE --include='*.h' --include='*.cpp' "$conversion" core exact tracer main.cpp |
  grep -vE '^exact/base/(json|record)\.cpp:' | sed 's://.*::' | grep -E "$conversion" || true)
[ -z "$breaches" ] && exit 0
printf 'a JSON value is converted outside exact/base/record.h (class Record reads it, and says where it is wrong):\n%s\n' \
  "$breaches" >&2
exit 1
