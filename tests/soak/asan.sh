#!/usr/bin/env bash
# Every test of ./run test under the address and undefined-behaviour sanitizers, leaks included.
source "$(dirname "$0")/sanitized.bash"
export UBSAN_OPTIONS=print_stacktrace=1
configure asan-ubsan
catches asan-ubsan overrun <<<'int main(int c, char**) { int* a = new int[2]; return a[c + 1] & 0; }'
catches asan-ubsan leak <<<'int* volatile p; int main() { p = new int; p = nullptr; }'
catches asan-ubsan overflow <<<'int main(int c, char**) { int x = 2147483647; x += c; return x & 0; }'
run_suite asan-ubsan 'tests of the whole suite under the address, leak and undefined-behaviour sanitizers'
