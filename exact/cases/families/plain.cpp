// Everyday scenes: walls, floors and boxes, upright and turned, and nothing degenerate or near it. The control: a test
// that is wrong here is wrong where nobody expects it.
#include <stdexcept>

#include "exact/cases/families/everyday.h"
#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

/// log10 of the size of the scene.
constexpr int sizes[] = {-3, -2, -1, 0, 1, 2, 3, 4};
constexpr double lengths[] = {1e-3, 1e-2, 1e-1, 1, 1e1, 1e2, 1e3, 1e4};

std::span<const int> levels(Format) { return sizes; }

double draw_within(Draw& draw, Format format, double lo, double hi) {
  return lo + (hi - lo) * (0.5 + 0.5 * draw_real(draw, format));
}

/// In [lo, hi], or the negative.
double draw_either_side(Draw& draw, Format format, double lo, double hi) {
  const double x = draw_within(draw, format, lo, hi);
  return draw.below(2) == 0 ? x : -x;
}

/// Three perpendicular directions of length 1, as they round.
struct Frame {
  Point3 u{1, 0, 0}, v{0, 1, 0}, w{0, 0, 1};

  Point3 at(const Point3& x) const { return x.x * u + x.y * v + x.z * w; }
};

/// Turns u towards v, by the angle whose half has this tangent.
void turn(Point3& u, Point3& v, double tangent) {
  const double c = (1 - tangent * tangent) / (1 + tangent * tangent), s = 2 * tangent / (1 + tangent * tangent);
  const Point3 turned = c * u + s * v;
  v = c * v - s * u;
  u = turned;
}

/// Upright, or turned about two axes; then a wall, a floor or a side, whichever axis w is.
Frame draw_frame(Draw& draw, Format format) {
  Frame f;
  if (draw.below(2) == 0) {
    const double yaw = draw_real(draw, format);
    turn(f.u, f.v, yaw);
    const double pitch = draw_real(draw, format);
    turn(f.v, f.w, pitch);
  }
  const std::uint64_t axis = draw.below(3);
  if (axis == 1) std::swap(f.u, f.w);
  if (axis == 2) std::swap(f.v, f.w);
  return f;
}

/// Half a rectangle, in coordinates of a frame: its corners are (±x, ±y, 0).
Triangle draw_half(Draw& draw, Format format) {
  const double x = draw_within(draw, format, 0.2, 1);
  const double y = draw_within(draw, format, 0.2, 1);
  const Triangle lower{{-x, -y, 0}, {x, -y, 0}, {x, y, 0}}, upper{{-x, -y, 0}, {x, y, 0}, {-x, y, 0}};
  return draw.below(2) == 0 ? lower : upper;
}

/// A point of its plane: inside, a tenth of its heights from its edges at least; or outside, beyond one edge or two.
Point3 draw_target(Draw& draw, Format format, const Triangle& t) {
  const bool inside = draw.below(2) == 0;
  const double b = draw_within(draw, format, 0.1, 0.45);
  const double c = draw_within(draw, format, 0.1, 0.45);
  const Point3 in = t.a + b * (t.b - t.a) + c * (t.c - t.a);
  if (inside) return in;
  const double far = draw_within(draw, format, 1.2, 2);
  const Point3& corner = draw.below(2) == 0 ? t.a : t.c;
  const bool over_an_edge = draw.below(2) == 0;
  return in + far * ((corner - in) + (over_an_edge ? t.b - in : Point3(0)));
}

/// From one side through the target to the other, straight on or at a slant; or up to some way before it.
Segment draw_segment(Draw& draw, Format format, const Point3& target) {
  const double height = draw_either_side(draw, format, 0.5, 2);
  Point3 up{0, 0, height};
  if (draw.below(2) == 0) {
    up.x = draw_either_side(draw, format, 0.2, 1);
    up.y = draw_either_side(draw, format, 0.2, 1);
  }
  const bool reaches = draw.below(4) != 0;
  const double beyond = reaches ? draw_within(draw, format, 0.3, 1) : draw_within(draw, format, -0.7, -0.3);
  return {target + up, target - beyond * up};
}

/// The segment, or the ray from its source towards its target, or one time in eight away from it; the direction may be
/// some times as long, or as short.
Probe probe_of(Draw& draw, bool is_ray, const Segment& s, Format format) {
  if (!is_ray) return s;
  const double scale = std::ldexp(1.0, static_cast<int>(draw.between(-2, 2)));
  const bool away = draw.below(8) == 0;
  return Ray{s.p, {in_format((away ? -scale : scale) * (s.q - s.p), format)}};
}

Trial draw_scene(Draw& draw, bool is_ray, std::size_t level, Format format) {
  const Frame frame = draw_frame(draw, format);
  Point3 centre;
  for (int axis = 0; axis < 3; ++axis) centre[axis] = draw_either_side(draw, format, 0.5, 4);
  const Triangle half = draw_half(draw, format);
  const Point3 target = draw_target(draw, format, half);
  const Segment s = draw_segment(draw, format, target);
  const auto place = [&](const Point3& x) { return in_format(lengths[level] * (centre + frame.at(x)), format); };
  const Triangle t{place(half.a), place(half.b), place(half.c)};
  return unclassified(format, level, probe_of(draw, is_ray, {place(s.p), place(s.q)}, format), t, draw);
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  constexpr int most_attempts = 1000;
  Draw draw(stream_of("family plain"), seed, k);
  const auto [is_ray, level] = turn_of(k, levels(format).size());
  for (int i = 0; i < most_attempts; ++i) {
    const Trial trial = draw_scene(draw, is_ray, level, format);
    if (is_everyday(trial.query)) return trial;
  }
  throw std::logic_error("no everyday scene in a thousand");
}

}  // namespace

/// A triangle of a wall, floor or box and a probe that passes it well inside, well outside, or ends well before it.
/// Drawn again where a coordinate is no everyday one; everything else holds by construction.
Family plain_family() {
  return {.name = "plain",
          .stresses = "nothing: everyday scenes, where no test may be wrong",
          .population = "halves of rectangles, upright and turned, probes well inside and well outside",
          .axis = "log10 of the size",
          .constructs = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
