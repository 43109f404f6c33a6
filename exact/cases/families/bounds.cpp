// Rays with bounds: tmin and tmax at the parameter of the hit, ulps from it, or far from it.
#include "exact/cases/families/bounds.h"

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "exact/cases/families/probe.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"
#include "exact/cases/families/ulp.h"
#include "exact/filtered/filtered_kernel.h"
#include "exact/filtered/rounded_parameter.h"

namespace tribunal {
namespace {

constexpr int steps[] = {0, 1, 2, 8, 64, 1024, 1 << 20};
constexpr double infinity = std::numeric_limits<double>::infinity();

std::span<const int> levels(Format) { return steps; }

double dot(const Point3& u, const Point3& v) { return u.x * v.x + u.y * v.y + u.z * v.z; }

/// Three draws of the coordinates −1, 0, 1, 2.
Point3 draw_grid_point(Draw& draw) {
  Point3 p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = static_cast<double>(draw.between(-1, 2));
  return p;
}

Trial draw_on_grid(Format format, std::size_t level, Draw& draw) {
  Triangle t;
  t.a = draw_grid_point(draw);
  t.b = draw_grid_point(draw);
  t.c = draw_grid_point(draw);
  const Point3 o = draw_grid_point(draw);
  const Point3 d = draw_grid_point(draw);
  return unclassified(format, level, Ray{o, {d}}, t, draw);
}

/// The families whose rays get bounds. They draw under another seed than for themselves.
const auto& families_of_rays() {
  static const std::array table = {affine_family(), affine_family(),  affine_family(),    plain_family(),
                                   ulp_family(),    near_family(),    tilt_family(),      grazing_family(),
                                   spread_family(), extreme_family(), direction_family(), size_family()};
  return table;
}

/// A case of a ray, of one of the families or on a small grid.
Trial draw_ray_case(Format format, std::uint64_t seed, std::size_t level, Draw& draw) {
  constexpr int most_attempts = 1000;
  constexpr std::uint64_t other_seed = 0x62f3a0d41b95c87e, cases = std::uint64_t{1} << 40;
  if (draw.below(4) == 0) return draw_on_grid(format, level, draw);
  const Family& family = families_of_rays()[draw.below(families_of_rays().size())];
  for (int i = 0; i < most_attempts; ++i) {
    Trial trial = family.make(format, seed ^ other_seed, draw.below(cases));
    if (is_of_ray(trial.query)) return trial;
  }
  throw std::logic_error("a family without rays");
}

/// A bound in the range that bounds have, in the format.
double admitted(double t, Format format) {
  if (!(t >= 0)) return 0;
  return in_format(std::fmin(t, format == Format::binary32 ? 0x1.fffffep127 : 0x1.fffffffffffffp1023), format);
}

double draw_integer(Draw& draw) { return static_cast<double>(draw.below(4)); }

/// 0, the least and the largest numbers of the format, or any power of two between.
double draw_any(Format format, Draw& draw) {
  const auto e = static_cast<int>(draw.between(least_exponent(format), largest_exponent(format)));
  const std::uint64_t which = draw.below(4);
  if (which == 0) return 0;
  if (which == 1) return std::ldexp(1.0, least_exponent(format));
  return which == 2 ? admitted(infinity, format) : std::ldexp(1.0, e);
}

/// Bounds of which one or both are at the parameter t, or which t lies well between, before or beyond.
Bounds draw_around(double t, Format format, Draw& draw) {
  switch (draw.below(8)) {
    case 0:
      return {t, infinity};
    case 1:
      return {0, t};
    case 2:
      return {t, t};
    case 3:
      return {t / 4, t};
    case 4:
      return {t, 2 * t + 1};
    case 5:
      return {t / 2, 2 * t};
    case 6:
      return draw.below(2) == 0 ? Bounds{2 * t, infinity} : Bounds{0, t / 2};
    default:
      break;
  }
  const double other = draw_any(format, draw);
  return other < t ? Bounds{other, t} : Bounds{t, other};
}

Bounds draw_unaimed(Format format, Draw& draw) {
  const bool small = draw.below(2) == 0;
  const double x = small ? draw_integer(draw) : draw_any(format, draw);
  const double y = small ? draw_integer(draw) : draw_any(format, draw);
  return draw.below(4) == 0 ? Bounds{x, infinity} : Bounds{std::fmin(x, y), std::fmax(x, y)};
}

Bounds draw_bounds(const Query& query, Format format, int most_ulps, Draw& draw) {
  const double aim = draw_parameter(std::get<Ray>(query.probe), query.triangle(), format, draw);
  const std::int64_t by = draw.between(-1, 1) * most_ulps;
  if (draw.below(8) == 0 || std::isnan(aim)) return draw_unaimed(format, draw);
  const double t = admitted(aim, format);
  Bounds bounds = draw_around(admitted(moved_by_ulps(t, by, format), format), format, draw);
  bounds.tmin = admitted(bounds.tmin, format);
  if (std::isfinite(bounds.tmax)) bounds.tmax = std::fmax(bounds.tmin, admitted(bounds.tmax, format));
  return bounds;
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family bounds"), seed, k);
  const std::size_t level = k % levels(format).size();
  Trial trial = draw_ray_case(format, seed, level, draw);
  trial.query.bounds = draw_bounds(trial.query, format, steps[level], draw);
  trial.class_id = 0;
  trial.level = static_cast<std::uint16_t>(level);
  return trial;
}

}  // namespace

double draw_parameter(const Ray& r, const Triangle& t, Format format, Draw& draw) {
  const std::uint64_t which = draw.below(3);
  if (FilteredKernel().orient3d(t.a, t.b, t.c, r.d) != Sign::zero) return in_format(rounded_parameter(r, t), format);
  const Point3& v = which == 0 ? t.a : which == 1 ? t.b : t.c;
  return in_format(dot(v - r.o, r.d.v) / dot(r.d.v, r.d.v), format);
}

/// A ray of another family, or with coordinates −1 to 2, with bounds at its hit, moved by the level's ulps or not; or
/// zero, equal, infinite, far before or beyond, of any size.
Family bounds_family() {
  return {.name = "bounds",
          .stresses = "rays with bounds on t: tmin and tmax at the hit, ulps from it, zero, equal, infinite",
          .population = "rays of other families and of a small grid, with bounds aimed at where they hit",
          .axis = "units in the last place between a bound and the hit",
          .constructs = false,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
