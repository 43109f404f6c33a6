#include <cmath>
#include <optional>
#include <variant>

#include "exact/classes/class_table.h"
#include "exact/filtered/hit_fraction.h"
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

/// The query without its bounds, about the whole ray.
Query without_bounds(const Query& query) { return {query.probe, query.target}; }

/// The truth about a query without bounds.
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

// --- rays with bounds ------------------------------------------------------------------------------------------------

/// Carathéodory's theorem on the exact points o + tmin·d and o + tmax·d, or on the first and the direction.
bool meets_within_by_caratheodory(const Query& query) {
  return decide_within(std::get<Ray>(query.probe), *query.bounds, [&](const auto& part) {
    return tribunal::meets_by_caratheodory<Dyadic>(part, query.triangle());
  });
}

/// Which part of the probe the fraction is at; nothing if it lies outside of the bounds.
std::optional<At> place_of(const mpq_class& t, const Bounds& bounds) {
  if (t < mpq_class(bounds.tmin)) return {};
  if (t == mpq_class(bounds.tmin)) return At::source;
  if (std::isinf(bounds.tmax)) return At::between;
  if (t > mpq_class(bounds.tmax)) return {};
  return t == mpq_class(bounds.tmax) ? At::target : At::between;
}

/// Where the ray crosses the triangle, the bounds leave the hit or not by its parameter alone.
void require_fit_of_parameter(const Query& query, const Truth& ray, const Truth& part) {
  if (ray.contact == Contact::none || ray.contact == Contact::coplanar) return;
  const auto place = place_of(hit_fraction(std::get<Ray>(query.probe), query.triangle()), *query.bounds);
  const Contact contact = place ? ray.contact : Contact::none;
  if (part.contact == contact && part.at == place.value_or(At::unsaid)) return;
  contradiction(query, part, "the hit's parameter", place.has_value());
}

Truth exact_truth_within(const Query& query, const Truth& ray) {
  const Truth part = narrowed(ray, query, RationalKernel{});
  const bool meets = meets_within_by_caratheodory(query);
  if (meets != part.hit()) contradiction(query, part, "Caratheodory", meets);
  require_fit_of_parameter(query, ray, part);
  return part;
}

Truth exact_truth_without_bounds(const Query& query) {
  static const Method& second = method_with(Role::second_opinion);
  const Truth truth = truth_by_reference(query);
  const bool meets = meets_by_caratheodory(query);
  if (meets != truth.hit()) contradiction(query, truth, "Caratheodory", meets);
  const Answer opinion = second.ask(query);
  if (opinion.status == Status::ok && opinion.hit != truth.hit()) contradiction(query, truth, second.name, opinion.hit);
  return truth;
}

}  // namespace

Truth exact_truth_of_triangle(const Query& query) {
  if (!query.bounds) return exact_truth_without_bounds(query);
  return exact_truth_within(query, exact_truth_without_bounds(without_bounds(query)));
}

}  // namespace tribunal
