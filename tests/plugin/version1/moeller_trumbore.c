/* A plugin: the test of Moeller and Trumbore in double precision.
 *
 *   cc -std=c99 -O2 -ffp-contract=off -shared -fPIC -I exact/plugin -o libmine.so docs/examples/moeller_trumbore.c
 *   build/release/tribunal fuzz --plugin libmine.so --method my-mt
 *
 * Source: Moeller & Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", Journal of Graphics Tools 2(1), 1997.
 * With -DPLANTED_MISTAKE the last comparison is wrong, for a test to find: a hit beyond the edge bc is reported. */
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

static int ask(int probe, const double x[15]) {
  const double *o = x, *a = x + 6, *b = x + 9, *c = x + 12;
  double d[3], e1[3], e2[3], pvec[3], tvec[3], qvec[3];
  if (probe == TRIBUNAL_RAY) {
    for (int i = 0; i < 3; ++i) d[i] = x[3 + i];
  } else {
    sub(x + 3, o, d);
  }
  sub(b, a, e1);
  sub(c, a, e2);
  cross(d, e2, pvec);
  const double det = dot(e1, pvec);
  if (det == 0) return TRIBUNAL_MISS;
  sub(o, a, tvec);
  const double u = dot(tvec, pvec) / det;
  if (!(u >= 0 && u <= 1)) return TRIBUNAL_MISS;
  cross(tvec, e1, qvec);
  const double v = dot(d, qvec) / det;
#ifdef PLANTED_MISTAKE
  if (!(v >= 0 && v <= 1)) return TRIBUNAL_MISS;
#else
  if (!(v >= 0 && u + v <= 1)) return TRIBUNAL_MISS;
#endif
  const double t = dot(e2, qvec) / det;
  return t >= 0 && (probe == TRIBUNAL_RAY || t <= 1) ? TRIBUNAL_HIT : TRIBUNAL_MISS;
}

/* A batch form is for tests that answer several queries at once, by SIMD say; this one shows the layout. */
static void ask_batch(int probe, size_t n, const double* queries, int* answers) {
  for (size_t i = 0; i < n; ++i) answers[i] = ask(probe, queries + 15 * i);
}

const tribunal_plugin* tribunal_plugin_describe(void) {
  static const tribunal_plugin plugin = {
      .abi = TRIBUNAL_PLUGIN_ABI,
      .name = "my-mt",
      .contract = "segment, ray; any triangle",
      .summary = "Cramer's rule, three divisions",
      .reference = "Moeller & Trumbore 1997",
      .format = TRIBUNAL_BINARY64,
      .convention = TRIBUNAL_TRANSVERSAL,
      .ask = ask,
      .ask_batch = ask_batch,
  };
  return &plugin;
}
