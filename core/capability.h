// What a method can do besides answering hit or miss, as values.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/method.h"

namespace tribunal {

enum class Capability : std::uint8_t {
  contact,            ///< says which part of the target is met
  order,              ///< orders two hits on a ray
  parameter,          ///< yields the parameter t of a hit
  class_id,           ///< tells the class of a probe and a triangle
  batch,              ///< answers many queries at once
  prepared_triangle,  ///< prepares a triangle
  prepared_polygon,   ///< prepares a polygon
  prepared_ray,       ///< prepares a ray
  tree_lanes,         ///< its filter is the one that the tree's vector lanes compute
  bounds,             ///< takes rays with bounds on t
  side,               ///< says from which side a triangle is crossed
  weights,            ///< yields the parameter of a hit together with its barycentric weights, where it computes them
  exact_twin          ///< has an exact twin: the same test on exact numbers
};

inline constexpr std::array all_capabilities = {Capability::contact,
                                                Capability::order,
                                                Capability::parameter,
                                                Capability::class_id,  //
                                                Capability::batch,
                                                Capability::prepared_triangle,
                                                Capability::prepared_polygon,
                                                Capability::prepared_ray,
                                                Capability::tree_lanes,
                                                Capability::bounds,
                                                Capability::side,
                                                Capability::weights,
                                                Capability::exact_twin};

constexpr std::string_view name_of(Capability c) {
  constexpr std::string_view names[] = {
      "contact",      "order", "parameter", "class", "batch",   "prepared triangle", "prepared polygon",
      "prepared ray", "lanes", "bounds",    "side",  "weights", "exact twin"};
  return names[static_cast<int>(c)];
}

inline bool has(const Method& m, Capability c) {
  const bool held[] = {
      m.tells_contact,        m.compare_hits != nullptr,     m.parameter != nullptr, m.classify != nullptr,
      m.batch != nullptr,     m.prepare_triangle != nullptr, m.polygon != nullptr,   m.prepare_ray != nullptr,
      m.on_tree_lanes,        m.within != nullptr,           m.tells_side,           m.hit != nullptr,
      m.exact_twin != nullptr};
  return held[static_cast<std::size_t>(c)];
}

}  // namespace tribunal
