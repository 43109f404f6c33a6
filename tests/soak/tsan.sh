#!/usr/bin/env bash
# The threaded part of the suite under the thread sanitizer: every test that names threads in its source.
source "$(dirname "$0")/sanitized.bash"
export TSAN_OPTIONS="halt_on_error=1 second_deadlock_stack=1 suppressions=$SOURCE_DIR/tests/soak/tsan.supp"
configure tsan
catches tsan race <<<'#include <thread>
int n; int main() { std::thread t([] { ++n; }); ++n; t.join(); }'

# The suites of GoogleTest files, and the scripts.
threaded=$(
  cd tests
  grep -lE 'threads|std::j?thread' -r core exact tracer --include='*_test.cpp' |
    xargs sed -nE 's/^TEST(_F|_P)?\((\w+),.*/\2/p' | sort -u | sed 's/.*/(core|exact|tracer)\\.([^.]*\/)?&[.\/]/'
  grep -lE -e '--threads' -r cli --include='*.sh' | sed -E 's/cli\/(.*)\.sh/cli\\.\1$/'
)
[ "$(wc -l <<<"$threaded")" -ge 20 ] || { echo "only $(wc -l <<<"$threaded") threaded suites and scripts found" >&2; exit 1; }
run_suite tsan 'tests that use threads, under the thread sanitizer' -R "^($(paste -sd'|' <<<"$threaded"))"
