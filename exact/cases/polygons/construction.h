// All that can be constructed: ring configuration × kind of place × approach.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "exact/cases/polygons/shapes.h"

namespace tribunal {

/// How a probe meets a point of the polygon's plane: it runs through it, or starts or ends there.
enum class Approach : std::uint8_t { through, from, to };

inline constexpr int approach_count = 3;

constexpr std::string_view name_of(Approach a) {
  constexpr std::string_view names[] = {"through", "from", "to"};
  return names[static_cast<int>(a)];
}

/// A probe aimed at a kind of place of a ring configuration.
struct Construction {
  std::size_t shape;  ///< index into all_shapes()
  PolygonPlace place;
  Approach approach;
};

/// The 774 constructions that exist: 258 pairs of a configuration and a place that it has, each pierced through, from
/// and to.
std::span<const Construction> all_constructions();

/// Index into all_constructions().
std::size_t index_of(const Construction& construction);

}  // namespace tribunal
