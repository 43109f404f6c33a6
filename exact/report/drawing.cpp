#include "exact/report/drawing.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "exact/base/json.h"

namespace tribunal {
namespace {

constexpr double width = 120, height = 90, margin = 14;
constexpr double hair = 1e-9;  ///< far above what rounds here, far below any length of a representative

using V = Point3;

V unit(const V& a) { return a / length(a); }

/// The probe as p + t·u, t in [0, last].
struct Line {
  V p, u;
  double last;

  V at(double t) const { return p + t * u; }
};

/// The parameter of the point of a line nearest to x.
double nearest(const V& x, const V& p, const V& u) { return dot(u, u) > 0 ? dot(x - p, u) / dot(u, u) : 0; }

double distance_to_edge(const V& x, const V& a, const V& b) {
  return length(x - (a + std::clamp(nearest(x, a, b - a), 0.0, 1.0) * (b - a)));
}

using Corners = std::array<V, 3>;

double distance_to_edges(const V& x, const Corners& t) {
  return std::min({distance_to_edge(x, t[0], t[1]), distance_to_edge(x, t[1], t[2]), distance_to_edge(x, t[2], t[0])});
}

V normal_of(const Corners& t) { return cross(t[1] - t[0], t[2] - t[0]); }

/// Whether x, up to a hair, lies in the triangle, which may have no area.
bool is_in(const V& x, const Corners& t) {
  if (distance_to_edges(x, t) < hair) return true;
  const V n = normal_of(t);
  if (length(n) < hair || std::abs(dot(x - t[0], n)) > hair) return false;
  for (int i = 0; i < 3; ++i) {
    const V& a = t[static_cast<std::size_t>(i)];
    if (dot(cross(t[static_cast<std::size_t>((i + 1) % 3)] - a, x - a), n) < 0) return false;
  }
  return true;
}

/// Parameters at which the probe's line meets the triangle's plane, comes nearest to an edge's line or to a vertex:
/// what the probe and the triangle have in common begins and ends at some of these, or at an end of the probe.
std::vector<double> candidates(const Line& probe, const Corners& t) {
  std::vector<double> all{0};
  if (std::isfinite(probe.last)) all.push_back(probe.last);
  const V n = normal_of(t);
  if (const double slope = dot(probe.u, n); std::abs(slope) > hair) all.push_back(dot(t[0] - probe.p, n) / slope);
  for (std::size_t i = 0; i < 3; ++i) {
    all.push_back(nearest(t[i], probe.p, probe.u));
    const V e = t[(i + 1) % 3] - t[i], between = cross(probe.u, e);
    if (dot(between, between) > hair) all.push_back(dot(cross(t[i] - probe.p, e), between) / dot(between, between));
  }
  return all;
}

struct Range {
  double low, high;
};

/// The parameters of what the probe and the triangle have in common.
std::optional<Range> common(const Line& probe, const Corners& t) {
  std::optional<Range> range;
  for (const double x : candidates(probe, t)) {
    if (x < -hair || x > probe.last + hair || !is_in(probe.at(x), t)) continue;
    range = range ? Range{std::min(range->low, x), std::max(range->high, x)} : Range{x, x};
  }
  return range;
}

// --- where to look from ------------------------------------------------------------------------------------------

/// Axes of a picture: to the right, upward, and towards the eye.
struct View {
  V right, up, eye;

