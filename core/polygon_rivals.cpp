#include "core/polygon_rivals.h"

#include <memory>

#include "core/classical_polygon.h"

namespace tribunal {
namespace {

struct Description {
  const char* summary;
  const char* reference;
  Format format;
  bool decides_boundary;
};

template <class N>
using Inclusion = bool (*)(const ClassicalPolygon<N>&, const Vec2<N>&);

/// The classical tests do not say which contact a hit is, and they take every polygon to be planar.
template <class N, class P>
Answer ask(const P& probe, const ClassicalPolygon<N>& c, Inclusion<N> inside) {
  const std::optional<PlaneHit<N>> hit = plane_hit(c, probe);
  return hit && inside(c, hit->x) ? hit_at(Contact::unsaid) : miss();
}

template <class N>
PreparedPolygon prepare(const Polygon& polygon, Inclusion<N> inside) {
  const auto c = std::make_shared<const ClassicalPolygon<N>>(classical_polygon<N>(polygon));
  return {.segment = [c, inside](const Segment& s) { return ask(s, *c, inside); },
          .ray = [c, inside](const Ray& r) { return ask(r, *c, inside); }};
}

/// A triangle is tested as a polygon of one ring.
template <class N, class P>
Answer ask_triangle(const P& probe, const Triangle& t, Inclusion<N> inside) {
  const Point3 vertices[] = {t.a, t.b, t.c};
  constexpr std::size_t ends[] = {3};
  return ask(probe, classical_polygon<N>({vertices, ends}), inside);
}

/// A method that may answer either way on the boundary takes no triangles.
template <class N>
Method classical_method(const Description& d, Inclusion<N> inside) {
  const Boundary boundary = d.decides_boundary ? Boundary::closed : Boundary::unspecified;
  Method m{.card = {.number = std::string(name_of(d.format)), .summary = d.summary, .reference = d.reference},
           .contract = {.triangles = d.decides_boundary ? Triangles::any : Triangles::none,
                        .polygons = Polygons::planar,
                        .convention = Convention::transversal,
                        .polygon_boundary = boundary,
                        .format = d.format},
           .segment = [](const Segment&, const Triangle&) { return refusal(Status::unsupported); },
           .ray = [](const Ray&, const Triangle&) { return refusal(Status::unsupported); },
           .polygon = [inside](const Polygon& polygon) { return prepare<N>(polygon, inside); }};
  if (!d.decides_boundary) return m;
  m.segment = [inside](const Segment& s, const Triangle& t) { return ask_triangle<N>(s, t, inside); };
  m.ray = [inside](const Ray& r, const Triangle& t) { return ask_triangle<N>(r, t, inside); };
  m.native = native_loops([inside](const Segment& s, const Triangle& t) { return ask_triangle<N>(s, t, inside).hit; });
  m.native_rays =
      native_ray_loops([inside](const Ray& r, const Triangle& t) { return ask_triangle<N>(r, t, inside).hit; });
  return m;
}

template <class N>
Method haines(Format format) {
  return classical_method<N>({.summary = "meets the plane, projects, counts crossings",
                              .reference = "Haines 1994",
                              .format = format,
                              .decides_boundary = false},
                             inside_by_crossings<N>);
}

template <class N>
Method feito(Format format) {
  return classical_method<N>({.summary = "meets the plane, projects, counts signed triangles",
                              .reference = "Feito, Torres & Ureña 1995",
                              .format = format,
                              .decides_boundary = true},
                             inside_by_signed_triangles<N>);
}

}  // namespace

Method haines_float() { return haines<float>(Format::binary32); }
Method haines_double() { return haines<double>(Format::binary64); }
Method feito_float() { return feito<float>(Format::binary32); }
Method feito_double() { return feito<double>(Format::binary64); }

}  // namespace tribunal
