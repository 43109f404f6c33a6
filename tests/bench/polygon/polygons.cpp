#include "tests/bench/polygon/polygons.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/cases/families/draw.h"

namespace tribunal::bench {
namespace {

__extension__ using Wide = __int128;

enum Stream : std::uint32_t { polygon_stream = stream_of("benchmark polygons"), probe_stream };

/// Steps of the grid in the polygon's frame from its centre to its farthest vertex.
constexpr double radius = 1 << 20;
constexpr int rotation_bits = 29;
constexpr double jitter = 0.3;  ///< of the angle between two vertices

/// A point of the frame: u and v in the plane, w across it.
using FramePoint = std::array<std::int64_t, 3>;
using FrameRing = std::vector<FramePoint>;

double uniform(Draw& draw) { return std::ldexp(static_cast<double>(draw.next() >> 11), -53); }

/// An affine map with integer entries: a rounded rotation and an offset. Images of frame points stay below 2⁵³, so
/// they are exact; what is planar in the frame stays planar.
struct Frame {
  std::array<std::array<std::int64_t, 3>, 3> m;
  FramePoint offset;

  Point3 image(const FramePoint& p) const {
    Point3 x;
    for (int i = 0; i < 3; ++i) {
      const auto row = static_cast<std::size_t>(i);
      const std::int64_t sum = m[row][0] * p[0] + m[row][1] * p[1] + m[row][2] * p[2] + offset[row];
      x[i] = std::ldexp(static_cast<double>(sum), -49);
    }
    return x;
  }
};

std::int64_t entry(double x) { return std::llround(std::ldexp(x, rotation_bits)); }

/// A random frame, rotated by a random unit quaternion (Shoemake, "Uniform random rotations", Graphics Gems III,
/// 1992).
Frame draw_frame(Draw& draw) {
  const double a = uniform(draw), b = 2 * M_PI * uniform(draw), c = 2 * M_PI * uniform(draw);
  const double x = std::sqrt(1 - a) * std::sin(b), y = std::sqrt(1 - a) * std::cos(b), z = std::sqrt(a) * std::sin(c),
               w = std::sqrt(a) * std::cos(c);
  Frame f{{{{entry(1 - 2 * (y * y + z * z)), entry(2 * (x * y - z * w)), entry(2 * (x * z + y * w))},
            {entry(2 * (x * y + z * w)), entry(1 - 2 * (x * x + z * z)), entry(2 * (y * z - x * w))},
            {entry(2 * (x * z - y * w)), entry(2 * (y * z + x * w)), entry(1 - 2 * (x * x + y * y))}}},
          {}};
  for (std::int64_t& o : f.offset) o = draw.between(-(std::int64_t{1} << 51), std::int64_t{1} << 51);
  return f;
}

/// n vertices around the centre at jittered angles; `scale(i)` is the distance of vertex i.
template <class Scale>
FrameRing draw_ring(Draw& draw, int n, const Scale& scale) {
  FrameRing ring;
  const double turn = uniform(draw);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * M_PI * (turn + i + jitter * uniform(draw)) / n;
    const double r = radius * scale(i);
    ring.push_back({std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle)), 0});
  }
  return ring;
}

FrameRing draw_convex(Draw& draw, int n, double size = 1) {
  return draw_ring(draw, n, [size](int) { return size; });
}

FrameRing draw_star(Draw& draw, int n) {
  if (n > 4) return draw_ring(draw, n, [&](int i) { return i % 2 == 0 ? 1.0 : 0.25 + 0.2 * uniform(draw); });
  FrameRing dented = draw_convex(draw, 3);
  dented.push_back({(dented[2][0] + dented[0][0]) / 4, (dented[2][1] + dented[0][1]) / 4, 0});
  return dented;
}

/// Radius of a hole that stays within a convex ring of n vertices.
double hole_size(int n) { return std::min(0.45, 0.8 * std::cos(M_PI * (1 + jitter) / n)); }

std::vector<FrameRing> draw_rings(Draw& draw, Outline outline, int n) {
  switch (outline) {
    case Outline::convex:
      return {draw_convex(draw, n)};
    case Outline::concave:
      return {draw_star(draw, n)};
    case Outline::holed:
      return {draw_convex(draw, n - n / 2), draw_convex(draw, n / 2, hole_size(n - n / 2))};
    case Outline::concave_holed:
      break;
  }
  return {draw_star(draw, n - n / 4), draw_convex(draw, n / 4, 0.15)};
}

struct FramedPolygon {
  Frame frame;
  std::vector<FrameRing> rings;

  PolygonData image() const {
    PolygonData polygon;
    for (const FrameRing& ring : rings) {
      for (const FramePoint& v : ring) polygon.vertices.push_back(frame.image(v));
      polygon.ends.push_back(polygon.vertices.size());
    }
    return polygon;
  }
};

enum class Fate : std::uint8_t { hit, outside, plane_missed, degenerate };

