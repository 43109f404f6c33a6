// Polygons with more and more vertices.
#include <cmath>
#include <numbers>

#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/polygon_families/image.h"
#include "exact/sweep/axes/table.h"

namespace tribunal {
namespace {

constexpr int counts_of_vertices[] = {3, 4, 6, 8, 12, 16, 32, 64, 128, 256};

std::span<const int> counts(Format) { return counts_of_vertices; }
constexpr int fewest(Format) { return counts_of_vertices[0]; }

constexpr int radius = 1000;

/// A star-shaped ring of n vertices with even coordinates, 2000 to 4000 from the origin: the middle of an edge is an
/// integer point too.
PlaneRing draw_star_ring(Draw& draw, int n) {
  PlaneRing ring;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    const auto length = static_cast<double>(radius + draw.between(0, radius));
    ring.push_back({2 * static_cast<int>(length * std::cos(angle)), 2 * static_cast<int>(length * std::sin(angle))});
  }
  return ring;
}

/// A vertex, the middle of an edge, or any point of the square around the ring.
PlanePoint draw_point_near(Draw& draw, const PlaneRing& ring) {
  const std::size_t i = draw.below(ring.size());
  const PlanePoint &a = ring[i], &b = ring[(i + 1) % ring.size()];
  const auto u = static_cast<int>(draw.between(-4 * radius, 4 * radius));
  const auto v = static_cast<int>(draw.between(-4 * radius, 4 * radius));
  const std::uint64_t aim = draw.below(3);
  if (aim == 0) return a;
  return aim == 1 ? PlanePoint{(a.u + b.u) / 2, (a.v + b.v) / 2} : PlanePoint{u, v};
}

/// Through the point, exactly, at a slant.
ProbeEnds draw_ends(Draw& draw, const PlanePoint& x) {
  const std::int64_t du = draw.between(-radius, radius);
  const std::int64_t dv = draw.between(-radius, radius);
  const std::int64_t height = draw.between(1, radius);
  const ProbeEnds ends{{x.u + du, x.v + dv, height}, {x.u - du, x.v - dv, -height}};
  return draw.below(2) == 0 ? ends : ProbeEnds{ends.to, ends.from};
}

/// |M·x| < 2^(bits + 14), which leaves room for an exact direction in the format.
Trial place(Draw& draw, Format format, int value, std::uint64_t k) {
  const PlaneRing ring = draw_star_ring(draw, value);
  const PlanePoint x = draw_point_near(draw, ring);
  const ProbeEnds ends = draw_ends(draw, x);
  const AffineMap map = draw_map(draw, format == Format::binary32 ? 8 : 30);
  return {.query = {image(turn_of(k, 1).is_ray, map, ends, format, draw, 0), image(map, std::array{ring})},
          .format = format};
}

}  // namespace

StressAxis vertices_axis() {
  return {.name = "vertices",
          .quantity = "vertices of the polygon",
          .population = "star-shaped planar rings under exact integer maps, probes through vertices, edges and near",
          .operands = Operands::polygons,
          .spacing = Spacing::logarithmic,
          .easiest = fewest,
          .values = counts,
          .stream = stream_of("sweep vertices"),
          .place = place};
}

}  // namespace tribunal
