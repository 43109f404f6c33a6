#include "tracer/demo/sketch.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace tribunal {
namespace {

constexpr double width = 360, height = 240, margin = 34;

using Points = std::array<Point3, 5>;  // a b c p q

struct Range {
  double low, high;
  double extent() const { return high - low; }
};

Range range_of(const Points& points, int axis) {
  const auto [low, high] = std::ranges::minmax(points, {}, [&](const Point3& p) { return p[axis]; });
  return {low[axis], high[axis]};
}

/// The two axes other than the one of least extent, in order.
std::array<int, 2> shown_axes(const Points& points) {
  const std::array<int, 3> axes{0, 1, 2};
  const int hidden = std::ranges::min(axes, {}, [&](int axis) { return range_of(points, axis).extent(); });
  return {hidden == 0 ? 1 : 0, hidden == 2 ? 1 : 2};
}

double scaled(double x, const Range& range, double size) {
  return range.extent() > 0 ? margin + (x - range.low) / range.extent() * (size - 2 * margin) : size / 2;
}

struct Spot {
  double x, y;
};

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
  const Points points{t.a, t.b, t.c, s.p, s.q};
  const auto [across, up] = shown_axes(points);
  const Range x = range_of(points, across), y = range_of(points, up);
  std::array<Spot, 5> at;
  for (std::size_t i = 0; i < 5; ++i) {
    at[i] = {scaled(points[i][across], x, width), height - scaled(points[i][up], y, height)};
  }
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
