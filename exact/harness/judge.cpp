#include "exact/harness/judge.h"

#include <variant>

#include "exact/classes/class_table.h"
#include "exact/io/case_io.h"
#include "exact/io/failure.h"
#include "exact/kernels/integers.h"
#include "exact/methods.h"
#include "exact/oracles/caratheodory.h"

namespace tribunal {
namespace {

Truth from_table(ClassId id) { return {id, class_row(id).contact()}; }

[[noreturn]] void contradiction(const Query& query, const std::string& one, const std::string& other) {
  const Case witness{.id = "contradiction", .query = query};
  throw Failure(Exit::oracles_contradict,
                "oracles contradict each other: " + one + ", " + other + ", on " + from_case(witness).dump());
}

[[noreturn]] void contradiction(const Query& query, const Truth& truth, const std::string& other, bool hit) {
  contradiction(query, "the reference says " + std::string(name_of(truth.contact)),
                other + " says " + (hit ? "hit" : "no hit"));
}

Truth truth_by_reference(const Query& query) {
  const Method& reference = reference_method();
  const Answer answer = reference.classify(query.probe, query.triangle);
  if (answer.class_id == 0) contradiction(query, "the reference's signs are in no class", "five elements always are");
  const Truth truth = from_table(answer.class_id);
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
  return std::visit([&](const auto& probe) { return with_exact_number(probe, query.triangle, meets); }, query.probe);
}

}  // namespace

Truth exact_truth(const Query& query) {
  static const Method& cgal = *find_method("cgal-epick");
  const Truth truth = truth_by_reference(query);
  const bool meets = meets_by_caratheodory(query);
  if (meets != truth.hit()) contradiction(query, truth, "Caratheodory", meets);
  const Answer by_cgal = cgal.ask(query);
  if (by_cgal.status == Status::ok && by_cgal.hit != truth.hit()) contradiction(query, truth, "CGAL", by_cgal.hit);
  return truth;
}

Truth truth_of(const Trial& trial, std::uint64_t k) {
  if (trial.class_id != 0 && k % 257 != 0) return from_table(trial.class_id);
  const Truth truth = exact_truth(trial.query);
  if (trial.class_id != 0 && trial.class_id != truth.class_id) {
    contradiction(trial.query, "construction says " + class_name(trial.class_id),
                  "the oracles say " + class_name(truth.class_id));
  }
  return truth;
}

}  // namespace tribunal
