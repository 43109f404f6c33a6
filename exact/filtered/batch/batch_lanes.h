// The filter of shared_volumes.h on vector lanes. Included by files that are compiled for one instruction set each.
#pragma once

#include <bit>

#include "exact/filtered/batch/batch_target.h"
#include "exact/filtered/batch/lanes.h"
#include "exact/filtered/shared_volumes.h"

namespace tribunal::HWY_NAMESPACE {

template <class P>
Arms<Lanes> arms_of_lanes(const Vec3<Lanes>& source, const Vec3<Lanes>& target, const LiftedTriangle<Lanes>& t) {
  if constexpr (std::is_same_v<P, Segment>) {
    return segment_arms<Lanes>(source, target, t);
  } else {
    return ray_arms<Lanes>(source, target, t);
  }
}

template <class P, bool one_against_many>
[[gnu::flatten]] std::size_t filter_pairs(const double* const* columns, std::size_t n, std::uint8_t* hit,
                                          std::uint32_t* undecided) {
  const PairConstants<Lanes> c = in_lanes(pair_filter<P>);
  constexpr std::size_t step = HWY_LANES(double);
  constexpr unsigned all = (1U << step) - 1;
  Vec3<Lanes> source = broadcast(columns), target = broadcast(columns + 3);
  std::size_t left = 0;
  for (std::size_t i = 0; i < n; i += step) {
    if constexpr (!one_against_many) {
      source = load(columns, i);
      target = load(columns + 3, i);
    }
    const LiftedTriangle<Lanes> t{load(columns + 6, i), load(columns + 9, i), load(columns + 12, i)};
    const auto certain = conclude<P>(arms_of_lanes<P>(source, target, t), c);
    const unsigned hits = certain.hit.bits();
    store_bytes(hits, hit + i);
    for (unsigned rest = all & ~(hits | certain.miss.bits()); rest != 0; rest &= rest - 1) {
      undecided[left++] = static_cast<std::uint32_t>(i) + static_cast<std::uint32_t>(std::countr_zero(rest));
    }
  }
  return left;
}

inline constexpr BatchTarget target_named(const char* name, bool (*runs_here)()) {
  return {name,
          runs_here,
          HWY_LANES(double),
          filter_pairs<Segment, true>,
          filter_pairs<Ray, true>,
          filter_pairs<Segment, false>,
          filter_pairs<Ray, false>};
}

}  // namespace tribunal::HWY_NAMESPACE
