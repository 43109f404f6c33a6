// The three formulations on any type of bounded integers.
#pragma once

#include <string>

#include "exact/classes/classify.h"
#include "exact/kernels/lattice_kernel.h"
#include "exact/oracles/caratheodory.h"
#include "exact/trial/truth_rules.h"

namespace tribunal {

namespace formulations_detail {

template <class N, class P>
Truth truth_on(const P& probe, const Triangle& t, const Query& query) {
  const typename ExactKernelOn<N>::Kernel k;
  const Answer answer = classify(probe, t, k);
  if (answer.class_id == 0) contradiction(query, "the signs of integers are in no class", "five elements always are");
  Truth truth = truth_of_class(answer.class_id);
  if (truth.contact != answer.contact) {
    contradiction(query, "on integers the class says " + std::string(name_of(truth.contact)),
                  "Segura-Feito " + std::string(name_of(answer.contact)));
  }
  const bool meets = meets_by_caratheodory<N>(probe, t);
  if (meets != truth.hit()) {
    contradiction(query, "on integers the class says " + std::string(name_of(truth.contact)),
                  std::string("Caratheodory ") + (meets ? "hit" : "no hit"));
  }
  if (truth.hit() && truth.contact != Contact::coplanar) truth.facing = facing(probe, t, k);
  return truth;
}

}  // namespace formulations_detail

/// truth_by_formulations with this type in place of BoundedInteger.
template <template <int> class Integer>
Truth truth_by_formulations_on(const Query& query) {
  if (query.bounds) return exact_truth(query);
  const auto on = [&]<class N>(const auto& probe, const Triangle& t) {
    return formulations_detail::truth_on<N>(probe, t, query);
  };
  return std::visit([&](const auto& probe) { return with_exact_number<Integer>(probe, query.triangle(), on); },
                    query.probe);
}

}  // namespace tribunal
