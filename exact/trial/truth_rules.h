// The parts of the exact answer that differ between triangles and polygons.
#pragma once

#include <string>
#include <variant>

#include "core/due.h"
#include "core/segura_feito.h"
#include "exact/trial/truth.h"

namespace tribunal {

/// From which side the probe crosses the triangle, where the contact says that it crosses.
template <Kernel K>
Facing facing_in(Contact contact, const Query& query, const K& k) {
  if (contact == Contact::none || contact == Contact::coplanar) return Facing::unsaid;
  return std::visit([&](const auto& probe) { return facing(probe, query.triangle(), k); }, query.probe);
}

/// What the bounds leave of the truth about a ray and a triangle, by the signs of the kernel. Without bounds, the truth
/// as it is.
template <BoundsKernel K>
Truth narrowed(Truth truth, const Query& query, const K& k) {
  if (!query.bounds) return truth;
  truth.bounded = true;
  if (!truth.hit()) return truth;  // a part of what is missed is missed
  const Answer part = segura_feito(std::get<Ray>(query.probe), *query.bounds, query.triangle(), k);
  truth.contact = part.contact;
  truth.at = part.at;
  truth.at_origin = part.at == At::source && query.bounds->tmin == 0;
  if (!part.hit) truth.facing = Facing::unsaid;
  return truth;
}

/// The target must be a triangle.
Truth exact_truth_of_triangle(const Query& query);

/// The target must be a polygon.
Truth exact_truth_of_polygon(const Query& query);

/// Ends the run with both witnesses and the query.
[[noreturn]] void contradiction(const Query& query, const std::string& one, const std::string& other);

}  // namespace tribunal
