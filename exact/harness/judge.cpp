#include "exact/harness/judge.h"

#include <variant>

#include "exact/classes/class_table.h"
#include "exact/io/case_io.h"
#include "exact/io/failure.h"
#include "exact/kernels/dyadic.h"
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

Truth truth_by_reference(const Query& query) {
  const Method& reference = reference_method();
  const auto* s = std::get_if<Segment>(&query.probe);
  if (s == nullptr) return {0, reference.ask(query).contact};
  const Answer answer = reference.classify(*s, query.triangle);
  if (answer.class_id == 0) contradiction(query, "the reference's signs are in no class", "five points always are");
  const Truth truth = from_table(answer.class_id);
  if (truth.contact != answer.contact) {
    contradiction(query, "class " + class_name(truth.class_id) + " says " + std::string(name_of(truth.contact)),
                  "the reference says " + std::string(name_of(answer.contact)));
  }
  return truth;
}

}  // namespace

Truth exact_truth(const Query& query) {
  const Truth truth = truth_by_reference(query);
  const bool meets =
      std::visit([&](const auto& probe) { return meets_by_caratheodory<Dyadic>(probe, query.triangle); }, query.probe);
  if (meets != truth.hit()) {
    contradiction(query, "the reference says " + std::string(name_of(truth.contact)),
                  std::string("Caratheodory says ") + (meets ? "hit" : "no hit"));
  }
  return truth;
}

Truth truth_of(const Trial& trial) {
  return trial.class_id != 0 ? from_table(trial.class_id) : exact_truth(trial.query);
}

Judgement judge(Convention convention, const Truth& truth, const Answer& answer) {
  if (answer.status != Status::ok) return Judgement::unsupported;
  return answer.hit == counts_as_hit(truth.contact, convention) ? Judgement::right : Judgement::wrong;
}

}  // namespace tribunal
