/* What a build of the naive methods exports: they are compiled once more, by a compiler and flags of their own, into a
 * library that the program loads. C, since the two sides need not agree on anything else. */
#pragma once

#include <stddef.h>

/* 1: a hit. `ray` ≠ 0: p, q are origin and direction of a ray. p, q, a, b, c, each x, y, z, are finite. */
typedef int tribunal_battery_ask(int ray, const double query[15]);

typedef struct tribunal_battery_entry {
  const char* name; /* of the method, without its format */
  int bits;         /* 32 or 64: the format */
  tribunal_battery_ask* ask;
} tribunal_battery_entry;

typedef struct tribunal_battery {
  const char* compiler; /* as it calls itself */
  const char* flags;
  size_t size;
  const tribunal_battery_entry* entries;
} tribunal_battery;

/* The one function of the library, `tribunal_battery_describe`. */
typedef const tribunal_battery* tribunal_battery_function(void);
