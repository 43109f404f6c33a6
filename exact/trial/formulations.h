// The exact answer to a case of triangles by formulations on integers of a fixed width, which must agree.
#pragma once

#include <optional>
#include <string>
#include <type_traits>

#include "exact/classes/classify.h"
#include "exact/kernels/lattice_kernel.h"
#include "exact/oracles/caratheodory.h"
#include "exact/trial/truth_rules.h"

namespace tribunal {

/// The exact answer to a query about a triangle.
using TruthBy = Truth (*)(const Query&);

namespace formulations_detail {

template <class N, class P>
std::optional<Truth> truth_on(const P& probe, const Triangle& t, const Query& query) {
  if constexpr (std::is_same_v<N, Dyadic>) return std::nullopt;
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

/// The class by its signs, the Segura–Feito decision and Carathéodory's theorem, on the narrowest `Integer` that holds
/// the operands. Nothing where none does. Ends the run where two of the three differ.
template <template <int> class Integer>
std::optional<Truth> truth_on_integers(const Query& query) {
  const auto on = [&]<class N>(const auto& probe, const Triangle& t) {
    return formulations_detail::truth_on<N>(probe, t, query);
  };
  return std::visit([&](const auto& probe) { return with_exact_number<Integer>(probe, query.triangle(), on); },
                    query.probe);
}

/// On integers of a fixed width, or else by exact_truth. Ten times as fast as that on all families together.
Truth truth_by_formulations(const Query& query);

/// truth_by_formulations, which must be what the construction proves; where a case knows its class, that alone, but for
/// one case in 257, as in truth_of. `needs_facing`: else it may be left unsaid.
Truth formulated_truth(const Trial& trial, std::uint64_t k, bool needs_facing, TruthBy formulations);

/// By all of exact_truth, with which the formulations must agree, whether or not a case knows its class; else the run
/// ends with Exit::oracles_contradict.
Truth audited_by_oracles(const Trial& trial, TruthBy formulations);

}  // namespace tribunal
