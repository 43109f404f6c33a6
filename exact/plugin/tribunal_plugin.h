/* Bring your own intersection test: what a shared library must export for `tribunal COMMAND --plugin libmine.so`.
 * C99 and C++; needs nothing else of Tribunal. docs/bring-your-own.md is the guide, docs/examples/ has an example.
 *
 * The library exports one function, tribunal_plugin_describe. The program calls it once, copies the strings, and from
 * then on knows the test as a method of that name.
 *
 * Promises of the program
 *   - Coordinates are finite: NaN and infinities never reach a plugin.
 *   - Coordinates are exact in the format that the plugin states. A binary32 test may cast them to float without loss.
 *   - The thread rounds to nearest with gradual underflow (no FTZ, no DAZ), whatever flags the library was built with.
 *
 * Promises of the plugin
 *   - ask and ask_batch may be called from several threads at once, in any order, and answer the same query the same.
 *   - ask_batch answers every query as ask does.
 *   - They leave the floating-point environment as they found it, and throw nothing through this interface.
 *   - They return. A plugin runs in the program's own process: if it crashes, the program ends with it. */
#ifndef TRIBUNAL_PLUGIN_H
#define TRIBUNAL_PLUGIN_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Version of this interface; grows when it changes. A library built for another version is refused. */
#define TRIBUNAL_PLUGIN_ABI 1

/* The probe that a query holds. */
enum {
  TRIBUNAL_SEGMENT = 0, /* the closed segment [p, q] */
  TRIBUNAL_RAY = 1      /* the half-line {o + t*d, t >= 0}; d need not have length 1, and may be 0 */
};

/* Answers. UNSUPPORTED: outside the contract; counted, never as an error. */
enum { TRIBUNAL_MISS = 0, TRIBUNAL_HIT = 1, TRIBUNAL_UNSUPPORTED = 2 };

/* The format that the test computes in. A binary32 test is judged on cases that are exact in binary32 only. */
enum { TRIBUNAL_BINARY32 = 32, TRIBUNAL_BINARY64 = 64 };

/* What the test promises. CLOSED: a hit where the closed point sets meet. TRANSVERSAL: the same, but a probe in the
 * triangle's plane is a miss (and so is any probe against a triangle without area, and a point in its plane).
 * It is judged by what it promises. */
enum { TRIBUNAL_CLOSED = 0, TRIBUNAL_TRANSVERSAL = 1 };

/* Fifteen coordinates: p, q, a, b, c of a segment, or o, d, a, b, c of a ray; x, y, z each. The triangle is the closed
 * conv(a, b, c) and may be degenerate, as the segment may. */
typedef int tribunal_ask(int probe, const double query[15]);

/* n queries with probes of one kind, the i-th at queries + 15*i, each answered in answers[i]. */
typedef void tribunal_ask_batch(int probe, size_t n, const double* queries, int* answers);

typedef struct tribunal_plugin {
  int abi;                       /* TRIBUNAL_PLUGIN_ABI */
  const char* name;              /* 1 to 32 of a-z A-Z 0-9 . _ -, a letter first; no other method's name */
  const char* contract;          /* which operands it takes, e.g. "segment, ray; any triangle" */
  const char* summary;           /* one line for people */
  const char* reference;         /* where it was published, or NULL */
  int format;                    /* TRIBUNAL_BINARY32 or TRIBUNAL_BINARY64 */
  int convention;                /* TRIBUNAL_CLOSED or TRIBUNAL_TRANSVERSAL */
  tribunal_ask* ask;             /* required */
  tribunal_ask_batch* ask_batch; /* or NULL */
} tribunal_plugin;

#if defined(__GNUC__)
__attribute__((visibility("default")))
#endif
const tribunal_plugin*
tribunal_plugin_describe(void);

#ifdef __cplusplus
}
#endif

#endif
