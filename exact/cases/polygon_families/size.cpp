// Rings with rounded vertices, at every size of the geometry.
#include <cmath>

#include "exact/cases/families/levels.h"
#include "exact/cases/families/probe.h"
#include "exact/cases/polygon_families/star.h"
#include "exact/cases/polygon_families/table.h"

namespace tribunal {
namespace {

/// A random number of vertices: mostly small, sometimes up to 32.
int draw_count(Draw& draw) {
  const std::int64_t most = std::int64_t{4} << draw.below(4);
  return static_cast<int>(draw.between(3, most));
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family size"), seed, k);
  const auto [is_ray, level] = turn_of(k, geometry_sizes(format).size());
  const double size = std::ldexp(1.0, geometry_sizes(format)[level]);
  Star star = draw_star(draw, format, draw_count(draw));
  for (Point3& v : star.polygon.vertices) v = in_format(size * v, format);
  const Segment through{size * star.through.p, size * star.through.q};
  return {.query = {draw_probe(is_ray, through, format, draw), std::move(star.polygon)},
          .format = format,
          .level = static_cast<std::uint16_t>(level)};
}

}  // namespace

/// Star-shaped rings of size 2^level: products underflow or overflow, a ray's through its direction alone.
Family polygon_size_family() {
  return {.name = "polygon-size",
          .stresses = "rings planar up to rounding at every size of geometry and direction",
          .population = "random rings in [-2^level,2^level]^3 as they round",
          .axis = "log2 of the size",
          .constructs = false,
          .levels = geometry_sizes,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
