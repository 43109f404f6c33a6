/* A plugin: the test of Moeller and Trumbore in double precision.
 *
 *   cc -std=c99 -O2 -ffp-contract=off -shared -fPIC -I exact/plugin -o libmine.so docs/examples/moeller_trumbore.c
 *   build/release/tribunal fuzz --plugin libmine.so --method my-mt
 *
 * Source: Moeller & Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", Journal of Graphics Tools 2(1), 1997.
 * It also yields t, and prepares a triangle: its edges are computed once. With -DCULLS it misses faces seen from
 * behind, and says so.
 *
 * For tests of the harness: with -DPLANTED_MISTAKE the last comparison is wrong, and a hit beyond the edge bc is
 * reported; with -DABSOLUTE_EPSILON=1e-9 a determinant that is smaller is called parallel; with -DSAYS_IT_CULLS it does
 * not cull; with -DFORGETS_WHAT_IT_PREPARED it takes the edge ab for both. */
#include <stdlib.h>

#include "tribunal_plugin.h"

static void sub(const double* u, const double* v, double* w) {
  for (int i = 0; i < 3; ++i) w[i] = u[i] - v[i];
}

static double dot(const double* u, const double* v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

static void cross(const double* u, const double* v, double* w) {
  w[0] = u[1] * v[2] - u[2] * v[1];
  w[1] = u[2] * v[0] - u[0] * v[2];
  w[2] = u[0] * v[1] - u[1] * v[0];
}

/* A triangle, prepared: a vertex and two edges. */
typedef struct {
  double a[3], e1[3], e2[3];
} edges;

static edges edges_of(const double x[9]) {
  edges t;
  for (int i = 0; i < 3; ++i) t.a[i] = x[i];
  sub(x + 3, x, t.e1);
  sub(x + 6, x, t.e2);
  return t;
}

/* Whether the probe, p and q or o and d, hits; and then where. */
static int meet(const edges* triangle, int probe, const double x[6], double* t) {
  double d[3], pvec[3], tvec[3], qvec[3];
  if (probe == TRIBUNAL_RAY) {
    for (int i = 0; i < 3; ++i) d[i] = x[3 + i];
  } else {
    sub(x + 3, x, d);
  }
  cross(d, triangle->e2, pvec);
  const double det = dot(triangle->e1, pvec);
  if (det == 0) return TRIBUNAL_MISS;
#ifdef ABSOLUTE_EPSILON
  if (det > -(ABSOLUTE_EPSILON) && det < (ABSOLUTE_EPSILON)) return TRIBUNAL_MISS;
#endif
#ifdef CULLS
  if (det < 0) return TRIBUNAL_MISS;
#endif
  sub(x, triangle->a, tvec);
  const double u = dot(tvec, pvec) / det;
  if (!(u >= 0 && u <= 1)) return TRIBUNAL_MISS;
  cross(tvec, triangle->e1, qvec);
  const double v = dot(d, qvec) / det;
#ifdef PLANTED_MISTAKE
  if (!(v >= 0 && v <= 1)) return TRIBUNAL_MISS;
#else
  if (!(v >= 0 && u + v <= 1)) return TRIBUNAL_MISS;
#endif
  *t = dot(triangle->e2, qvec) / det;
  return *t >= 0 && (probe == TRIBUNAL_RAY || *t <= 1) ? TRIBUNAL_HIT : TRIBUNAL_MISS;
}

static int ask(int probe, const double x[15]) {
  const edges triangle = edges_of(x + 6);
  double t;
  return meet(&triangle, probe, x, &t);
}

static int tell(int probe, const double x[15], tribunal_hit* hit) {
  const edges triangle = edges_of(x + 6);
  hit->has_t = 1;
  return meet(&triangle, probe, x, &hit->t);
}

static void* prepare(const double x[9]) {
  edges* const triangle = malloc(sizeof *triangle);
  if (triangle == NULL) return NULL;
  *triangle = edges_of(x);
#ifdef FORGETS_WHAT_IT_PREPARED
  for (int i = 0; i < 3; ++i) triangle->e2[i] = triangle->e1[i];
#endif
  return triangle;
}

static int ask_prepared(const void* prepared, int probe, const double x[6]) {
  double t;
  return meet(prepared, probe, x, &t);
}

/* A batch form is for tests that answer several queries at once, by SIMD say; this one shows the layout. */
static void ask_batch(int probe, size_t n, const double* queries, int* answers) {
  for (size_t i = 0; i < n; ++i) answers[i] = ask(probe, queries + 15 * i);
}

const tribunal_plugin* tribunal_plugin_describe(void) {
  static const tribunal_plugin plugin = {
    .abi = TRIBUNAL_PLUGIN_ABI,
    .name = "my-mt",
    .summary = "Cramer's rule, three divisions",
    .reference = "Moeller & Trumbore 1997",
    .format = TRIBUNAL_BINARY64,
    .convention = TRIBUNAL_TRANSVERSAL,
    .ask = ask,
    .ask_batch = ask_batch,
#if defined(CULLS) || defined(SAYS_IT_CULLS)
    .culling = TRIBUNAL_CULLS_BACK_FACES,
#endif
    .tell = tell,
    .tells_t = 1,
    .prepare = prepare,
    .ask_prepared = ask_prepared,
    .release = free,
  };
  return &plugin;
}
