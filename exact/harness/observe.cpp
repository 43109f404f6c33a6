#include "exact/harness/observe.h"

#include "exact/harness/fp_environment.h"
#include "exact/io/polygon_case_io.h"

namespace tribunal {
namespace {

const Answer& plain(const Answer& answer) { return answer; }
const Answer& plain(const PolygonAnswer& answer) { return answer.answer; }

/// The fault that the answer stands for, with what the method knows of it.
Fault last_fault(const Method& method, const Answer& answer) {
  return {answer.status, method.last_fault ? method.last_fault() : ""};
}

template <class A, class Q>
Asked<A> tried(const Method& method, const Q& query) {
  try {
    const A answer = method.ask(query);
    require_exact_rounding();  // another environment, left behind by one method, would spoil the next one's answer
    if (is_fault(plain(answer).status)) return {A{refusal(Status::unsupported)}, last_fault(method, plain(answer))};
    return {answer, {}};
  } catch (const MethodFault& f) {
    return {A{refusal(Status::unsupported)}, f.fault()};
  }
}

/// A plain hit in front of the origin, and its mirror image behind it: a method that remembers the query before tells
/// them apart by any sign.
Query other_query(double side) {
  return {Segment{{side, side, side}, {side, side, -side}}, {{0, 0, 0}, {4 * side, 0, 0}, {0, 4 * side, 0}}};
}

PolygonQuery as_polygon(const Query& query) {
  const Triangle& t = query.triangle;
  PolygonQuery polygon{query.probe, {}};
  polygon.polygon.add(std::vector<Point3>{t.a, t.b, t.c});
  return polygon;
}

void ask_another(const Method& method, const Query&, double side) { try_ask(method, other_query(side)); }
void ask_another(const Method& method, const PolygonQuery&, double side) {
  try_ask(method, as_polygon(other_query(side)));
}

template <class Q, class A>
Fault fault_when_asked(const Method& method, const Q& query, const A& first) {
  const Asked<A> again = tried<A>(method, query);
  if (again.fault) return again.fault;
  return say_the_same(plain(again.answer), plain(first)) ? Fault{} : Fault{Status::differs_when_repeated};
}

template <class Q, class A>
Fault fault_when_asked_again(const Method& method, const Q& query, const A& first, int times) {
  for (int i = 0; i < times; ++i) {
    if (const Fault fault = fault_when_asked(method, query, first)) return fault;
    for (const double side : {1.0, -1.0}) {
      ask_another(method, query, side);
      if (const Fault fault = fault_when_asked(method, query, first)) return fault;
    }
  }
  return {};
}

template <class A, class C, class Q>
A asked_or_failed(const Method& method, const Q& query) {
  const Asked<A> asked = tried<A>(method, query);
  if (!asked.fault) return asked.answer;
  const C c{.id = "fault", .query = query};
  throw MethodFault(asked.fault, method.name + ": " + describe(asked.fault) + ", on " + from_case(c).dump());
}

}  // namespace

Asked<Answer> try_ask(const Method& method, const Query& query) { return tried<Answer>(method, query); }

Asked<PolygonAnswer> try_ask(const Method& method, const PolygonQuery& query) {
  return tried<PolygonAnswer>(method, query);
}

Answer ask_or_fail(const Method& method, const Query& query) { return asked_or_failed<Answer, Case>(method, query); }

PolygonAnswer ask_or_fail(const Method& method, const PolygonQuery& query) {
  return asked_or_failed<PolygonAnswer, PolygonCase>(method, query);
}

Fault asked_again(const Method& method, const Query& query, const Answer& first, int times) {
  return fault_when_asked_again(method, query, first, times);
}

Fault asked_again(const Method& method, const PolygonQuery& query, const PolygonAnswer& first, int times) {
  return fault_when_asked_again(method, query, first, times);
}

}  // namespace tribunal
