// Points as they arrive (binary64 triples) and vectors over any number type.
#pragma once

#include <glm/vec3.hpp>

namespace tribunal {

/// A point with binary64 coordinates, taken as the exact rational numbers they are. Unit-free.
using Point3 = glm::dvec3;

/// A direction: the point at infinity that a ray runs to. Need not be normalised; may be zero.
struct Direction {
  Point3 v;
};

/// A coordinate axis. Dropping it projects space onto the plane of the other two.
enum class Axis : int { x = 0, y = 1, z = 2 };

inline constexpr Axis all_axes[3] = {Axis::x, Axis::y, Axis::z};

/// A vector over the number type N. GLM's vectors hold their members in unions, which only floating
/// types survive; this one carries exact number types too.
template <class N>
struct Vec3 {
  N x, y, z;

  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {N(a.x - b.x), N(a.y - b.y), N(a.z - b.z)}; }
};

/// The point in number type N: exact for binary64 and every exact type, rounded to nearest for binary32.
template <class N>
Vec3<N> lift(const Point3& p) {
  return {static_cast<N>(p.x), static_cast<N>(p.y), static_cast<N>(p.z)};
}

/// The arm from o to a point, and to a point at infinity (where o no longer matters).
template <class N>
Vec3<N> arm(const Vec3<N>& o, const Point3& p) {
  return lift<N>(p) - o;
}

template <class N>
Vec3<N> arm(const Vec3<N>&, const Direction& d) {
  return lift<N>(d.v);
}

/// The vector with one coordinate dropped, the other two in cyclic order: x → (y,z), y → (z,x), z → (x,y).
template <class N>
struct Vec2 {
  N u, v;
};

template <class N>
Vec2<N> project(const Vec3<N>& w, Axis dropped) {
  if (dropped == Axis::x) return {w.y, w.z};
  if (dropped == Axis::y) return {w.z, w.x};
  return {w.x, w.y};
}

template <class N>
const N& coordinate(const Vec3<N>& w, Axis axis) {
  return axis == Axis::x ? w.x : axis == Axis::y ? w.y : w.z;
}

}  // namespace tribunal
