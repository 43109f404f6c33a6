// Ways to change a question of the user's a little.
#pragma once

#include <span>
#include <string_view>

#include "exact/cases/families/draw.h"
#include "exact/cases/families/family.h"

namespace tribunal {

/// What a mutation draws from beside the question that it changes.
struct Surroundings {
  const Query& other;  ///< another question of the same data
  double extent;       ///< the largest coordinate of the data
  Format format;       ///< the numbers of the question are exact in it, and stay so
};

struct Mutation {
  std::string_view name;
  void (*apply)(Query& query, const Surroundings& around, Draw& draw);
};

/// By ulps, to a grid, onto each other, flipped, aimed: in the order of the family's levels 1, 2, ….
std::span<const Mutation> mutations();

/// Aims a new probe at the target, from elsewhere: what a triangle without a probe gets first.
const Mutation& aiming();

/// Applies the mutation. Draws again, a few times, where nothing is changed by it, or where a number of the question
/// leaves the range of the format; then leaves the question as it was.
void mutate(Query& query, const Mutation& mutation, const Surroundings& around, Draw& draw);

/// The question with its numbers rounded to the format.
Query rounded_to(Query query, Format format);

}  // namespace tribunal
