// Segura–Feito on adaptive expansions: another exact arithmetic under the one source.
#include "exact/kernels/expansion_kernel.h"
#include "exact/methods/exact_methods.h"
#include "exact/methods/segura_feito_method.h"

namespace tribunal {
namespace {

/// An answer is by the filter if all its signs are.
Stage stage_of(const ExpansionTally& tally) {
  return tally.expansions + tally.dyadic > 0 ? Stage::exact : Stage::filter;
}

/// What `ask` answers on a kernel that counts, with the stage of the answer.
template <class Asked>
Answer staged(const Asked& ask) {
  ExpansionTally tally;
  Answer answer = ask(ExpansionKernel(&tally));
  answer.stage = stage_of(tally);
  return answer;
}

}  // namespace

Method sf_expansion() {
  Method m =
      segura_feito_method({.number = "floating-point expansions",
                           .summary = "five signs by an error bound, then adaptive expansions; GMP beyond their range",
                           .format = Format::binary64,
                           .exact = true},
                          ExpansionKernel{});
  m.card.reference = "Segura & Feito 1998, 2001; Shewchuk 1997";
  m.stages = {Stage::filter, Stage::exact};
  m.segment = [](const Segment& s, const Triangle& t) {
    return staged([&](const auto& k) { return segura_feito(s, t, k); });
  };
  m.ray = [](const Ray& r, const Triangle& t) { return staged([&](const auto& k) { return segura_feito(r, t, k); }); };
  m.within = [](const Ray& r, const Bounds& b, const Triangle& t) {
    return staged([&](const auto& k) { return segura_feito(r, b, t, k); });
  };
  m.classify = [](const Probe& probe, const Triangle& t) {
    return std::visit([&](const auto& p) { return staged([&](const auto& k) { return classify(p, t, k); }); }, probe);
  };
  return m;
}

}  // namespace tribunal
