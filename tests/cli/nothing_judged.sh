#!/usr/bin/env bash
# A command that judged nothing of a method has not tried it: it fails, with one line that says so.
source "$(dirname "$0")/common.bash"
cd "$scratch"

cat >rays.c <<'C'
#include "tribunal_plugin.h"
static int ask(int probe, const double* query) { (void)probe; (void)query; return 0; }
static const tribunal_plugin rays = {.abi = TRIBUNAL_PLUGIN_ABI, .name = "rays-only", .summary = "misses every ray",
                                     .format = TRIBUNAL_BINARY64, .convention = TRIBUNAL_CLOSED, .ask = ask,
                                     .operands = TRIBUNAL_NO_SEGMENTS};
const tribunal_plugin* tribunal_plugin_describe(void) { return &rays; }
C
plugin rays rays.c

# Case 0 of this family is a segment.
expect 2 fuzz --plugin rays.so --method rays-only --family grazing --count 1
says err 'rays-only: nothing was judged'
expect 2 fuzz --plugin rays.so --method sf-double,rays-only --family grazing --count 1
says err 'rays-only: nothing was judged'
expect 1 fuzz --plugin rays.so --method rays-only --family grazing --count 2000
expect 2 chart --plugin rays.so --method rays-only --count 100 --out charts
says err 'rays-only: a chart asks segments and triangles, or polygons'
expect 0 fuzz --method sf-rational --family grazing --count 1
