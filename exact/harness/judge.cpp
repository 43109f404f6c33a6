#include "exact/harness/judge.h"

#include <variant>

#include "exact/classes/class_table.h"
#include "exact/io/case_io.h"
#include "exact/io/failure.h"
#include "exact/kernels/cgal_kernels.h"
#include "exact/kernels/integers.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/methods.h"
#include "exact/oracles/caratheodory.h"

namespace tribunal {
namespace {

bool crosses(Contact contact) { return contact != Contact::none && contact != Contact::coplanar; }

template <Kernel K>
Facing facing_in(Contact contact, const Query& query, const K& k) {
  if (!crosses(contact)) return Facing::unsaid;
  return std::visit([&](const auto& probe) { return facing(probe, query.triangle, k); }, query.probe);
}

/// What a class says of a case beside its contact.
Facts facts_in(const ClassRow& row) {
  Facts f{.of_ray = is_ray_class(row.id), .contact = row.contact()};
  f.degenerate = row.triangle != "tri" || row.probe == "pt";
  f.boundary = row.touches.find("/E") != std::string::npos || row.touches.find("/V") != std::string::npos;
  if (row.intersection == "point") f.at = row.touches.starts_with("int") ? At::between : At::source;
  return f;
}

std::array<Facts, all_class_count + 1> facts_of_classes() {
  std::array<Facts, all_class_count + 1> facts{};
  for (ClassId id = 1; id <= all_class_count; ++id) facts[id] = facts_in(class_row(id));
  return facts;
}

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
  return std::visit([&](const auto& probe) { return with_exact_number(probe, query.triangle, meets); }, query.probe);
}

}  // namespace

Truth truth_in_class(ClassId id, const Query& query) {
  const Contact contact = class_row(id).contact();
  return {id, contact, facing_in(contact, query, EpickKernel{})};
}

Facts facts_of(const Truth& truth) {
  static const auto by_class = facts_of_classes();
  Facts facts = by_class[truth.class_id];
  facts.facing = truth.facing;
  return facts;
}

Answer within_contract(const Method& method, const Truth& truth, const Answer& answer) {
  if (answer.status != Status::ok || due(method.contract, truth) != Due::nothing) return answer;
  return refusal(Status::unsupported);
}

Judgement judge(const Method& method, const Truth& truth, const Answer& answer) {
  if (answer.status != Status::ok) return Judgement::unsupported;
  return judge(due(method.contract, truth), answer.hit);
}

Truth exact_truth(const Query& query) {
  static const Method& second = method_with(Role::second_opinion);
  const Truth truth = truth_by_reference(query);
  const bool meets = meets_by_caratheodory(query);
  if (meets != truth.hit()) contradiction(query, truth, "Caratheodory", meets);
  const Answer opinion = second.ask(query);
  if (opinion.status == Status::ok && opinion.hit != truth.hit()) contradiction(query, truth, second.name, opinion.hit);
  return truth;
}

Truth truth_of(const Trial& trial, std::uint64_t k) {
  if (trial.class_id != 0 && k % 257 != 0) return truth_in_class(trial.class_id, trial.query);
  const Truth truth = exact_truth(trial.query);
  if (trial.class_id != 0 && trial.class_id != truth.class_id) {
    contradiction(trial.query, "construction says " + class_name(trial.class_id),
                  "the oracles say " + class_name(truth.class_id));
  }
  return truth;
}

}  // namespace tribunal
