// Rays aimed at the vertices, edges and faces of a surface: exactly, and next to them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "tracer/leak/surface.h"

namespace tribunal::leak {

/// What a ray was aimed at.
enum class Aim : std::uint8_t { vertex, edge, face };

inline constexpr Aim all_aims[] = {Aim::vertex, Aim::edge, Aim::face};
inline constexpr std::size_t aim_count = std::size(all_aims);

constexpr std::string_view name_of(Aim a) {
  constexpr std::string_view names[] = {"vertex", "edge", "face"};
  return names[static_cast<int>(a)];
}

/// A ray whose numbers are exact in the surface's format, and the vertex, edge or face that it was aimed at.
struct AimedRay {
  Ray ray;
  Aim aim;
  std::uint32_t at;
};

/// Ray k of a seed, a function of its arguments. In turn: at the next vertex, the next edge, the next face; from
/// outside and from inside, where the surface is closed and has an inside that is found; exactly (where the coordinates
/// allow a source from which the direction is exact), as near as rounding goes, and next to either by some units in the
/// last place of one coordinate of the ray. Nothing if no source off the surface was found.
std::optional<AimedRay> aimed_ray(const Surface& surface, std::uint64_t seed, std::uint64_t k);

}  // namespace tribunal::leak
