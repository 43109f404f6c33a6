// Segura–Feito on CGAL's Exact_predicates_inexact_constructions_kernel. Points go to its own filtered predicates.
// Directions cannot: it would round a−o before the predicate sees it. For them CGAL's Filtered_predicate runs our
// formula in intervals first and in exact rationals where those are not certain, which is how EPICK itself is made.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Filtered_predicate.h>

#include "exact/methods/cgal_kernels.h"
#include "exact/methods/exact_methods.h"
#include "exact/methods/segura_feito_method.h"

namespace tribunal {
namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class FT>
using SignOf = typename CGAL::Same_uncertainty_nt<CGAL::Sign, FT>::type;

template <class K>
Vec3<typename K::FT> coordinates(const CGAL::Point_3<K>& p) {
  return {p.x(), p.y(), p.z()};
}

template <class K>
Vec3<typename K::FT> coordinates(const CGAL::Vector_3<K>& d) {
  return {d.x(), d.y(), d.z()};
}

template <class K>
struct VolumeToward {
  using FT = typename K::FT;
  using result_type = SignOf<FT>;

  result_type operator()(const CGAL::Point_3<K>& a, const CGAL::Point_3<K>& b, const CGAL::Point_3<K>& c,
                         const CGAL::Vector_3<K>& d) const {
    const Vec3<FT> o = coordinates(a);
    return CGAL::sign(det3<FT>(coordinates(b) - o, coordinates(c) - o, coordinates(d)));
  }
};

template <class K>
struct AreaToward {
  using FT = typename K::FT;
  using result_type = SignOf<FT>;

  result_type operator()(int dropped, const CGAL::Point_3<K>& a, const CGAL::Point_3<K>& b,
                         const CGAL::Vector_3<K>& d) const {
    const Vec2<FT> f = project<FT>(coordinates(b) - coordinates(a), static_cast<Axis>(dropped));
    const Vec2<FT> g = project<FT>(coordinates(d), static_cast<Axis>(dropped));
    return CGAL::sign(FT(f.u * g.v - f.v * g.u));
  }
};

/// The arm from a to the point o + t·d.
template <class K>
Vec3<typename K::FT> arm_along(const CGAL::Point_3<K>& a, const CGAL::Point_3<K>& o, const CGAL::Vector_3<K>& d,
                               const typename K::FT& t) {
  using FT = typename K::FT;
  const Vec3<FT> w = coordinates(o) - coordinates(a), v = coordinates(d);
  return {FT(w.x + t * v.x), FT(w.y + t * v.y), FT(w.z + t * v.z)};
}

/// The number t is carried as a coordinate, which the converters of Filtered_predicate know how to convert.
template <class K>
struct VolumeAlong {
  using FT = typename K::FT;
  using Point = CGAL::Point_3<K>;
  using result_type = SignOf<FT>;

  result_type operator()(const Point& a, const Point& b, const Point& c, const Point& o, const CGAL::Vector_3<K>& d,
                         const Point& t) const {
    return CGAL::sign(
        det3<FT>(coordinates(b) - coordinates(a), coordinates(c) - coordinates(a), arm_along<K>(a, o, d, t.x())));
  }
};

template <class K>
struct AreaAlong {
  using FT = typename K::FT;
  using Point = CGAL::Point_3<K>;
  using result_type = SignOf<FT>;

  result_type operator()(int dropped, const Point& a, const Point& b, const Point& o, const CGAL::Vector_3<K>& d,
                         const Point& t) const {
    const Vec2<FT> f = project<FT>(coordinates(b) - coordinates(a), static_cast<Axis>(dropped));
    const Vec2<FT> g = project<FT>(arm_along<K>(a, o, d, t.x()), static_cast<Axis>(dropped));
    return CGAL::sign(FT(f.u * g.v - f.v * g.u));
  }
};

template <class K>
struct LengthAlong {
  using FT = typename K::FT;
  using Point = CGAL::Point_3<K>;
  using result_type = SignOf<FT>;

