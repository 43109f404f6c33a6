// What a method is asked: a probe (segment, ray or part of a ray) against a target (triangle or polygon).
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "core/operands.h"
#include "core/polygon.h"

namespace tribunal {

using Target = std::variant<Triangle, PolygonData>;

/// The kinds of target, in the order of `Target`.
enum class Operands : std::uint8_t { triangles, polygons };

struct Query {
  Probe probe{};
  Target target{};
  std::optional<Bounds> bounds{};  ///< of a ray against a triangle: only the part within them is asked about

  Operands operands() const { return static_cast<Operands>(target.index()); }

  /// The target as a triangle or as a polygon; throws std::bad_variant_access if it is the other.
  const Triangle& triangle() const { return std::get<Triangle>(target); }
  Triangle& triangle() { return std::get<Triangle>(target); }
  const PolygonData& polygon() const { return std::get<PolygonData>(target); }
  PolygonData& polygon() { return std::get<PolygonData>(target); }
};

inline Query as_query(const TrianglePair& pair) { return {pair.probe, pair.triangle}; }

/// The target must be a triangle, and the probe without bounds: a pair has none.
inline TrianglePair pair_of(const Query& query) { return {query.probe, query.triangle()}; }

inline bool is_of_ray(const Query& query) { return std::holds_alternative<Ray>(query.probe); }

inline bool is_finite(const Probe& probe) {
  return std::visit([](const auto& p) { return is_finite(p); }, probe);
}

inline bool is_finite(const Query& query) {
  const auto finite = [](const auto& target) { return is_finite(target); };
  return is_finite(query.probe) && std::visit(finite, query.target) && (!query.bounds || is_finite(*query.bounds));
}

}  // namespace tribunal
