// Adjacent floats between which the answer flips.
#include "exact/families/shapes.h"
#include "exact/families/table.h"
#include "exact/methods.h"

namespace tribunal {
namespace {

constexpr int no_levels[] = {0};

std::span<const int> levels(Format) { return no_levels; }

/// A filtered exact method: the generator asks some fifty times a case. The oracles judge what comes out.
bool hits(const Segment& s, const Triangle& t) {
  static const Method& exact = *find_method("sf-epick");
  return exact.segment(s, t).hit;
}

/// Moves one coordinate of the source from a hit toward a miss until they are adjacent; k even takes the hit.
Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(11, seed, k / 2);
  const Triangle t = draw_triangle(draw, format);
  const Point3 n = draw_point(draw, format);
  const Segment centre = through(in_format((t.a + t.b + t.c) / 3.0, format), n, n);
  Segment s{in_format(centre.p, format), in_format(centre.q, format)};
  const int axis = static_cast<int>(draw.below(3));
  double in = s.p[axis];
  double out = in + (draw.below(2) == 0 ? 8 : -8);
  const auto at = [&](double x) {
    s.p[axis] = x;
    return s;
  };
  if (!hits(at(in), t) || hits(at(out), t)) return unclassified(format, 0, at(in), t);
  for (double middle = in_format(in + (out - in) / 2, format); middle != in && middle != out;
       middle = in_format(in + (out - in) / 2, format)) {
    (hits(at(middle), t) ? in : out) = middle;
  }
  return unclassified(format, 0, at(k % 2 == 0 ? in : out), t);
}

}  // namespace

/// The last two neighbours before the answer flips: one coordinate of a segment bisected down to adjacent floats.
Family flip_family() {
  return {.name = "flip",
          .stresses = "adjacent floats between which the exact answer flips",
          .population = "random triangles in [-1,1]^3, one coordinate of the segment bisected to a flip",
          .axis = "(none)",
          .proves_class = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
