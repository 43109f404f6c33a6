#include "core/rivals.h"

#include "core/moeller_trumbore.h"

namespace tribunal {
namespace {

/// Möller–Trumbore reports no contact kind: it has coordinates of the hit, not signs.
template <class N, class P>
Answer answer_of(const P& probe, const Triangle& t) {
  return moeller_trumbore<N>(probe, t) ? hit_at(Contact::unsaid) : miss();
}

template <class N>
Sign nearer(const Ray& r, const Triangle& s, const Triangle& t) {
  const std::optional<N> f = moeller_trumbore<N>(r, s);
  const std::optional<N> g = moeller_trumbore<N>(r, t);
  return f && g ? sign_of(*f - *g) : Sign::zero;
}

template <class N>
std::optional<double> parameter_of(const Ray& r, const Triangle& t) {
  return moeller_trumbore<N>(r, t);
}

template <class N>
Method moeller_trumbore_method(Format format) {
  return {.card = {.number = std::string(name_of(format)),
                   .summary = "Cramer's rule, one division, coordinates compared with 0 and 1",
                   .reference = "Möller & Trumbore 1997"},
          .contract = {.convention = Convention::transversal, .format = format},
          .segment = answer_of<N, Segment>,
          .ray = answer_of<N, Ray>,
          .compare_hits = nearer<N>,
          .parameter = parameter_of<N>};
}

}  // namespace

Method moeller_trumbore_float() { return moeller_trumbore_method<float>(Format::binary32); }

Method moeller_trumbore_double() { return moeller_trumbore_method<double>(Format::binary64); }

}  // namespace tribunal
