#include "core/polygon_rivals.h"

#include <memory>

#include "core/classical_polygon.h"

namespace tribunal {
namespace {

struct Description {
  const char* name;
  const char* number;
  const char* summary;
  const char* reference;
  Format format;
  bool decides_boundary;
};

template <class N>
using Inclusion = bool (*)(const ClassicalPolygon<N>&, const Vec2<N>&);

/// The classical ways tell neither contact nor planarity: they assume the latter.
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

/// A triangle is a ring of three.
template <class N, class P>
Answer ask_triangle(const P& probe, const Triangle& t, Inclusion<N> inside) {
  const Point3 vertices[] = {t.a, t.b, t.c};
  constexpr std::size_t ends[] = {3};
  return ask(probe, classical_polygon<N>({vertices, ends}), inside);
}

/// Where a method may answer either way on the boundary, the contract leaves triangles out: the harness judges those
/// on their boundary too.
template <class N>
Method classical_method(const Description& d, Inclusion<N> inside) {
  Method m{.name = d.name,
           .number = d.number,
           .contract = d.decides_boundary ? "segment, ray; triangle, planar polygon"
                                          : "segment, ray; planar polygon, no boundary",
           .summary = d.summary,
           .reference = d.reference,
           .convention = Convention::transversal,
           .format = d.format,
           .exact = false,
           .segment = [](const Segment&, const Triangle&) { return refusal(Status::unsupported); },
           .ray = [](const Ray&, const Triangle&) { return refusal(Status::unsupported); },
           .classify = {},
           .compare_hits = {},
           .batch = {},
           .polygon = [inside](const Polygon& polygon) { return prepare<N>(polygon, inside); },
           .polygon_promise = {.boundary = d.decides_boundary, .surface = false}};
  if (!d.decides_boundary) return m;
  m.segment = [inside](const Segment& s, const Triangle& t) { return ask_triangle<N>(s, t, inside); };
  m.ray = [inside](const Ray& r, const Triangle& t) { return ask_triangle<N>(r, t, inside); };
  return m;
}

template <class N>
Method haines(const char* name, const char* number, Format format) {
  return classical_method<N>({.name = name,
                              .number = number,
                              .summary = "meets the plane, projects, counts crossings",
                              .reference = "Haines 1994",
                              .format = format,
                              .decides_boundary = false},
                             inside_by_crossings<N>);
}

template <class N>
Method feito(const char* name, const char* number, Format format) {
  return classical_method<N>({.name = name,
                              .number = number,
                              .summary = "meets the plane, projects, counts signed triangles",
                              .reference = "Feito, Torres & Ureña 1995",
                              .format = format,
                              .decides_boundary = true},
                             inside_by_signed_triangles<N>);
}

}  // namespace

Method haines_float() { return haines<float>("haines-float", "binary32", Format::binary32); }
Method haines_double() { return haines<double>("haines-double", "binary64", Format::binary64); }
Method feito_float() { return feito<float>("feito-float", "binary32", Format::binary32); }
Method feito_double() { return feito<double>("feito-double", "binary64", Format::binary64); }

}  // namespace tribunal
