// Queries and exact answers in words.
#pragma once

#include <string>

#include "exact/trial/truth.h"

namespace tribunal {

/// "hit (edge)", with the class or planarity.
std::string describe(const Truth& truth);

/// One line a point, indented.
std::string points_of(const Query& query);

/// What an id says of a counterexample: "C017", "R003"; "edge", "interior-not-planar".
std::string id_part(const Truth& truth);

}  // namespace tribunal
