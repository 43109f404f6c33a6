#include "exact/trial/observe.h"

#include "exact/base/fp_environment.h"
#include "exact/cases/case_line.h"

namespace tribunal {
namespace {

/// A plain hit in front of the origin, or its mirror image behind it. A method that depends on the query before differs
/// between the two, whichever sign it remembers.
Query other_query(Operands operands, double side) {
  const Segment s{{side, side, side}, {side, side, -side}};
  const Triangle t{{0, 0, 0}, {4 * side, 0, 0}, {0, 4 * side, 0}};
  if (operands == Operands::triangles) return {s, t};
  return {s, PolygonData{}.add(std::vector<Point3>{t.a, t.b, t.c})};
}

/// The fault that the answer stands for, with what the method knows of it.
Fault last_fault(const Method& method, const Answer& answer) {
  return {answer.status, method.last_fault ? method.last_fault() : ""};
}

Fault fault_when_asked(const Method& method, const Query& query, const Answer& first) {
  const Asked again = try_ask(method, query);
  if (again.fault) return again.fault;
  return say_the_same(again.answer, first) ? Fault{} : Fault{Status::differs_when_repeated};
}

}  // namespace

Asked try_ask(const Method& method, const Query& query) {
  try {
    const Answer answer = method.ask(query);
    require_exact_rounding();  // another environment, left behind by one method, would spoil the next one's answer
    if (is_fault(answer.status)) return {refusal(Status::unsupported), last_fault(method, answer)};
    return {answer, {}};
  } catch (const MethodFault& f) {
    return {refusal(Status::unsupported), f.fault()};
  }
}

Fault asked_again(const Method& method, const Query& query, const Answer& first, int times) {
  for (int i = 0; i < times; ++i) {
    if (const Fault fault = fault_when_asked(method, query, first)) return fault;
    for (const double side : {1.0, -1.0}) {
      try_ask(method, other_query(query.operands(), side));
      if (const Fault fault = fault_when_asked(method, query, first)) return fault;
    }
  }
  return {};
}

Asked observe(const Method& method, const Query& query, int times) {
  Asked asked = try_ask(method, query);
  if (!asked.fault) asked.fault = asked_again(method, query, asked.answer, times);
  return asked;
}

Answer ask_or_fail(const Method& method, const Query& query) {
  const Asked asked = try_ask(method, query);
  if (!asked.fault) return asked.answer;
  throw MethodFault(asked.fault, method.name + ": " + describe(asked.fault) + ", on " + case_line("fault", query));
}

}  // namespace tribunal
