#include "exact/report/sketch.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace tribunal {
namespace {

constexpr double width = 360, height = 240, margin = 34;

using Points = std::array<Point3, 5>;  // a b c p q

struct Range {
  double low, high;

  /// x as a share of the range; its middle if it is a single value.
  double place_of(double x) const { return high > low ? (x - low) / (high - low) : 0.5; }
};

template <class Items, class Value>
Range range_of(const Items& items, const Value& value) {
  const auto [low, high] = std::ranges::minmax(items, {}, value);
  return {value(low), value(high)};
}

struct Spot {
  double x, y;
};

/// An oblique projection: x to the right and a little up, y to the left and up, z up.
std::array<Spot, 5> slanted(const Points& points) {
  std::array<Range, 3> ranges;
  for (int axis = 0; axis < 3; ++axis) {
    ranges[static_cast<std::size_t>(axis)] = range_of(points, [&](const Point3& p) { return p[axis]; });
  }
  std::array<Spot, 5> spots;
  for (std::size_t i = 0; i < 5; ++i) {
    const double x = ranges[0].place_of(points[i].x), y = ranges[1].place_of(points[i].y);
    spots[i] = {0.9 * x - 0.6 * y, 0.25 * x + 0.4 * y + 0.9 * ranges[2].place_of(points[i].z)};
  }
  return spots;
}

/// Fills the drawing but for a margin, the second coordinate upward.
std::array<Spot, 5> fitted(std::array<Spot, 5> spots) {
  const Range across = range_of(spots, [](const Spot& s) { return s.x; });
  const Range up = range_of(spots, [](const Spot& s) { return s.y; });
  for (Spot& s : spots) {
    s.x = margin + across.place_of(s.x) * (width - 2 * margin);
    s.y = height - margin - up.place_of(s.y) * (height - 2 * margin);
  }
  return spots;
}

std::string formatted(const char* format, auto... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::string dot(const Spot& s, const char* name, const char* style) {
  return formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"4\" class=\"%s\"/>", s.x, s.y, style) +
         formatted("<text x=\"%.1f\" y=\"%.1f\" class=\"%s\">%s</text>", s.x + 7, s.y - 8, style, name);
}

}  // namespace

std::string sketch(const Segment& s, const Triangle& t) {
  const std::array<Spot, 5> at = fitted(slanted({t.a, t.b, t.c, s.p, s.q}));
  std::string svg =
      formatted("<svg viewBox=\"0 0 %g %g\" role=\"img\" aria-label=\"sketch of the five points\">", width, height);
  svg += formatted("<polygon points=\"%.1f,%.1f %.1f,%.1f %.1f,%.1f\"/>", at[0].x, at[0].y, at[1].x, at[1].y, at[2].x,
                   at[2].y);
  svg += formatted("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\"/>", at[3].x, at[3].y, at[4].x, at[4].y);
  const char* const names[] = {"a", "b", "c", "p", "q"};
  for (std::size_t i = 0; i < 5; ++i) svg += dot(at[i], names[i], i < 3 ? "tri" : "seg");
  return svg + "</svg>\n";
}

}  // namespace tribunal