  V flat(const V& x) const { return {dot(x, right), dot(x, up), 0}; }
  double depth(const V& x) const { return dot(x, eye); }
};

View view_from(const V& eye, const V& upward) {
  const V right = unit(cross(upward, eye));
  return {right, unit(cross(eye, right)), unit(eye)};
}

/// What is drawn: the triangle's corners, the ends of the drawn probe, and what they have in common.
struct Solid {
  Corners t;
  V p, q;
  Line probe;
  std::optional<Range> range;
};

bool same(const V& a, const V& b) { return length(a - b) < hair; }

/// How well things that differ in space can be told apart in a view: the least distance, in the picture, of two points
/// that differ and of a point from an edge on which it does not lie, as a share of the picture's size.
double clarity(const Solid& s, const View& view) {
  const Corners t{view.flat(s.t[0]), view.flat(s.t[1]), view.flat(s.t[2])};
  std::vector<V> points{s.t[0], s.t[1], s.t[2], s.p, s.q};
  if (s.range) points.push_back(s.probe.at(s.range->low));
  double least = 1e9, size = 0;
  for (const V& x : points) {
    for (const V& y : points) {
      if (same(x, y)) continue;
      least = std::min(least, length(view.flat(x - y)));
      size = std::max(size, length(view.flat(x - y)));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const V &a = s.t[i], &b = s.t[(i + 1) % 3];
      if (!same(a, b) && distance_to_edge(x, a, b) > hair)
        least = std::min(least, distance_to_edge(view.flat(x), t[i], t[(i + 1) % 3]));
    }
    if (!same(s.p, s.q) && distance_to_edge(x, s.p, s.q) > hair)
      least = std::min(least, distance_to_edge(view.flat(x), view.flat(s.p), view.flat(s.q)));
  }
  const Line flat{view.flat(s.p), view.flat(s.q - s.p), 1};
  const bool looks_like_a_hit = common(flat, t).has_value();
  return (least / size) * (s.range || !looks_like_a_hit ? 1.5 : 1);
}

/// The clearest of some hundred views from above.
View clearest(const Solid& s) {
  const V z{0, 0, 1};
  View best = view_from({1, -2, 1.2}, z);
  double most = clarity(s, best);
  for (int i = 0; i < 24; ++i) {
    for (const double rise : {0.35, 0.7, 1.05}) {
      const double turn = (i + 0.31) * std::numbers::pi / 12;
      const View view = view_from({std::cos(turn), std::sin(turn), rise}, z);
      if (const double c = clarity(s, view); c > most * 1.02) {
        best = view;
        most = c;
      }
    }
  }
  return best;
}

/// Straight on the plane in which all points lie.
View onto_plane(const Solid& s) {
  V n = normal_of(s.t);
  for (const V& x : {s.t[0], s.t[1], s.t[2]}) {
    for (const V& y : {s.t[0], s.t[1], s.t[2], s.p}) {
      if (length(n) < hair) n = cross(s.q - s.p, x - s.p);
      if (length(n) < hair) n = cross(s.t[1] - s.t[0], y - s.t[0]);
      if (length(n) < hair) n = cross(s.t[2] - s.t[0], y - s.t[0]);
    }
  }
  if (length(n) < hair) n = {0, 0, 1};
  const V upward = std::abs(n.x) + std::abs(n.y) < hair ? V{0, 1, 0} : V{0, 0, 1};
  return view_from(n, upward);
}

/// Along a line on which all points lie, from the side.
View beside_line(const Solid& s) {
  V u = s.q - s.p;
  for (const V& x : s.t) {
    if (length(u) < hair) u = x - s.p;
  }
  for (const V& x : s.t) {
    if (length(u) < hair) u = x - s.t[0];
  }
  if (length(u) < hair) u = {1, 0, 0};
  const V aside = std::abs(u.x) + std::abs(u.y) < hair ? V{1, 0, 0} : V{0, 0, 1};
  const V eye = unit(cross(u, aside));
  return {unit(u), unit(cross(eye, unit(u))), eye};
}

// --- the picture -------------------------------------------------------------------------------------------------

/// Moves and scales flat points into the picture.
struct Frame {
  double scale, x, y;