  result_type operator()(int axis, const Point& a, const Point& o, const CGAL::Vector_3<K>& d, const Point& t) const {
    const Vec3<FT> w = arm_along<K>(a, o, d, t.x());
    return CGAL::sign(coordinate<FT>(w, static_cast<Axis>(axis)));
  }
};

template <class K>
struct OrderOfHits {
  using FT = typename K::FT;
  using Point = CGAL::Point_3<K>;
  using result_type = SignOf<FT>;

  result_type operator()(const Point& o, const CGAL::Vector_3<K>& d, const CGAL::Triangle_3<K>& s,
                         const CGAL::Triangle_3<K>& t) const {
    const HitParameter<FT> f = parameter(o, d, s);
    const HitParameter<FT> g = parameter(o, d, t);
    return CGAL::sign(FT(f.num * g.den - g.num * f.den)) * CGAL::sign(f.den) * CGAL::sign(g.den);
  }

 private:
  static HitParameter<FT> parameter(const Point& o, const CGAL::Vector_3<K>& d, const CGAL::Triangle_3<K>& t) {
    const Vec3<FT> a = coordinates(t.vertex(0));
    const Vec3<FT> u = coordinates(t.vertex(1)) - a;
    const Vec3<FT> v = coordinates(t.vertex(2)) - a;
    return {det3<FT>(u, v, coordinates(o) - a), -det3<FT>(u, v, coordinates(d))};
  }
};

template <template <class> class Predicate>
using Filtered = CGAL::Filtered_predicate<Predicate<Epick::Exact_kernel>, Predicate<Epick::Approximate_kernel>,
                                          Epick::C2E, Epick::C2F>;

Epick::Point_3 cgal(const Point3& p) { return {p.x, p.y, p.z}; }
Epick::Vector_3 cgal(const Direction& d) { return {d.v.x, d.v.y, d.v.z}; }
Epick::Triangle_3 cgal(const Triangle& t) { return {cgal(t.a), cgal(t.b), cgal(t.c)}; }

/// A number as the first coordinate of a point.
Epick::Point_3 number(double t) { return {t, 0, 0}; }

Epick::Point_2 flat(const Point3& p, Axis dropped) {
  const Vec2<double> w = project<double>(lift<double>(p), dropped);
  return {w.u, w.v};
}

Sign ours(CGAL::Sign s) { return static_cast<Sign>(static_cast<int>(s)); }

}  // namespace

Sign EpickKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& x) const {
  return ours(CGAL::orientation(cgal(a), cgal(b), cgal(c), cgal(x)));
}

Sign EpickKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const Direction& d) const {
  return ours(Filtered<VolumeToward>()(cgal(a), cgal(b), cgal(c), cgal(d)));
}

Sign EpickKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const Point3& x) const {
  return ours(CGAL::orientation(flat(a, dropped), flat(b, dropped), flat(x, dropped)));
}

Sign EpickKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const Direction& d) const {
  return ours(Filtered<AreaToward>()(static_cast<int>(dropped), cgal(a), cgal(b), cgal(d)));
}

Sign EpickKernel::compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const {
  return ours(Filtered<OrderOfHits>()(cgal(r.o), cgal(r.d), cgal(s), cgal(t)));
}

Sign EpickKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const RayPoint& x) const {
  return ours(Filtered<VolumeAlong>()(cgal(a), cgal(b), cgal(c), cgal(x.ray.o), cgal(x.ray.d), number(x.t)));
}

Sign EpickKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const RayPoint& x) const {
  return ours(
      Filtered<AreaAlong>()(static_cast<int>(dropped), cgal(a), cgal(b), cgal(x.ray.o), cgal(x.ray.d), number(x.t)));
}

Sign EpickKernel::compare(Axis axis, const Point3& a, const RayPoint& x) const {
  return ours(Filtered<LengthAlong>()(static_cast<int>(axis), cgal(a), cgal(x.ray.o), cgal(x.ray.d), number(x.t)));
}

Method sf_epick() {
  return segura_feito_method({.number = "CGAL filtered predicates",
                              .summary = "five signs by CGAL's EPICK: intervals first, exact rationals if needed",
                              .format = Format::binary64,
                              .exact = true},
                             EpickKernel{});
}

}  // namespace tribunal
