// The operands of the tests: segments, rays and triangles; polygons are in polygon.h.
#pragma once

#include <cmath>
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

/// A probe starts at `source` and runs to `target`: a point, or a point at infinity. The tests are written once in
/// these two words and serve segments and rays alike.
inline const Point3& source(const Segment& s) { return s.p; }
inline const Point3& target(const Segment& s) { return s.q; }
inline const Point3& source(const Ray& r) { return r.o; }
inline const Direction& target(const Ray& r) { return r.d; }

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

}  // namespace tribunal
