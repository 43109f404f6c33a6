// The exact truth of a ray and a surface: which faces the ray meets, where and in which order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/contract.h"
#include "core/due.h"
#include "tracer/leak/aim.h"

namespace tribunal::leak {

/// A face that the ray crosses: met, and not in its plane.
struct Crossed {
  std::uint32_t face;
  Contact contact;  ///< interior, edge or vertex
  Facing facing;
  int direction;  ///< +1, −1 or 0 as crossing.h counts: how the ray crosses it if moved by an infinitesimal
};

/// The faces that are crossed at one exact parameter: crossed[first] to crossed[end − 1].
struct Place {
  std::size_t first, end;
};

/// The exact truth of a ray and a surface, from exact signs and the exact order of parameters.
struct RayTruth {
  bool on_surface = false;             ///< the ray starts on a face: nothing is judged
  bool inside = false;                 ///< it starts inside; of a closed surface only
  bool at_outline = false;             ///< of the faces around the vertex or edge that it was aimed at, some look
                                       ///< towards its source and some away, so it may pass or graze it
  std::vector<std::uint32_t> along{};  ///< faces with area that are met in their plane
  std::vector<std::uint32_t> flat{};   ///< faces without area that are met
  std::vector<Crossed> crossed{};      ///< by place, at one place by face
  std::vector<Place> places{};         ///< nearest first

  bool touches_nothing() const { return along.empty() && flat.empty() && crossed.empty(); }
  bool crosses(std::uint32_t face) const;
  bool meets(std::uint32_t face) const;
  std::span<const Crossed> at(const Place& p) const { return std::span(crossed).subspan(p.first, p.end - p.first); }
};

/// `candidates` has all faces that the ray meets, in ascending order.
RayTruth truth_of(const Surface& surface, const AimedRay& aimed, std::span<const std::uint32_t> candidates);

/// Whether the ray passes through the surface at the place, so that a watertight test must report a face there. It
/// does if it meets the interior of a face; or if the ray, moved by an infinitesimal, crosses an odd number of faces,
/// and no open edge is near. (If the number is even, the ray touches an edge or a vertex from one side, and a test
/// that gives each edge to one face may report none.) For a test that culls back faces the same holds of front faces:
/// the interior of one is met, or more faces are entered than left.
bool is_passed(const Surface& surface, const RayTruth& truth, const Place& place, Culling culling);

/// Whether the source sees the face edge-on, but for rounding: moved by 16 units in the last place of the largest
/// coordinate, it would be in the face's plane or behind it. Where the ray crosses such a face is not for rounded tests
/// to say, nor whether it does: it is a part of the outline.
bool is_edge_on(const Surface& surface, const Ray& ray, std::uint32_t face);

/// The facing of a face in whose plane the ray does not start, as the source sees it.
Facing facing_of(const Surface& surface, const Ray& ray, std::uint32_t face);

}  // namespace tribunal::leak
