// What a published test is written in: its triangle, its hit, and the few things that number types do differently.
// A rival is a template on the number type N: float, double, or an exact type, on which its exact twin runs.
#pragma once

#include <cmath>
#include <optional>
#include <type_traits>

#include "core/contract.h"
#include "core/longest_axis.h"
#include "core/operands.h"
#include "core/products.h"

namespace tribunal::published {

/// The weights of b and c in the point (1 − b − c)·a + b·b + c·c of a triangle a b c.
template <class N>
struct Weights {
  N b, c;
};

/// Where a line origin + t·direction meets a triangle; without weights if the test computes none.
template <class N>
struct RivalHit {
  N t;
  std::optional<Weights<N>> weights{};
};

/// The vertices of a triangle, which is all that a test without preparation keeps.
template <class N>
struct Corners {
  Vec3<N> a, b, c;
};

template <class N>
Corners<N> corners_of(const Triangle& t) {
  return {lift<N>(t.a), lift<N>(t.b), lift<N>(t.c)};
}

/// b − a, c − a and their cross product.
template <class N>
struct Plane {
  Vec3<N> ab, ac, normal;
};

template <class N>
Plane<N> plane_of(const Corners<N>& t) {
  const Vec3<N> ab = t.b - t.a;
  const Vec3<N> ac = t.c - t.a;
  return {ab, ac, cross(ab, ac)};
}

template <class N>
N absolute(const N& x) {
  if (x < 0) return -x;
  return x;
}

/// Whether the sign bit of x is set: where published code compares sign bits, −0 counts as negative. Exact types have
/// one zero, which does not. The sign bit of a NaN depends on the order in which a compiler multiplies, so it counts as
/// positive: a test must answer the same in every loop that it is compiled into.
template <class N>
bool sign_bit(const N& x) {
  if constexpr (std::is_floating_point_v<N>) {
    return std::signbit(x) && x <= 0;
  } else {
    return x < 0;
  }
}

/// factor · v.
template <class N>
Vec3<N> scaled(const Vec3<N>& v, const N& factor) {
  return {v.x * factor, v.y * factor, v.z * factor};
}

/// The point o + t·d.
template <class N>
Vec3<N> point_at(const Vec3<N>& o, const Vec3<N>& d, const N& t) {
  return {o.x + t * d.x, o.y + t * d.y, o.z + t * d.z};
}

/// What people want to know of a rival.
struct RivalCard {
  const char* summary;
  const char* reference;
};

}  // namespace tribunal::published
