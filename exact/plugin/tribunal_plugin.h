/* Bring your own intersection test: what a shared library must export for `tribunal COMMAND --plugin libmine.so`.
 * C99 and C++; needs nothing else of Tribunal. docs/bring-your-own.md is the guide, docs/examples/ has an example.
 *
 * The library exports one function, tribunal_plugin_describe. The program calls it once, copies the strings, and from
 * then on knows the test as a method of that name. A second one, for polygons, is optional.
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
 *   - They return. A plugin runs in the program's own process: if it crashes, the program ends with it. With --isolate
 * it runs in child processes, and what it does in place of returning is a finding. */
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
  tribunal_ask* ask;             /* required, but for a test that takes polygons only */
  tribunal_ask_batch* ask_batch; /* or NULL */
} tribunal_plugin;

/* Polygons, if the test takes them: a second, optional function, tribunal_plugin_describe_polygons. A library without
 * it has a test of triangles only; one with it may have `ask` NULL in the first description, and then takes polygons
 * only. Name, format and convention are those of the first description; so are the promises above.
 *
 * A polygon is an outer ring and holes, one after the other: ring r has the vertices ends[r-1] (0 for r = 0) up to
 * ends[r], without repeating its first vertex at the end. There is at least one ring, and each has at least one vertex.
 * Rings may be concave, touch, cross, repeat vertices or have no area, and run either way. If all vertices lie in one
 * plane, the polygon is the closed even-odd region of all rings together with all ring edges; otherwise the surface of
 * docs/polygons.md. */
typedef struct tribunal_polygon {
  size_t rings;
  const size_t* ends;     /* rings of them; ends[rings - 1] is the number of vertices */
  const double* vertices; /* x, y, z each */
} tribunal_polygon;

/* Six coordinates of the probe: p, q of a segment, or o, d of a ray. */
typedef int tribunal_ask_polygon(int probe, const double coordinates[6], const tribunal_polygon* polygon);

/* What the test promises of polygons, beside its convention; a sum of these. Where it promises nothing it is not
 * judged. PLANAR_ONLY: nothing of polygons whose vertices do not lie in one plane exactly. NO_BOUNDARY: nothing where
 * the probe meets a ring edge. */
enum { TRIBUNAL_PLANAR_ONLY = 1, TRIBUNAL_NO_BOUNDARY = 2 };

typedef struct tribunal_polygon_plugin {
  int abi;                   /* TRIBUNAL_PLUGIN_ABI */
  int restrictions;          /* 0, or a sum of those above */
  tribunal_ask_polygon* ask; /* required */
} tribunal_polygon_plugin;

#if defined(__GNUC__)
#define TRIBUNAL_EXPORT __attribute__((visibility("default")))
#else
#define TRIBUNAL_EXPORT
#endif

TRIBUNAL_EXPORT const tribunal_plugin* tribunal_plugin_describe(void);
TRIBUNAL_EXPORT const tribunal_polygon_plugin* tribunal_plugin_describe_polygons(void); /* optional */

#ifdef __cplusplus
}
#endif

#endif
