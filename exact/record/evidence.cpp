// The exact signs that decide a case, for counterexamples.
#include "exact/kernels/rational_kernel.h"
#include "exact/record/counterexample.h"
#include "exact/record/five_signs.h"

namespace tribunal {
namespace {

/// Where on the probe the plane of t lies: V(p) / (V(p) − V(q)) on a segment, V(o) / −V(d) on a ray.
HitParameter<Dyadic> parameter(const Ray& r, const Triangle& t) { return hit_parameter<Dyadic>(r, t); }

HitParameter<Dyadic> parameter(const Segment& s, const Triangle& t) {
  const Dyadic from_p = signed_volume<Dyadic>(t.a, t.b, t.c, s.p);
  return {from_p, from_p - signed_volume<Dyadic>(t.a, t.b, t.c, s.q)};
}

template <class P>
Json evidence(const P& probe, const Triangle& t) {
  Json object;
  const auto signs = five_signs({probe, t}, RationalKernel{});
  for (std::size_t i = 0; i < signs.size(); ++i) object[five_sign_names[i]] = value(signs[i]);
  const HitParameter<Dyadic> at = parameter(probe, t);
  if (sign_of(at.den) != Sign::zero) {
    object["t"] = mpq_class(at.num.fraction() / at.den.fraction()).get_str();
  }
  return object;
}

/// The side of the plane on which the ray is at each bound; at infinity, where it runs to.
void add_sides(Json& object, const Ray& r, const Bounds& bounds, const Triangle& t) {
  decide_within(r, bounds, [&](const auto& part) {
    const RationalKernel k;
    object["at_tmin"] = value(k.orient3d(t.a, t.b, t.c, source(part)));
    object["at_tmax"] = value(k.orient3d(t.a, t.b, t.c, target(part)));
  });
}

}  // namespace

Json exact_evidence(const Query& query) {
  if (query.operands() == Operands::polygons) {
    const Truth truth = exact_truth(query);
    return {{"contact", name_of(truth.contact)}, {"planar", truth.planar}};
  }
  Json object = std::visit([&](const auto& probe) { return evidence(probe, query.triangle()); }, query.probe);
  if (query.bounds) add_sides(object, std::get<Ray>(query.probe), *query.bounds, query.triangle());
  return object;
}

}  // namespace tribunal
