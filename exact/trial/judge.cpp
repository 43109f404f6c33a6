#include "exact/trial/judge.h"

#include "exact/classes/class_table.h"

namespace tribunal {
namespace {

/// The facts of a case that its class says.
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

/// What the bounds leave of the ray. In a plane they may leave a boundary contact or none.
void narrow(Facts& facts, const Truth& truth) {
  facts.bounded = true;
  facts.contact = truth.contact;
  facts.at = truth.at;
  facts.at_origin = truth.at_origin;
  facts.boundary &= truth.hit();
}

Facts facts_of_triangle(const Truth& truth) {
  static const auto by_class = facts_of_classes();
  Facts facts = by_class[truth.class_id];
  facts.facing = truth.facing;
  if (truth.bounded) narrow(facts, truth);
  return facts;
}

/// Neither is unsaid, and they differ.
bool tells_other_side(Facing told, Facing exact) {
  return told != Facing::unsaid && exact != Facing::unsaid && told != exact;
}

/// What the method tells beside hit or miss is wrong. Batch forms may leave the contact unsaid.
bool tells_wrongly(const Method& method, const Truth& truth, const Answer& answer) {
  if (method.contract.exact && answer.planar != truth.planar) return true;
  if (method.tells_side && answer.hit && tells_other_side(answer.facing, truth.facing)) return true;
  return method.tells_contact && answer.hit && answer.contact != Contact::unsaid && answer.contact != truth.contact;
}

}  // namespace

Facts facts_of(const Truth& truth) {
  if (truth.operands() == Operands::triangles) return facts_of_triangle(truth);
  return {.of_ray = truth.of_ray,
          .of_polygon = true,
          .planar = truth.planar,
          .contact = truth.contact,
          .boundary = truth.boundary,
          .at = truth.at};
}

Due due(const Contract& contract, const Truth& truth) { return due(contract, facts_of(truth)); }

bool owes_all(const Contract& c, Operands operands) {
  if (operands == Operands::polygons) return promises_all_polygons(c);
  return reads_point_sets(c) && c.triangles != Triangles::none;
}

Answer within_contract(const Method& method, const Truth& truth, const Answer& answer) {
  if (answer.status != Status::ok || due(method.contract, truth) != Due::nothing) return answer;
  return refusal(Status::unsupported);
}

Outcome judge(const Method& method, const Truth& truth, const Answer& answer) {
  if (is_fault(answer.status)) return Outcome::fault;
  const Due owed = due(method.contract, truth);
  if (owed == Due::nothing) return Outcome::not_owed;
  if (answer.status != Status::ok) return Outcome::refused;
  const Outcome outcome = judge(owed, answer.hit);
  return outcome == Outcome::right && tells_wrongly(method, truth, answer) ? Outcome::wrong_contact : outcome;
}

}  // namespace tribunal