/// Half-open crossing parity of the point where pq crosses w = 0, times the denominator |p_w| + |q_w|.
Fate fate_of(const FramePoint& p, const FramePoint& q, const std::vector<FrameRing>& rings) {
  if (p[2] == 0 || q[2] == 0) return Fate::degenerate;
  if ((p[2] > 0) == (q[2] > 0)) return Fate::plane_missed;
  const std::int64_t a = std::abs(q[2]), b = std::abs(p[2]), den = a + b;
  const std::int64_t x = p[0] * a + q[0] * b, y = p[1] * a + q[1] * b;
  bool inside = false;
  for (const FrameRing& ring : rings) {
    for (std::size_t i = 0, last = ring.size() - 1; i < ring.size(); last = i++) {
      const FramePoint &f = ring[last], &g = ring[i];
      if ((f[1] * den > y) == (g[1] * den > y)) continue;
      const Wide area = Wide{g[0] - f[0]} * (y - f[1] * den) - Wide{g[1] - f[1]} * (x - f[0] * den);
      if (area == 0) return Fate::degenerate;
      inside ^= (area > 0) == (g[1] > f[1]);
    }
  }
  return inside ? Fate::hit : Fate::outside;
}

FramePoint draw_end(Draw& draw) {
  FramePoint p;
  for (std::int64_t& x : p) x = draw.between(-static_cast<std::int64_t>(radius), static_cast<std::int64_t>(radius));
  return p;
}

/// The other end of a segment from p whose midpoint is a ring vertex or that of a ring edge.
FramePoint mirrored(Draw& draw, const FramePoint& p, const std::vector<FrameRing>& rings) {
  const FrameRing& ring = rings[draw.below(rings.size())];
  const std::size_t i = draw.below(ring.size());
  const FramePoint &a = ring[i], &b = draw.below(2) == 0 ? a : ring[(i + 1) % ring.size()];
  return {a[0] + b[0] - p[0], a[1] + b[1] - p[1], a[2] + b[2] - p[2]};
}

/// Whether a probe with this fate may be the i-th of the mix. Hits are spread evenly, since 37 is coprime to 100.
bool fits(Fate fate, Mix mix, std::size_t i) {
  const std::size_t percent = i * 37 % 100;
  if (fate == Fate::degenerate) return false;
  if (mix == Mix::boundary) return fate == Fate::hit;
  if (mix == Mix::plane_missed) return fate == (percent < 5 ? Fate::outside : Fate::plane_missed);
  const std::size_t hits = mix == Mix::hits_7 ? 7 : mix == Mix::hits_50 ? 50 : 0;
  return (fate == Fate::hit) == (percent < hits);
}

}  // namespace

const char* name_of(Outline outline) {
  constexpr const char* names[] = {"convex", "concave", "holed", "concave_holed"};
  return names[static_cast<int>(outline)];
}

int least_vertices(Outline outline) {
  constexpr int counts[] = {3, 4, 6, 16};
  return counts[static_cast<int>(outline)];
}

const char* name_of(Mix mix) {
  constexpr const char* names[] = {"hits_0", "hits_7", "hits_50", "plane_missed", "boundary"};
  return names[static_cast<int>(mix)];
}

std::string Population::name() const {
  return std::string(name_of(mix)) + "/" + name_of(outline) + "/n" + std::to_string(vertices);
}

Population draw_population(Outline outline, int vertices, Mix mix, std::size_t polygons, std::size_t probes) {
  Population population{outline, vertices, mix, {}, {}};
  const std::uint64_t seed = static_cast<std::uint64_t>(vertices) << 8 | static_cast<std::uint64_t>(outline);
  std::vector<FramedPolygon> framed;
  for (std::size_t k = 0; k < polygons; ++k) {
    Draw draw(polygon_stream, seed, k);
    const Frame frame = draw_frame(draw);
    framed.push_back({frame, draw_rings(draw, outline, vertices)});
    population.polygons.push_back(framed.back().image());
  }
  for (std::uint64_t k = 0; population.probes.size() < probes; ++k) {
    Draw draw(probe_stream, seed, k);
    const auto chosen = static_cast<std::uint32_t>(draw.below(polygons));
    const FramePoint p = draw_end(draw);
    const bool touches = mix == Mix::boundary && p[2] != 0;
    const FramePoint q = touches ? mirrored(draw, p, framed[chosen].rings) : draw_end(draw);
    const Fate fate = touches ? Fate::hit : fate_of(p, q, framed[chosen].rings);
    if (!fits(fate, mix, population.probes.size())) continue;
    const Frame& frame = framed[chosen].frame;
    population.probes.push_back({{frame.image(p), frame.image(q)}, chosen, fate == Fate::hit});
    population.hits += fate == Fate::hit;
    population.plane_missed += fate == Fate::plane_missed;
  }
  return population;
}

}  // namespace tribunal::bench