  Spot spot(const V& flat) const { return {x + scale * flat.x, y - scale * flat.y}; }
};

Frame frame_of(const std::vector<V>& flat) {
  const auto [left, right] = std::ranges::minmax(flat, {}, &V::x);
  const auto [low, high] = std::ranges::minmax(flat, {}, &V::y);
  const double across = right.x - left.x, upward = high.y - low.y;
  const double scale = std::min(across > hair ? (width - 2 * margin) / across : 1e9,
                                upward > hair ? (height - 2 * margin) / upward : 1e9);
  const double used = scale < 1e8 ? scale : 1;
  return {used, width / 2 - used * (left.x + right.x) / 2, height / 2 + used * (low.y + high.y) / 2};
}

/// The part of the probe that the triangle hides: inside it in the picture, and behind its plane.
std::optional<Range> hidden_part(const Solid& s, const View& view) {
  const Corners flat{view.flat(s.t[0]), view.flat(s.t[1]), view.flat(s.t[2])};
  const V n = normal_of(s.t);
  const double towards = dot(n, view.eye);
  if (length(n) < hair || std::abs(towards) < hair) return std::nullopt;
  const std::optional<Range> inside = common({view.flat(s.p), view.flat(s.q - s.p), 1}, flat);
  if (!inside) return std::nullopt;
  const auto height_above = [&](double t) { return dot(s.p + t * (s.q - s.p) - s.t[0], n) / towards; };
  const double low = height_above(inside->low), high = height_above(inside->high);
  if (low > -hair && high > -hair) return std::nullopt;
  const double cut =
      std::abs(high - low) < hair ? inside->low : inside->low + (inside->high - inside->low) * low / (low - high);
  if (low > hair) return Range{cut, inside->high};
  if (high > hair) return Range{inside->low, cut};
  return inside;
}

void add_dot(std::vector<Dot>& dots, const Spot& at, char name) {
  for (Dot& d : dots) {
    if (std::hypot(d.at.x - at.x, d.at.y - at.y) > 0.5) continue;
    d.names += name;
    return;
  }
  dots.push_back({at, std::string(1, name)});
}

Line probe_of(const ClassRow& row) {
  if (is_ray_class(row.id)) {
    const Ray r = row.representative_ray();
    return {r.o, r.d.v, std::numeric_limits<double>::infinity()};
  }
  const Segment s = row.representative_segment();
  return {s.p, s.q - s.p, 1};
}

Solid solid_of(const ClassRow& row) {
  const Triangle t = row.representative_triangle();
  Solid s{{t.a, t.b, t.c}, {}, {}, probe_of(row), {}};
  s.range = common(s.probe, s.t);
  const double end = std::isfinite(s.probe.last) ? 1 : std::max(1.0, s.range ? 1.4 * s.range->high : 0.0);
  s.p = s.probe.p;
  s.q = s.probe.at(end);
  return s;
}

}  // namespace

Drawing drawing_of(const ClassRow& row) {
  const Solid s = solid_of(row);
  const View view = row.rank == 4 ? clearest(s) : row.rank == 3 ? onto_plane(s) : beside_line(s);
  Drawing d;
  d.apart = row.rank <= 2;
  d.arrow = is_ray_class(row.id) && length(s.probe.u) > 0;
  std::vector<V> flat;
  for (const V& x : {s.t[0], s.t[1], s.t[2], s.p, s.q}) flat.push_back(view.flat(x));
  const Frame frame = frame_of(flat);
  const double aside = d.apart ? 9 : 0;
  const auto moved = [&](const V& x, double by) {
    const Spot at = frame.spot(view.flat(x));
    return Spot{at.x, at.y + by};
  };
  const auto on_probe = [&](const V& x) { return moved(x, aside); };
  for (std::size_t i = 0; i < 3; ++i) {
    d.triangle[i] = moved(s.t[i], -aside);
    add_dot(d.dots, d.triangle[i], "abc"[i]);
  }
  d.probe = {on_probe(s.p), on_probe(s.q)};
  add_dot(d.dots, d.probe.from, d.arrow || is_ray_class(row.id) ? 'o' : 'p');
  if (!is_ray_class(row.id)) add_dot(d.dots, d.probe.to, 'q');
  if (s.range) d.meet = {on_probe(s.probe.at(s.range->low)), on_probe(s.probe.at(s.range->high))};
  if (const auto part = row.rank == 4 ? hidden_part(s, view) : std::nullopt) {
    d.hidden = {on_probe(s.p + part->low * (s.q - s.p)), on_probe(s.p + part->high * (s.q - s.p))};
  }
  return d;
}

namespace {

/// To a tenth of a unit, which no eye can tell from it.
Json to_json(const Spot& s) { return {std::round(s.x * 10) / 10, std::round(s.y * 10) / 10}; }

Json to_json(const Stroke& s) { return {to_json(s.from), to_json(s.to)}; }

/// A point rather than a stroke without length.
Json short_form(const Stroke& s) {
  const Json both = to_json(s);
  return both[0] == both[1] ? Json::array({both[0]}) : both;
}

}  // namespace

Json to_json(const Drawing& d) {
  Json dots = Json::array();
  for (const Dot& one : d.dots) {
    const Json at = to_json(one.at);
    dots.push_back({{"x", at[0]}, {"y", at[1]}, {"of", one.names}});
  }
  return {{"tri", {to_json(d.triangle[0]), to_json(d.triangle[1]), to_json(d.triangle[2])}},
          {"probe", to_json(d.probe)},
          {"arrow", d.arrow},
          {"apart", d.apart},
          {"dots", dots},
          {"meet", d.meet ? short_form(*d.meet) : Json()},
          {"hidden", d.hidden ? to_json(*d.hidden) : Json()}};
}

}  // namespace tribunal
