/* Plugins that break one promise each: compile with -DNAME='"x"' and the like. The rest of it always misses. */
#ifdef CHANGES_LOCALE
#define _GNU_SOURCE /* for newlocale and uselocale */
#endif

#include "tribunal_plugin.h"

#ifdef CHANGES_ROUNDING
#include <fenv.h>
#endif

#if defined(UNMASKS) || defined(TRAPS)
int feenableexcept(int);
#endif

#ifdef CHANGES_LOCALE
#include <locale.h>
#endif

#ifdef WANTS_MEMORY
#include <stdlib.h>
#endif

#ifdef FLUSHES_TO_ZERO /* as gcc 12 does for a library that is linked with -ffast-math */
#include <immintrin.h>
__attribute__((constructor)) static void flush(void) { _mm_setcsr(_mm_getcsr() | 0x8040); }
#endif

#ifndef ABI
#define ABI TRIBUNAL_PLUGIN_ABI
#endif
#ifndef NAME
#define NAME "broken"
#endif
#ifndef CONTRACT
#define CONTRACT "segment; any triangle"
#endif
#ifndef FORMAT
#define FORMAT TRIBUNAL_BINARY64
#endif
#ifndef CONVENTION
#define CONVENTION TRIBUNAL_CLOSED
#endif
#ifndef ASK
#define ASK ask
#endif
#ifndef MORE
#define MORE .operands = 0
#endif
#ifndef ANSWER
#define ANSWER TRIBUNAL_MISS
#endif

int ask(int probe, const double query[15]);
int ask(int probe, const double query[15]) {
  (void)query;
#ifdef CHANGES_ROUNDING
  fesetround(FE_UPWARD);
#endif
#ifdef CHANGES_PRECISION /* of x87, to 53 bits, as a program linked with -mpc64 has it */
  const unsigned short word = 0x027f;
  __asm__ volatile("fldcw %0" : : "m"(word));
#endif
#ifdef UNMASKS /* all exceptions: the next inexact result traps */
  feenableexcept(0x3d);
#endif
#ifdef TRAPS
  feenableexcept(0x3d);
  static volatile double three = 3;
  three = 1 / three;
#endif
#ifdef CHANGES_LOCALE
  static locale_t comma;
  if (comma == (locale_t)0) comma = newlocale(LC_ALL_MASK, "de_DE.UTF-8", (locale_t)0);
  if (comma == (locale_t)0 || setlocale(LC_ALL, "de_DE.UTF-8") == NULL) return 7;
  uselocale(comma);
#endif
#ifdef WANTS_MEMORY /* more than there is, and goes on without */
  void *const block = malloc((size_t)1 << 62);
  if (block != NULL) return 7;
#endif
#ifdef CRASHES
  *(volatile int*)0 = 1;
#endif
  return probe == TRIBUNAL_RAY ? TRIBUNAL_UNSUPPORTED : ANSWER;
}

const tribunal_plugin* tribunal_plugin_describe(void) {
#ifdef NOTHING
  return NULL;
#else
  static const tribunal_plugin plugin = {.abi = ABI,
                                         .name = NAME,
                                         .contract = CONTRACT,
                                         .summary = "breaks a promise",
                                         .format = FORMAT,
                                         .convention = CONVENTION,
                                         .ask = ASK,
                                         MORE};
  return &plugin;
#endif
}

#ifdef POLYGONS
#ifndef ASK_POLYGON
#define ASK_POLYGON ask_polygon
#endif
#ifndef RESTRICTIONS
#define RESTRICTIONS 0
#endif
#ifndef POLYGON_ABI
#define POLYGON_ABI TRIBUNAL_PLUGIN_ABI
#endif

int ask_polygon(int probe, const double coordinates[6], const tribunal_polygon* polygon);
int ask_polygon(int probe, const double coordinates[6], const tribunal_polygon* polygon) {
  const double nothing[15] = {coordinates[0], polygon->vertices[0]};
  return ask(probe, nothing);
}

extern const tribunal_polygon_plugin polygons;
const tribunal_polygon_plugin polygons = {POLYGON_ABI, RESTRICTIONS, ASK_POLYGON};

const tribunal_polygon_plugin* tribunal_plugin_describe_polygons(void) { return POLYGONS; }
#endif
