// Queries and exact answers in words.
#pragma once

#include <string>

#include "exact/polygon/judge.h"

namespace tribunal {

/// "hit (edge)", with the class or planarity.
std::string describe(const Truth& truth);
std::string describe(const PolygonTruth& truth);

/// One line a point, indented.
std::string points_of(const Query& query);
std::string points_of(const PolygonQuery& query);

/// What an id says of a counterexample: "C017", "ray"; "edge", "interior-not-planar".
std::string id_part(const Truth& truth);
std::string id_part(const PolygonTruth& truth);

}  // namespace tribunal
