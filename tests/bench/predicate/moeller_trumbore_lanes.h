// Möller–Trumbore on vector lanes, on the same arithmetic as the certified batch: no branches, one division.
// Source: Möller & Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", Journal of Graphics Tools 2(1), 1997.
#pragma once

#include "core/products.h"
#include "exact/filtered/batch/lanes.h"
#include "tests/bench/predicate/peers.h"

namespace tribunal::HWY_NAMESPACE {

template <bool is_ray>
LaneMask meets(const Vec3<Lanes>& p, const Vec3<Lanes>& d, const Vec3<Lanes>& a, const Vec3<Lanes>& b,
               const Vec3<Lanes>& c) {
  const Lanes zero(0.0), one(1.0);
  const Vec3<Lanes> e1 = b - a, e2 = c - a, tvec = p - a;
  const Vec3<Lanes> pvec = cross(d, e2), qvec = cross(tvec, e1);
  const Lanes inverse = one / dot(e1, pvec);
  const Lanes u = dot(tvec, pvec) * inverse;
  const Lanes v = dot(d, qvec) * inverse;
  const Lanes at = dot(e2, qvec) * inverse;
  const LaneMask ahead = (u >= zero) & (v >= zero) & (u + v <= one) & (at >= zero);
  return is_ray ? ahead : ahead & (at <= one);
}

template <bool is_ray, bool one_against_many>
[[gnu::flatten]] void moeller_trumbore_columns(const double* const* columns, std::size_t n, std::uint8_t* hit) {
  Vec3<Lanes> p = broadcast(columns), d = is_ray ? broadcast(columns + 3) : broadcast(columns + 3) - p;
  for (std::size_t i = 0; i < n; i += HWY_LANES(double)) {
    if constexpr (!one_against_many) {
      p = load(columns, i);
      d = is_ray ? load(columns + 3, i) : load(columns + 3, i) - p;
    }
    store_bytes(meets<is_ray>(p, d, load(columns + 6, i), load(columns + 9, i), load(columns + 12, i)).bits(), hit + i);
  }
}

}  // namespace tribunal::HWY_NAMESPACE
