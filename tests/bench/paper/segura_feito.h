// The paper's test in double as a careful programmer writes it: signs of volumes with shared products, the cheapest
// rejection first, no point. `core/segura_feito.h` is the same test for any kernel, with every kind of contact.
#pragma once

#include <optional>

#include "core/rivals/rival.h"

namespace tribunal::bench {

/// Sources: Segura & Feito, "An algorithm for determining intersection segment-polygon in 3D", Computers & Graphics
/// 22(5), 1998, and "Algorithms to test ray-triangle intersection. Comparative study", WSCG 2001: the ends on
/// different sides of the plane, then the signs of the volumes of the segment with each edge. A segment in the plane is
/// a miss, as in the paper's figure 1.
struct TunedSeguraFeito {
  using Prepared = published::Corners<double>;

  static Prepared prepare(const Prepared& corners) { return corners; }

  static std::optional<double> meet(const Vec3<double>& p, const Vec3<double>& q, const Prepared& t) {
    return past_plane(p, q, t, cross(t.b - t.a, t.c - t.a));
  }

  /// With a normal of the plane that is known.
  static std::optional<double> past_plane(const Vec3<double>& p, const Vec3<double>& q, const Prepared& t,
                                          const Vec3<double>& normal) {
    const Vec3<double> a = t.a - p;
    const double at_p = -dot(normal, a), at_q = dot(normal, q - t.a);
    if ((at_p > 0 && at_q > 0) || (at_p < 0 && at_q < 0) || (at_p == 0 && at_q == 0)) return std::nullopt;
    const Vec3<double> d = q - p, b = t.b - p, c = t.c - p;
    const bool rising = at_p < at_q;
    const Vec3<double> da = cross(d, a);
    const double ab = dot(da, b), ca = -dot(da, c);
    if (rising ? ab < 0 || ca < 0 : ab > 0 || ca > 0) return std::nullopt;
    const double bc = dot(cross(d, b), c);
    if (rising ? bc < 0 : bc > 0) return std::nullopt;
    return at_p / (at_p - at_q);
  }
};

/// The same with the normal kept of each triangle.
struct PreparedSeguraFeito {
  struct Prepared {
    published::Corners<double> corners;
    Vec3<double> normal;
  };

  static Prepared prepare(const published::Corners<double>& t) { return {t, cross(t.b - t.a, t.c - t.a)}; }

  static std::optional<double> meet(const Vec3<double>& p, const Vec3<double>& q, const Prepared& t) {
    return TunedSeguraFeito::past_plane(p, q, t.corners, t.normal);
  }
};

}  // namespace tribunal::bench
