#!/usr/bin/env bash
# Cases as tests to paste: they compile, pass against a right test, fail against a wrong one, and their signs are right.
source "$(dirname "$0")/common.bash"
cd "$scratch"

expect 1 fuzz --method sf-double --family affine,grazing --count 6000 --keep 6 --out found
for language in c gtest python; do
  expect 0 replay found/counterexamples.jsonl --emit "$language" --function right && mv out "emitted.$language"
done
cases=$(wc -l <found/counterexamples.jsonl)
[ "$cases" -gt 3 ]
[ "$(grep -c 'assert(' emitted.c)" -eq "$cases" ]
[ "$(grep -c '^TEST(' emitted.gtest)" -eq "$cases" ]

/usr/bin/python3 emitted.python
sed 's/== \[\(-\?[01]\), /== [2, /' emitted.python >wrong.python
! /usr/bin/python3 wrong.python 2>/dev/null || { echo "a wrong sign was accepted" >&2; exit 1; }

# The answers that the file expects, in its order, make a test that is right on these cases, and its opposite.
grep -o '== [01])' emitted.c | tr -dc '01\n' | sed 's/$/,/' >expected.inc
for flip in 0 1; do
  cat >asked.c <<C
static const int expected[] = {
#include "expected.inc"
};
static int next;
int right_segment(const double p[6], const double t[9]) { (void)p; (void)t; return expected[next++] ^ $flip; }
int right_ray(const double p[6], const double t[9]) { (void)p; (void)t; return expected[next++] ^ $flip; }
C
  ${CC:-cc} -std=c99 -Wall -Wextra -Werror -x c emitted.c asked.c -o "asked$flip"
done
./asked0
! ./asked1 2>/dev/null || { echo "wrong answers were accepted" >&2; exit 1; }
$CXX -std=c++20 -fsyntax-only -x c++ emitted.gtest
expect 2 replay found/counterexamples.jsonl --emit fortran

# Ids are anything that a file says, and none becomes code.
shape='"seg":[[0.25,0.25,-1],[0.25,0.25,1]],"tri":[[0,0,0],[1,0,0],[0,1,0]]'
long=$(printf 'x%.0s' {1..4000})
for id in 'a*/ #error' 'a\n#error' 'a\r\nraise SystemExit(1)' 'a/*/' '/*' '' 'back\\' '??/' 'a\u0000b' 'tab\there' '\u00e9\u2028#' "$long"; do
  printf '{"id":"%s",%s}\n' "$id" "$shape"
done >hostile.jsonl
for language in c gtest python; do
  expect 0 replay hostile.jsonl --emit "$language" --function right && mv out "hostile.$language"
done
/usr/bin/python3 hostile.python
echo 'int right_segment(const double p[6], const double t[9]) { (void)p; (void)t; return 1; }' >always.c
${CC:-cc} -std=c99 -Wall -Wextra -Werror -x c hostile.c always.c -o hostile && ./hostile
$CXX -std=c++20 -Wall -Wextra -Werror -fsyntax-only -x c++ hostile.gtest
for name in 'a b' 1x '' 'x;y' é; do expect 2 replay hostile.jsonl --emit c --function "$name"; done
