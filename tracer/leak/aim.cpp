#include "tracer/leak/aim.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/cases/families/draw.h"
#include "exact/cases/families/ulp.h"
#include "exact/filtered/filtered.h"

namespace tribunal::leak {
namespace {

/// The point Σ wᵢ·vᵢ / Σ wᵢ that a ray is aimed at: a vertex, or a point of an edge or of a face.
struct Mark {
  Aim aim;
  std::uint32_t at;
  std::size_t count = 0;
  std::array<Point3, 3> points{};
  std::array<double, 3> weights{};

  void add(const Point3& p, double weight) {
    points[count] = p;
    weights[count++] = weight;
  }
  double weight() const { return weights[0] + weights[1] + weights[2]; }

  /// Σ wᵢ·(vᵢ − o), rounded: a direction from o to the mark.
  Point3 direction_from(const Point3& o) const {
    Point3 d(0);
    for (std::size_t i = 0; i < count; ++i) d += weights[i] * (points[i] - o);
    return d;
  }
};

Mark mark_of(const Surface& surface, std::uint64_t k, Draw& draw) {
  const Aim aim = all_aims[k % aim_count];
  const std::uint64_t turn = k / aim_count;
  const auto in_turn = [&](std::size_t count) { return static_cast<std::uint32_t>(turn % count); };
  if (aim == Aim::vertex) {
    Mark mark{aim, in_turn(surface.vertices().size())};
    mark.add(surface.vertices()[mark.at], 1);
    return mark;
  }
  if (aim == Aim::edge && !surface.edges().empty()) {
    Mark mark{aim, in_turn(surface.edges().size())};
    for (const std::uint32_t v : surface.edges()[mark.at]) {
      const std::uint64_t weight = draw.below(4) == 0 ? 3 : 1;
      mark.add(surface.vertices()[v], static_cast<double>(weight));
    }
    return mark;
  }
  Mark mark{Aim::face, in_turn(surface.face_count())};
  for (const std::uint32_t v : surface.corners(mark.at)) {
    const std::uint64_t weight = 1 + draw.below(8);
    mark.add(surface.vertices()[v], static_cast<double>(weight));
  }
  return mark;
}

/// Draws a number in [lo, hi], in steps of 1/1024 of the larger bound or, if `finely`, in the finest steps of the
/// format.
double draw_between(double lo, double hi, bool finely, Format format, Draw& draw) {
  const double share = std::ldexp(static_cast<double>(draw.below(std::uint64_t{1} << 53)), -53);
  const double x = lo + share * (hi - lo);
  const double most = std::max(std::abs(lo), std::abs(hi));
  if (finely || most == 0) return in_format(x, format);
  const double step = std::ldexp(1, std::ilogb(most) - 10);
  return in_format(std::round(x / step) * step, format);
}

/// The range of a coordinate of a source: around the surface's box, or in it.
struct Range {
  double lo, hi;
};

Range about(const Box& box, int axis, bool inside) {
  const double margin = inside ? 0 : (box.hi[axis] - box.lo[axis]) / 2;
  return {box.lo[axis] - margin, box.hi[axis] + margin};
}

/// The part of the range in which vᵢ − o needs no more bits than vᵢ, with room for the weights: the difference of a
/// number v and one of at most twice its size is no larger than v, and a multiple of its last bit.
Range with_exact_differences(Range range, const Mark& mark, int axis) {
  Range part = range;
  for (std::size_t i = 0; i < mark.count; ++i) {
    const double v = mark.points[i][axis], room = std::abs(v) / mark.weight();
    if (v == 0) continue;
    part = {std::max(part.lo, v - room), std::min(part.hi, v + room)};
  }
  return part.lo <= part.hi ? part : range;
}

/// From where a ray is to start, and whether its source is drawn so that the direction can be exact.
struct Start {
  bool inside, exactly;
  std::optional<int> distance{};  ///< log2 of how far the source is in sizes of the surface, if that is given
};

/// A point of the cube around the box's middle whose faces are that far from it.
Point3 draw_far_source(const Surface& surface, const Mark& mark, const Start& start, Draw& draw) {
  const Box& box = surface.bounds();
  const Point3 middle = box.lo / 2.0 + box.hi / 2.0, extent = box.hi - box.lo;
  const double far = std::ldexp(std::max({extent.x, extent.y, extent.z}), *start.distance);
  const int outward = static_cast<int>(draw.below(3));
  Point3 o;
  for (int axis = 0; axis < 3; ++axis) {
    const bool level = draw.below(8) == 0;
    o[axis] = draw_between(middle[axis] - far, middle[axis] + far, !start.exactly, surface.format(), draw);
    if (level) o[axis] = mark.points[0][axis];
  }
  const bool above = draw.below(2) == 0;
  o[outward] = in_format(middle[outward] + (above ? far : -far), surface.format());
  return o;
}

Point3 draw_source(const Surface& surface, const Mark& mark, const Start& start, Draw& draw) {
  if (start.distance) return draw_far_source(surface, mark, start, draw);
  Point3 o;
  for (int axis = 0; axis < 3; ++axis) {
    Range range = about(surface.bounds(), axis, start.inside);
    const bool level = draw.below(8) == 0;  // a direction that is 0 on this axis
    if (start.exactly) range = with_exact_differences(range, mark, axis);
    o[axis] = draw_between(range.lo, range.hi, !start.exactly, surface.format(), draw);
    if (level) o[axis] = mark.points[0][axis];
  }
  return o;
}

/// Whether the ray meets what it was aimed at.
bool is_on_mark(const Surface& surface, const Ray& ray, const Mark& mark) {
  if (mark.aim == Aim::face) return hits(ray, surface.triangle(mark.at));
  const bool is_vertex = mark.aim == Aim::vertex;
  const auto faces = is_vertex ? surface.faces_of_vertex(mark.at) : surface.faces_of_edge(mark.at);
  return intersect(ray, surface.triangle(faces[0])).contact == (is_vertex ? Contact::vertex : Contact::edge);
}

Ray ray_from(const Point3& o, const Mark& mark, Format format) {
  return {o, {in_format(mark.direction_from(o), format)}};
}

/// The best of several draws: a ray from the wanted side that meets its mark; else one from the wanted side; else
/// any.
std::optional<Ray> draw_ray(const Surface& surface, const Mark& mark, const Start& start, Draw& draw) {
  constexpr int attempts = 12;
  const Side wanted = start.inside ? Side::inside : Side::outside;
  std::optional<Ray> on_any_side, on_wanted_side;
  for (int i = 0; i < attempts; ++i) {
    const Ray ray = ray_from(draw_source(surface, mark, start, draw), mark, surface.format());
    if (!is_finite(ray) || ray.d.v == Point3(0)) continue;
    const Side side = surface.tree().inside(ray.o);
    if (side == Side::boundary) continue;
    on_any_side = ray;
    if (side != wanted) continue;
    if (!start.exactly || is_on_mark(surface, ray, mark)) return ray;
    on_wanted_side = ray;
  }
  return on_wanted_side ? on_wanted_side : on_any_side;
}

/// Multiplies the direction by a power of two, if the result is exact in the format.
void scale(Direction& d, Format format, Draw& draw) {
  const double factor = std::ldexp(1, static_cast<int>(draw.between(-8, 8)));
  const Point3 scaled = d.v * factor;
  if (is_finite(scaled) && is_exact_in(scaled, format) && scaled / factor == d.v) d.v = scaled;
}

/// Moves one coordinate of the ray by a few units in its last place, most often by one.
void nudge(Ray& ray, Format format, Draw& draw) {
  constexpr std::int64_t ulps[] = {1, 1, 1, 2, 3, 8};
  const bool of_source = draw.below(3) == 0;
  const int axis = static_cast<int>(draw.below(3));
  const std::int64_t n = ulps[draw.below(std::size(ulps))];
  const bool up = draw.below(2) == 0;
  double& x = of_source ? ray.o[axis] : ray.d.v[axis];
  if (x == 0) return;  // its neighbours are subnormal: another scale, not another place
  x = moved_by_ulps(x, up ? n : -n, format);
}

/// A ray at the mark, with a direction of any size, moved off the mark if `nudged`.
std::optional<AimedRay> aimed_at(const Mark& mark, const Surface& surface, const Start& start, bool nudged,
                                 Draw& draw) {
  std::optional<Ray> ray = draw_ray(surface, mark, start, draw);
  if (!ray) return std::nullopt;
  scale(ray->d, surface.format(), draw);
  if (nudged) nudge(*ray, surface.format(), draw);
  return AimedRay{*ray, mark.aim, mark.at};
}

}  // namespace

std::optional<AimedRay> aimed_ray(const Surface& surface, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("leak rays"), seed, k);
  const Mark mark = mark_of(surface, k, draw);
  const bool inside = draw.below(2) == 0 && surface.topology().closed();
  const bool exactly = draw.below(2) == 0;
  const bool nudged = draw.below(2) == 0;
  return aimed_at(mark, surface, {inside, exactly}, nudged, draw);
}

std::optional<AimedRay> aimed_ray_from_afar(const Surface& surface, int distance, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("sweep afar"), seed, std::uint64_t{static_cast<std::uint32_t>(distance)} << 32 | k);
  const Mark mark = mark_of(surface, k, draw);
  const bool exactly = draw.below(2) == 0;
  const bool nudged = draw.below(2) == 0;
  return aimed_at(mark, surface, {.inside = false, .exactly = exactly, .distance = distance}, nudged, draw);
}

}  // namespace tribunal::leak
