#include <variant>

#include "exact/classes/class_table.h"
#include "exact/kernels/integers.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/methods/methods.h"
#include "exact/oracles/caratheodory.h"
#include "exact/trial/truth_rules.h"

namespace tribunal {
namespace {

[[noreturn]] void contradiction(const Query& query, const Truth& truth, const std::string& other, bool hit) {
  contradiction(query, "the reference says " + std::string(name_of(truth.contact)),
                other + " says " + (hit ? "hit" : "no hit"));
}

Truth truth_by_reference(const Query& query) {
  const Method& reference = reference_method();
  const Answer answer = reference.classify(query.probe, query.triangle());
  if (answer.class_id == 0) contradiction(query, "the reference's signs are in no class", "five elements always are");
  const Truth truth = truth_in_class(answer.class_id, query);
  if (truth.facing != facing_in(truth.contact, query, RationalKernel{})) {
    contradiction(query, "the rational kernel", "EPICK has the triangle's other side");
  }
  if (truth.contact != answer.contact) {
    contradiction(query, "class " + class_name(truth.class_id) + " says " + std::string(name_of(truth.contact)),
                  "the reference says " + std::string(name_of(answer.contact)));
  }
  return truth;
}

bool meets_by_caratheodory(const Query& query) {
  const auto meets = []<class N>(const auto& probe, const Triangle& t) {
    return tribunal::meets_by_caratheodory<N>(probe, t);
  };
  return std::visit([&](const auto& probe) { return with_exact_number(probe, query.triangle(), meets); }, query.probe);
}

}  // namespace

Truth exact_truth_of_triangle(const Query& query) {
  static const Method& second = method_with(Role::second_opinion);
  const Truth truth = truth_by_reference(query);
  const bool meets = meets_by_caratheodory(query);
  if (meets != truth.hit()) contradiction(query, truth, "Caratheodory", meets);
  const Answer opinion = second.ask(query);
  if (opinion.status == Status::ok && opinion.hit != truth.hit()) contradiction(query, truth, second.name, opinion.hit);
  return truth;
}

}  // namespace tribunal
