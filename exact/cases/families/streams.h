// The register of random streams: who draws under which number. Draws under one number, seed and case are the same
// draws, so two owners that could draw in one run must not share a number.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace tribunal {

/// Numbers first … first + count − 1, and who draws under them.
struct RandomStreams {
  std::string_view owner;
  std::uint32_t first, count = 1;
};

/// A number, once given, never changes: seeds in logs and counterexamples name the cases drawn under it.
inline constexpr RandomStreams random_streams[] = {
    {"family affine", 1},
    {"family ulp", 2},
    {"family offset", 3},
    {"family scale", 4},
    {"family zeros", 5},
    {"family midpoint", 6},
    {"family sliver", 7},
    {"family grazing", 8},
    {"family distance", 9},
    {"family near", 10},
    {"family flip", 11},
    {"family shared", 12},
    {"family mesh", 13},
    {"family aimed", 14},
    {"family tilt", 15},
    {"family spread", 16},
    {"family extreme", 17},
    {"family overflow", 18},
    {"family direction", 19},
    {"family size", 20},
    {"family plain", 21},
    {"family bounds", 22},
    {"family own-cases", 23},
    {"family own-mesh", 24},
    {"family own-scene", 25},
    {"polygon family affine", 101},
    {"polygon family scale", 102},
    {"polygon family ulp", 103},
    {"polygon family in-plane", 104},
    {"polygon family grid", 105},
    {"polygon family warped", 106},
    {"polygon family rounded", 107},
    {"polygon family many", 108},
    {"polygon family zeros", 109},
    {"polygon family extreme", 110},
    {"polygon family overflow", 111},
    {"polygon family distance", 112},
    {"polygon family direction", 113},
    {"polygon family point", 114},
    {"polygon family spread", 115},
    {"polygon family size", 116},
    {"polygon relations", 200, 100},
    {"benchmark pairs", 900, 3},
    {"benchmark rays", 910},
    {"benchmark polygons", 950, 2},
    {"triangle relations", 1000, 100},
    {"chart general", 1100},
    {"leak rays", 1200},
    {"sweep scale", 1300},
    {"sweep scale-one", 1301},
    {"sweep offset", 1302},
    {"sweep sliver", 1303},
    {"sweep grazing", 1304},
    {"sweep distance", 1305},
    {"sweep fill", 1306},
    {"sweep ulps", 1307},
    {"sweep direction", 1308},
    {"sweep spread", 1309},
    {"sweep vertices", 1310},
    {"sweep polygon-fill", 1311},
    {"sweep polygon-scale", 1312},
    {"sweep afar", 1313},
};

/// Whether the rows are in ascending order and no number has two owners.
constexpr bool are_disjoint(auto&& streams) {
  std::uint64_t next = 0;
  for (const RandomStreams& s : streams) {
    if (s.first < next || s.count == 0) return false;
    next = std::uint64_t{s.first} + s.count;
  }
  return true;
}

static_assert(are_disjoint(random_streams));
static_assert(!are_disjoint(std::array<RandomStreams, 2>{{{"relations", 1000, 2}, {"chart", 1001}}}));
static_assert(!are_disjoint(std::array<RandomStreams, 2>{{{"one", 2}, {"other", 1}}}), "in ascending order");

/// The streams of an owner. A call for an owner that is not in the register does not compile.
consteval RandomStreams streams_owned_by(std::string_view owner) {
  for (const RandomStreams& s : random_streams) {
    if (s.owner == owner) return s;
  }
  throw "not in the register of random streams";
}

consteval std::uint32_t stream_of(std::string_view owner) { return streams_owned_by(owner).first; }

}  // namespace tribunal
