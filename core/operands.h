// The operands of the tests: segments, rays and triangles; polygons are in polygon.h.
#pragma once

#include <cmath>
#include <limits>
#include <variant>

#include "core/vec3.h"

namespace tribunal {

/// The closed triangle conv(a, b, c). May be degenerate: collinear or repeated vertices.
struct Triangle {
  Point3 a, b, c;
};

/// The closed segment [p, q]. May be a point.
struct Segment {
  Point3 p, q;
};

/// The half-line {o + t·d, t ≥ 0}, by origin and direction as given; o + d is never formed. d = 0 is a point.
struct Ray {
  Point3 o;
  Direction d;
};

/// The parameters t to which a ray o + t·d is cut: tmin ≤ t ≤ tmax, both ends closed. tmin ≥ 0 is finite; tmax ≥ tmin
/// may be +∞, which leaves the ray without an end.
struct Bounds {
  double tmin = 0;
  double tmax = std::numeric_limits<double>::infinity();

  friend bool operator==(const Bounds&, const Bounds&) = default;
};

/// The point o + t·d of a ray, t finite. It is not formed: a number type that rounds would move it.
struct RayPoint {
  Ray ray;
  double t;
};

/// The arm from a to that point, from the ray's own numbers.
template <class N>
Vec3<N> arm(const Vec3<N>& a, const RayPoint& p) {
  const Vec3<N> o = lift<N>(p.ray.o) - a, d = lift<N>(p.ray.d.v);
  const N t = static_cast<N>(p.t);
  return {N(o.x + N(t * d.x)), N(o.y + N(t * d.y)), N(o.z + N(t * d.z))};
}

/// The part tmin ≤ t ≤ tmax of a ray, tmax finite. A point where tmin = tmax.
struct Stretch {
  Ray ray;
  Bounds bounds;
};

/// The part t ≥ tmin of a ray.
struct Tail {
  Ray ray;
  double tmin;
};

/// A probe starts at `source` and runs to `target`: a point, or a point at infinity. The tests are written once in
/// these two words and serve segments, rays and parts of rays alike.
inline const Point3& source(const Segment& s) { return s.p; }
inline const Point3& target(const Segment& s) { return s.q; }
inline const Point3& source(const Ray& r) { return r.o; }
inline const Direction& target(const Ray& r) { return r.d; }
inline RayPoint source(const Stretch& s) { return {s.ray, s.bounds.tmin}; }
inline RayPoint target(const Stretch& s) { return {s.ray, s.bounds.tmax}; }
inline RayPoint source(const Tail& s) { return {s.ray, s.tmin}; }
inline const Direction& target(const Tail& s) { return s.ray.d; }

/// The probe's line runs from `base` toward `along`: for a part of a ray, as the ray is given.
template <class P>
const Point3& base(const P& probe) {
  return source(probe);
}
template <class P>
const auto& along(const P& probe) {
  return target(probe);
}
inline const Point3& base(const Stretch& s) { return s.ray.o; }
inline const Direction& along(const Stretch& s) { return s.ray.d; }
inline const Point3& base(const Tail& s) { return s.ray.o; }
inline const Direction& along(const Tail& s) { return s.ray.d; }

using Probe = std::variant<Segment, Ray>;

/// A probe and a triangle: an element of a batch.
struct TrianglePair {
  Probe probe;
  Triangle triangle;
};

inline bool is_finite(const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

inline bool is_finite(const Triangle& t) { return is_finite(t.a) && is_finite(t.b) && is_finite(t.c); }

inline bool is_finite(const Segment& s) { return is_finite(s.p) && is_finite(s.q); }

inline bool is_finite(const Ray& r) { return is_finite(r.o) && is_finite(r.d.v); }

/// Whether they are numbers; that tmax is infinite is usual.
inline bool is_finite(const Bounds& b) { return std::isfinite(b.tmin) && !std::isnan(b.tmax); }

/// decide(part) for the part of the ray within the bounds: a Stretch, or a Tail if it has no end.
template <class Decide>
auto decide_within(const Ray& ray, const Bounds& bounds, const Decide& decide) {
  if (std::isinf(bounds.tmax)) return decide(Tail{ray, bounds.tmin});
  return decide(Stretch{ray, bounds});
}

}  // namespace tribunal
