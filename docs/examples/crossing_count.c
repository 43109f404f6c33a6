/* A plugin with a polygon test: meet the plane, project, count crossings, in double precision.
 *
 *   cc -std=c99 -O2 -ffp-contract=off -shared -fPIC -I exact/plugin -o libmine.so docs/examples/crossing_count.c
 *   build/release/tribunal certify --plugin libmine.so --method my-polygons --out certificate
 *
 * Source: Haines, "Point in polygon strategies", Graphics Gems IV, 1994.
 * With -DPLANTED_MISTAKE holes are forgotten, for a test to find. */
#include "tribunal_plugin.h"

static double det2(double a, double b, double c, double d) { return a * d - b * c; }

/* The normal of the largest triangle (first vertex, two consecutive ones), as it rounds; its square is returned. */
static double normal_of(const tribunal_polygon* polygon, double n[3]) {
  const size_t count = polygon->ends[polygon->rings - 1];
  const double* o = polygon->vertices;
  double longest = 0;
  for (size_t i = 1; i + 1 < count; ++i) {
    const double *a = o + 3 * i, *b = a + 3;
    const double x = det2(a[1] - o[1], a[2] - o[2], b[1] - o[1], b[2] - o[2]);
    const double y = det2(a[2] - o[2], a[0] - o[0], b[2] - o[2], b[0] - o[0]);
    const double z = det2(a[0] - o[0], a[1] - o[1], b[0] - o[0], b[1] - o[1]);
    const double square = x * x + y * y + z * z;
    if (!(square > longest)) continue;
    longest = square;
    n[0] = x, n[1] = y, n[2] = z;
  }
  return longest;
}

static double absolute(double x) { return x < 0 ? -x : x; }

/* Whether (u, v), coordinates i and j, is inside by the parity of the edges to its right. */
static int inside(const tribunal_polygon* polygon, int i, int j, double u, double v) {
  int odd = 0;
  size_t begin = 0;
#ifdef PLANTED_MISTAKE
  const size_t rings = 1;
#else
  const size_t rings = polygon->rings;
#endif
  for (size_t r = 0; r < rings; begin = polygon->ends[r++]) {
    const size_t end = polygon->ends[r];
    for (size_t k = begin; k < end; ++k) {
      const double* a = polygon->vertices + 3 * k;
      const double* b = polygon->vertices + 3 * (k + 1 < end ? k + 1 : begin);
      if ((a[j] > v) == (b[j] > v)) continue;
      odd ^= u < a[i] + (b[i] - a[i]) * (v - a[j]) / (b[j] - a[j]);
    }
  }
  return odd;
}

static int ask_polygon(int probe, const double x[6], const tribunal_polygon* polygon) {
  double n[3], d[3], slope = 0, height = 0;
  if (!(normal_of(polygon, n) > 0)) return TRIBUNAL_MISS;
  for (int axis = 0; axis < 3; ++axis) {
    d[axis] = probe == TRIBUNAL_RAY ? x[3 + axis] : x[3 + axis] - x[axis];
    slope += n[axis] * d[axis];
    height += n[axis] * (polygon->vertices[axis] - x[axis]);
  }
  if (slope == 0) return TRIBUNAL_MISS;
  const double t = height / slope;
  if (!(t >= 0 && (probe == TRIBUNAL_RAY || t <= 1))) return TRIBUNAL_MISS;
  int dropped = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (absolute(n[axis]) > absolute(n[dropped])) dropped = axis;
  }
  const int i = (dropped + 1) % 3, j = (dropped + 2) % 3;
  return inside(polygon, i, j, x[i] + t * d[i], x[j] + t * d[j]) ? TRIBUNAL_HIT : TRIBUNAL_MISS;
}

const tribunal_plugin* tribunal_plugin_describe(void) {
  static const tribunal_plugin plugin = {
      .abi = TRIBUNAL_PLUGIN_ABI,
      .name = "my-polygons",
      .summary = "meets the plane, projects, counts crossings",
      .reference = "Haines 1994",
      .format = TRIBUNAL_BINARY64,
      .convention = TRIBUNAL_TRANSVERSAL,
  };
  return &plugin;
}

const tribunal_polygon_plugin* tribunal_plugin_describe_polygons(void) {
  static const tribunal_polygon_plugin polygons = {
      .abi = TRIBUNAL_PLUGIN_ABI,
      .restrictions = TRIBUNAL_PLANAR_ONLY | TRIBUNAL_NO_BOUNDARY,
      .ask = ask_polygon,
  };
  return &polygons;
}
