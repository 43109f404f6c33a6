// The filter of a ray with bounds: whether the part tmin ≤ t ≤ tmax certainly meets a triangle.
//
// The point o + t·d lies on the side of the plane that V(o) + t·V(d) tells, where V are volumes over the triangle: det
// of its arms u, v and of o − a or d. Both are computed with the sums of their terms' magnitudes (term_filter.h), so
// the sum is off by 10 units of its own sum of terms at most: 8 in each volume, the product with t and the addition.
// Proved: within.g, and within_range.g for underflow and overflow; 11 are taken.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "exact/filtered/shared_volumes.h"
#include "exact/filtered/term_filter.h"

namespace tribunal::detail {

/// The sign of height + t·gain, if certain; nothing otherwise. t ≥ 0.
template <class N>
std::optional<Sign> filter_side(const Expansion<N>& height, const Expansion<N>& gain, const N& t,
                                const FilterConstants<N>& c) {
  const N value = height.value + N(t * gain.value);
  const N terms = height.terms + N(t * gain.terms);
  return sign_beyond<N>(value, N(c.k * terms) + c.tiny);
}

/// Whether t is 0, or within the range that the filter's constants allow for. By its bits: a subnormal number, which
/// the thread may read as zero, is not 0.
inline bool is_in_side_range(double t) {
  return (t >= 0x1p-150 && t <= 0x1p150) || (std::bit_cast<std::uint64_t>(t) << 1) == 0;
}

/// The sides of a triangle's plane along a ray.
class SidesAlongRay {
 public:
  SidesAlongRay(const Ray& r, const Triangle& t) {
    const Vec3<double> a = lift<double>(t.a), u = arm<double>(a, t.b), v = arm<double>(a, t.c);
    const Vec3<double> w = arm<double>(a, r.o), d = lift<double>(r.d.v);
    in_range_ = in_range(largest(u, v, w, d), side_terms_filter);
    const Minors<double> minors = minors_of(u, v);
    height_ = expanded(minors, w);
    gain_ = expanded(minors, d);
  }

  /// The side of o + t·d; nothing where rounding could matter.
  std::optional<Sign> at(double t) const {
    if (!in_range_ || !is_in_side_range(t)) return std::nullopt;
    return filter_side(height_, gain_, t, side_terms_filter);
  }

  /// The side to which the ray runs, or, for a finite t, that of o + t·d.
  std::optional<Sign> at_end(double tmax) const {
    if (std::isfinite(tmax)) return at(tmax);
    if (!in_range_) return std::nullopt;
    return sign_of(gain_, volume_terms_filter);
  }

 private:
  Expansion<double> height_{}, gain_{};
  bool in_range_ = false;
};

/// Whether the line of the ray certainly passes all edges on one side, or certainly two on different sides.
inline std::optional<bool> filter_line_crosses(const Ray& r, const Triangle& t) {
  const Vec3<double> o = lift<double>(r.o), d = lift<double>(r.d.v);
  const Vec3<double> corner[] = {lift<double>(t.a), lift<double>(t.b), lift<double>(t.c)};
  std::optional<Sign> passed;
  bool all = true;
  for (int i = 0; i < 3; ++i) {
    const Vec3<double>&a = corner[i], &b = corner[(i + 1) % 3];
    const auto side = filter_terms(a - o, b - a, d, volume_terms_filter);
    if (side && passed && *side != *passed) return false;
    if (side) passed = side;
    all &= side.has_value();
  }
  return all ? std::optional(true) : std::nullopt;
}

/// Whether the part of the ray certainly meets or certainly misses the triangle; nothing where rounding could matter.
///
/// A miss where the whole ray misses (shared_volumes.h), or both ends of the part lie strictly on one side of the
/// plane, or the line passes two edges on different sides. A hit where the ends lie strictly on different sides and the
/// line passes the edges on one: then the plane is crossed between the ends, inside the triangle. All bounds must be
/// numbers.
inline std::optional<bool> filter_hits_within(const Ray& r, const Bounds& bounds, const Triangle& t) {
  const auto whole = conclude<Ray>(arms_of<double>(r, t), pair_filter<Ray>);
  if (whole.miss) return false;
  const SidesAlongRay sides(r, t);
  const std::optional<Sign> from = sides.at(bounds.tmin), to = sides.at_end(bounds.tmax);
  if (from && to && *from == *to) return false;
  const std::optional<bool> crosses = whole.hit ? std::optional(true) : filter_line_crosses(r, t);
  if (crosses == false) return false;
  return crosses && from && to ? std::optional(true) : std::nullopt;
}

}  // namespace tribunal::detail
