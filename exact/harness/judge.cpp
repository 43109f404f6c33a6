#include "exact/harness/judge.h"

namespace tribunal {

bool promises(const Method& method, const Truth& truth) {
  if (truth.operands() == Operands::triangles) return true;
  const PolygonPromise& promise = method.polygon_promise;
  return (truth.planar || promise.surface) && (!truth.boundary || promise.boundary);
}

bool promises_all(const Method& method, Operands operands) {
  return operands == Operands::triangles || (method.polygon_promise.boundary && method.polygon_promise.surface);
}

Answer within_contract(const Method& method, const Truth& truth, const Answer& answer) {
  return answer.status != Status::ok || promises(method, truth) ? answer : refusal(Status::unsupported);
}

Judgement judge(const Method& method, const Truth& truth, const Answer& answer) {
  if (within_contract(method, truth, answer).status != Status::ok) return Judgement::unsupported;
  if (method.exact && answer.planar != truth.planar) return Judgement::wrong;
  return answer.hit == counts_as_hit(truth.contact, method.convention) ? Judgement::right : Judgement::wrong;
}

}  // namespace tribunal
