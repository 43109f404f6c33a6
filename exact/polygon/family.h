// Families of generated polygon cases. Case k of a family under a seed is a pure function of (family, seed, k).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/format.h"
#include "core/polygon.h"
#include "exact/polygon/shapes.h"

namespace tribunal {

/// How a probe has a point of the polygon's plane: it runs through it, or starts or ends there.
enum class Approach : std::uint8_t { through, from, to };

inline constexpr int approach_count = 3;

constexpr std::string_view name_of(Approach a) {
  constexpr std::string_view names[] = {"through", "from", "to"};
  return names[static_cast<int>(a)];
}

/// What the construction of a case proves.
struct Known {
  std::size_t shape;  ///< index into all_shapes()
  PolygonPlace place;
  Approach approach;
};

struct PolygonTrial {
  PolygonQuery query{};
  Format format = Format::binary64;
  std::uint16_t level = 0;  ///< index into PolygonFamily::levels
  std::optional<Known> known{};
};

struct PolygonFamily {
  std::string_view name;
  std::string_view stresses;    ///< one line for people
  std::string_view population;  ///< what a sampled figure is about
  std::string_view axis;        ///< name and unit of the stress axis
  bool constructs;              ///< every case knows its construction, and all of them are drawn
  std::span<const int> (*levels)(Format);
  PolygonTrial (*make)(Format format, std::uint64_t seed, std::uint64_t k);
};

std::span<const PolygonFamily> all_polygon_families();

const PolygonFamily* find_polygon_family(std::string_view name);

}  // namespace tribunal
