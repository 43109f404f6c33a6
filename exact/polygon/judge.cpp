#include "exact/polygon/judge.h"

#include <cstdlib>

#include "core/segura_feito_polygon.h"
#include "exact/io/failure.h"
#include "exact/io/polygon_case_io.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/oracles/polygon_oracles.h"

namespace tribunal {
namespace {

[[noreturn]] void contradiction(const PolygonQuery& query, const std::string& one, const std::string& other) {
  const PolygonCase witness{.id = "contradiction", .query = query};
  throw Failure(Exit::oracles_contradict,
                "oracles contradict each other: " + one + ", " + other + ", on " + from_case(witness).dump());
}

bool is_boundary(Contact contact) { return contact == Contact::edge || contact == Contact::vertex; }

const char* said(bool hit) { return hit ? "hit" : "no hit"; }

void require_agreement(const PolygonQuery& query, bool reference, const char* oracle, bool answer) {
  if (answer == reference) return;
  contradiction(query, std::string("the reference says ") + said(reference),
                std::string(oracle) + " says " + said(answer));
}

template <class P>
PolygonTruth truth_for(const P& probe, const PolygonQuery& query) {
  const RationalKernel k;
  const Polygon polygon = query.polygon;
  const PolygonAnswer prepared = segura_feito(probe, cover(polygon, k), k);
  const Answer on_the_fly = segura_feito(probe, polygon, k);
  if (on_the_fly != prepared.answer) contradiction(query, "the prepared covering", "that made on the fly");
  const PolygonVerdicts v = ask_oracles<Dyadic>(probe, polygon);
  if (prepared.planar != v.planar) contradiction(query, "planar by volumes", "by normal");
  const bool hit = prepared.answer.hit;
  const bool in_plane = prepared.answer.contact == Contact::coplanar;
  if (v.planar) require_agreement(query, hit, "a generic ray in the plane", v.boundary || v.by_generic_ray);
  if (v.planar) require_agreement(query, hit, "the half-open crossings", v.boundary || v.by_half_open_crossings);
  const bool crossed = std::abs(v.surface_halves) % 4 == 2;
  if (!in_plane) require_agreement(query, hit, "the covering surface", v.boundary || crossed);
  if (!in_plane && is_boundary(prepared.answer.contact) != v.boundary) {
    contradiction(query, "the reference says " + std::string(name_of(prepared.answer.contact)),
                  std::string("Caratheodory that ") + (v.boundary ? "a" : "no") + " ring edge is met");
  }
  return {prepared.answer.contact, prepared.planar, v.boundary};
}

/// What the place says of the contact, where it does: corners and edges that the polygon has twice still are met.
bool fits(const Known& known, const PolygonTruth& truth) {
  if (!truth.planar || truth.hit() != is_met(known.place)) return false;
  const bool on_a_line = truth.contact == Contact::coplanar;
  if (!is_boundary(known.place)) return !truth.hit() || truth.contact == Contact::interior;
  return on_a_line || truth.contact == (is_vertex(known.place) ? Contact::vertex : Contact::edge);
}

}  // namespace

PolygonTruth exact_truth(const PolygonQuery& query) {
  PolygonTruth truth = std::visit([&](const auto& probe) { return truth_for(probe, query); }, query.probe);
  truth.of_ray = std::holds_alternative<Ray>(query.probe);
  return truth;
}

PolygonTruth truth_of(const PolygonTrial& trial) {
  const PolygonTruth truth = exact_truth(trial.query);
  if (trial.known && !fits(*trial.known, truth)) {
    contradiction(trial.query, "constructed as " + std::string(name_of(trial.known->place)),
                  "the oracles say " + std::string(name_of(truth.contact)));
  }
  return truth;
}

bool is_promised(const PolygonPromise& promise, const PolygonTruth& truth) {
  return (truth.planar || promise.surface) && (!truth.boundary || promise.boundary);
}

PolygonAnswer within_contract(const Method& method, const PolygonTruth& truth, const PolygonAnswer& answer) {
  if (answer.answer.status != Status::ok || is_promised(method.polygon_promise, truth)) return answer;
  return {.answer = refusal(Status::unsupported)};
}

Judgement judge(const Method& method, const PolygonTruth& truth, const PolygonAnswer& answer) {
  if (is_fault(answer.answer.status)) return Judgement::wrong;
  if (within_contract(method, truth, answer).answer.status != Status::ok) return Judgement::unsupported;
  if (method.exact && answer.planar != truth.planar) return Judgement::wrong;
  const bool right = answer.answer.hit == counts_as_hit(truth.contact, method.convention);
  return right ? Judgement::right : Judgement::wrong;
}

}  // namespace tribunal
