// Rays aimed at the vertices, edges and faces of a surface: exactly, and next to them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "tracer/leak/surface.h"

namespace tribunal::leak {

/// What a ray was aimed at; `unsaid` of a ray that was made elsewhere.
enum class Aim : std::uint8_t { vertex, edge, face, unsaid };

/// What rays are aimed at here.
inline constexpr Aim all_aims[] = {Aim::vertex, Aim::edge, Aim::face};
inline constexpr std::size_t aim_count = std::size(all_aims);

constexpr std::string_view name_of(Aim a) {
  constexpr std::string_view names[] = {"vertex", "edge", "face", "unsaid"};
  return names[static_cast<int>(a)];
}

/// A ray whose numbers are exact in the surface's format, and the vertex, edge or face that it was aimed at.
struct AimedRay {
  Ray ray;
  Aim aim;
  std::uint32_t at;
};

/// Ray k under a seed; it depends on the arguments alone. Rays are aimed in turn at the next vertex, the next edge
/// and the next face; from outside and, if the surface is closed and an inside point is found, from inside; exactly
/// (if the coordinates allow a source from which the direction is exact), up to rounding, and some units in the last
/// place of one coordinate beside either. Nothing if no source off the surface was found.
std::optional<AimedRay> aimed_ray(const Surface& surface, std::uint64_t seed, std::uint64_t k);

/// The same from outside alone: the source is 2^`distance` times the largest extent of the surface's box away from the
/// box's middle, along the axis on which it is farthest. Needs distance ≥ 0, and a source within the format.
std::optional<AimedRay> aimed_ray_from_afar(const Surface& surface, int distance, std::uint64_t seed, std::uint64_t k);

}  // namespace tribunal::leak
