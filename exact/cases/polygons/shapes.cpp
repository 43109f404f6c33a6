#include "exact/cases/polygons/shapes.h"

namespace tribunal {

std::span<const Shape> all_shapes() {
  static const PlaneRing square = {{0, 0}, {12, 0}, {12, 12}, {0, 12}};
  static const PlaneRing reversed_square = {{0, 0}, {0, 12}, {12, 12}, {12, 0}};
  static const std::array<Shape, shape_count> shapes = {{
      {"triangle", {{{0, 0}, {12, 0}, {0, 12}}}},
      {"convex", {{{2, 0}, {8, 0}, {12, 6}, {8, 12}, {2, 12}, {0, 6}}}},
      {"flat vertices", {{{0, 0}, {4, 0}, {8, 0}, {12, 0}, {12, 12}, {6, 12}, {0, 12}, {0, 6}}}},
      {"dart", {{{0, 0}, {12, 6}, {0, 12}, {4, 6}}}},
      {"comb", {{{0, 0}, {12, 0}, {12, 12}, {10, 12}, {8, 2}, {6, 12}, {4, 2}, {2, 12}, {0, 12}}}},
      {"horseshoe", {{{0, 12}, {0, 0}, {12, 0}, {12, 12}, {8, 12}, {8, 4}, {4, 4}, {4, 12}}}},
      {"bow-tie", {{{0, 0}, {12, 12}, {12, 0}, {0, 12}}}},
      {"pentagram", {{{6, 0}, {10, 12}, {0, 4}, {12, 4}, {2, 12}}}},
      {"twice around", {{{0, 0}, {12, 0}, {12, 12}, {0, 12}, {2, 2}, {10, 2}, {10, 10}, {2, 10}}}},
      {"spike outward", {{{0, 0}, {8, 0}, {8, 4}, {12, 4}, {8, 4}, {8, 8}, {0, 8}}}},
      {"spike inward", {{{0, 0}, {12, 0}, {12, 12}, {6, 12}, {6, 4}, {6, 12}, {0, 12}}}},
      {"repeated vertices", {{{0, 0}, {12, 0}, {12, 0}, {12, 12}, {12, 12}, {12, 12}, {0, 12}}}},
      {"one point", {{{6, 6}}}},
      {"two points", {{{2, 2}, {10, 6}}}},
      {"on a line", {{{0, 0}, {8, 4}, {4, 2}, {12, 6}}}},
      {"first three on a line", {{{0, 0}, {0, 0}, {4, 0}, {8, 0}, {12, 12}, {6, 6}, {2, 10}}}},
      {"hole", {square, {{4, 4}, {8, 4}, {6, 8}}}},
      {"holes that touch", {square, {{0, 6}, {4, 4}, {4, 8}}, {{4, 4}, {8, 2}, {8, 6}}}},
      {"hole along an edge", {square, {{0, 4}, {0, 8}, {6, 6}}}},
      {"hole equal to the outer ring", {square, reversed_square}},
      {"nested island", {square, {{2, 2}, {10, 2}, {10, 10}, {2, 10}}, {{4, 4}, {8, 4}, {8, 8}, {4, 8}}}},
      {"hole across, point hole, slit",
       {{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{4, 4}, {12, 4}, {12, 12}, {4, 12}}, {{2, 2}}, {{6, 1}, {6, 3}}}},
  }};
  return shapes;
}

}  // namespace tribunal
