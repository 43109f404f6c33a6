// Segura–Feito on CGAL's Exact_predicates_exact_constructions_kernel: lazy exact numbers throughout.
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "exact/methods/cgal_kernels.h"
#include "exact/methods/exact_methods.h"
#include "exact/methods/segura_feito_method.h"

namespace tribunal {
namespace {

using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

Epeck::Point_3 cgal(const Point3& p) { return {p.x, p.y, p.z}; }
Epeck::Vector_3 cgal(const Direction& d) { return {d.v.x, d.v.y, d.v.z}; }

Vec2<double> flat(const Point3& p, Axis dropped) { return project<double>(lift<double>(p), dropped); }

Epeck::Point_2 point2(const Point3& p, Axis dropped) {
  const Vec2<double> w = flat(p, dropped);
  return {w.u, w.v};
}

Epeck::Vector_2 vector2(const Direction& d, Axis dropped) {
  const Vec2<double> w = flat(d.v, dropped);
  return {w.u, w.v};
}

Epeck::Point_3 cgal(const RayPoint& x) { return cgal(x.ray.o) + Epeck::FT(x.t) * cgal(x.ray.d); }

Epeck::Point_2 flat(const Epeck::Point_3& p, Axis dropped) {
  const Vec2<Epeck::FT> w = project<Epeck::FT>(Vec3<Epeck::FT>{p.x(), p.y(), p.z()}, dropped);
  return {w.u, w.v};
}

Sign ours(CGAL::Sign s) { return static_cast<Sign>(static_cast<int>(s)); }

Vec3<Epeck::FT> exact(const Point3& p) { return {Epeck::FT(p.x), Epeck::FT(p.y), Epeck::FT(p.z)}; }

HitParameter<Epeck::FT> parameter(const Ray& r, const Triangle& t) {
  const Vec3<Epeck::FT> a = exact(t.a);
  const Vec3<Epeck::FT> u = exact(t.b) - a;
  const Vec3<Epeck::FT> v = exact(t.c) - a;
  return {det3<Epeck::FT>(u, v, exact(r.o) - a), -det3<Epeck::FT>(u, v, exact(r.d.v))};
}

}  // namespace

Sign EpeckKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& x) const {
  return ours(CGAL::orientation(cgal(a), cgal(b), cgal(c), cgal(x)));
}

Sign EpeckKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const Direction& d) const {
  const Epeck::Point_3 o = cgal(a);
  return ours(CGAL::orientation(cgal(b) - o, cgal(c) - o, cgal(d)));
}

Sign EpeckKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const Point3& x) const {
  return ours(CGAL::orientation(point2(a, dropped), point2(b, dropped), point2(x, dropped)));
}

Sign EpeckKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const Direction& d) const {
  return ours(CGAL::orientation(point2(b, dropped) - point2(a, dropped), vector2(d, dropped)));
}

Sign EpeckKernel::compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const {
  const HitParameter<Epeck::FT> f = parameter(r, s);
  const HitParameter<Epeck::FT> g = parameter(r, t);
  const Epeck::FT difference = f.num * g.den - g.num * f.den;
  return ours(CGAL::sign(difference)) * ours(CGAL::sign(f.den)) * ours(CGAL::sign(g.den));
}

Sign EpeckKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const RayPoint& x) const {
  return ours(CGAL::orientation(cgal(a), cgal(b), cgal(c), cgal(x)));
}

Sign EpeckKernel::orient2d(Axis dropped, const Point3& a, const Point3& b, const RayPoint& x) const {
  return ours(CGAL::orientation(point2(a, dropped), point2(b, dropped), flat(cgal(x), dropped)));
}

Sign EpeckKernel::compare(Axis axis, const Point3& a, const RayPoint& x) const {
  const int i = static_cast<int>(axis);
  return ours(CGAL::compare(cgal(x)[i], Epeck::FT(a[i])));
}

Method sf_epeck() {
  return segura_feito_method({.number = "CGAL lazy exact numbers",
                              .summary = "five signs by CGAL's EPECK: lazy exact arithmetic",
                              .format = Format::binary64,
                              .exact = true},
                             EpeckKernel{});
}

}  // namespace tribunal
