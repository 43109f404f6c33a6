#!/usr/bin/env bash
# Another rounding mode, or flush-to-zero, forced from outside before main and in every new thread: the program repairs
# it or refuses (exit 4), and never answers otherwise than in the default environment.
source "$(dirname "$0")/common.bash"
cd "$scratch"

cat >force.c <<'EOF'
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <stdlib.h>
#include <xmmintrin.h>

static void force(void) { _mm_setcsr(_mm_getcsr() & ~0xe040u | (unsigned)strtoul(getenv("FORCED_MXCSR"), 0, 16)); }

__attribute__((constructor)) static void at_start(void) { force(); }

struct start { void *(*run)(void *); void *with; };

static void *forced_run(void *p) {
  struct start s = *(struct start *)p;
  free(p);
  force();
  return s.run(s.with);
}

int pthread_create(pthread_t *t, const pthread_attr_t *a, void *(*run)(void *), void *with) {
  int (*real)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *) = dlsym(RTLD_NEXT, "pthread_create");
  struct start *s = malloc(sizeof *s);
  s->run = run;
  s->with = with;
  return real(t, a, forced_run, s);
}
EOF
gcc -shared -fPIC -O1 -w force.c -o force.so -ldl
force=$(preloaded "$scratch/force.so")

cd "$SOURCE_DIR"
cases=data/cases/classes163.jsonl
ask() { "$TRIBUNAL" classify --method sf-filtered,sf-rational,sf-double --in "$cases"; }
hunt() { "$TRIBUNAL" fuzz --method sf-filtered --count 4000 --threads 2 --family scale; }
ask >"$scratch/expected"
hunt 2>/dev/null | grep '^sf-filtered' >"$scratch/expected_hunt"
[ -s "$scratch/expected" ]
[ -s "$scratch/expected_hunt" ]

for bits in 2000 4000 6000 8000 0040 8040 e040; do
  for command in ask hunt; do
    status=0
    FORCED_MXCSR=$bits LD_PRELOAD=$force $command >"$scratch/answers" 2>"$scratch/err" || status=$?
    [ $status -eq 4 ] && continue
    [ $status -eq 0 ] || { cat "$scratch/err" >&2; exit 1; }
    if [ $command = hunt ]; then
      grep '^sf-filtered' "$scratch/answers" | diff "$scratch/expected_hunt" -
    else
      diff "$scratch/expected" "$scratch/answers"
    fi
  done
done
