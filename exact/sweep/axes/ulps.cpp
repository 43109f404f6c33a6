// Neighbours of exact degeneracies.
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/ulp.h"
#include "exact/sweep/axes/placed.h"
#include "exact/sweep/axes/table.h"

namespace tribunal {
namespace {

constexpr int steps_64[] = {0,       1,       2,       4,       8,       1 << 4,  1 << 6,
                            1 << 10, 1 << 12, 1 << 14, 1 << 18, 1 << 22, 1 << 26, 1 << 30};
constexpr int steps_32[] = {0, 1, 2, 4, 8, 1 << 4, 1 << 6, 1 << 8, 1 << 10, 1 << 12, 1 << 14, 1 << 18, 1 << 21};
constexpr auto steps = by_format<steps_64, steps_32>;

constexpr int farthest(Format format) { return steps(format).back(); }

/// A triangle of integers that fill the significand and a segment that meets it exactly at the middle of an edge or at
/// a vertex, with its middle or its end; no other four of the points lie in a plane, as a rule.
SegmentPair draw_contact(Draw& draw, Format format) {
  const int bits = digits_of(format) - 3;
  Triangle t;
  t.a = draw_lattice_point(draw, bits, 2);
  t.b = draw_lattice_point(draw, bits, 2);
  t.c = draw_lattice_point(draw, bits, 2);
  const Point3 v = draw_lattice_point(draw, bits, 1);
  const Point3 x = draw.below(2) == 0 ? t.a : (t.a + t.b) * 0.5;
  const bool through = draw.below(2) == 0;
  return {through ? through_exactly(x, v) : Segment{x + v, x}, t};
}

/// Moves one coordinate of the end or the vertex without which there is no contact.
Trial place(Draw& draw, Format format, int value, std::uint64_t k) {
  SegmentPair pair = draw_contact(draw, format);
  Point3& moved = draw.below(2) == 0 ? pair.segment.q : pair.triangle.a;
  double& x = moved[static_cast<int>(draw.below(3))];
  x = moved_by_ulps(x, draw.below(2) == 0 ? value : -value, format);
  return placed_probe(k, pair, format, draw);
}

}  // namespace

StressAxis ulps_axis() {
  return {
      .name = "ulps",
      .quantity = "distance from an exact contact (units in the last place of one coordinate)",
      .population =
          "contacts at edges and vertices of integer triangles, one coordinate moved by value units in the last place",
      .spacing = Spacing::logarithmic,
      .easiest = farthest,
      .values = steps,
      .stream = stream_of("sweep ulps"),
      .place = place};
}

}  // namespace tribunal
