// The exact truth of a ray and a surface: which faces the ray meets, where and in which order.
#pragma once

#include <algorithm>
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
  std::size_t passage = 0;  ///< the number of the passage that it belongs to
};

/// Places that the ray, moved by rounding, may exchange for one another, with the faces around: from a face to all that
/// share a vertex or an edge with it that the ray passes within rounding (nearness.h), and on from these.
///
/// Claim. On a closed surface the number of crossings of these faces is even or odd for all rays that differ by no more
/// than that, alike; and if it is oriented, the sum of their directions is the same. For the counts change only where a
/// ray passes an edge, all faces of which belong to the passage; crossing.h has the proof. So a test that reports no
/// face of a passage of which the count is odd, or the sum not zero, answers as no ray near this one is answered
/// exactly: it leaks. Where the count is even, rays near this one pass beside the surface: it is seen as outline.
struct Passage {
  std::vector<std::uint32_t> faces{};  ///< ascending
  std::vector<std::size_t> places{};   ///< ascending
  std::uint32_t crossings = 0;         ///< of its faces
  int entered = 0;                     ///< the sum of their directions, with the other sign
  bool at_opening = false;             ///< an open edge, or an end of one, is as near

  bool has(std::uint32_t face) const { return std::ranges::binary_search(faces, face); }
};

/// The exact truth of a ray and a surface, from exact signs and the exact order of parameters.
struct RayTruth {
  bool on_surface = false;             ///< the ray starts on a face: nothing is judged
  bool inside = false;                 ///< it starts inside; of a closed surface only
  bool starts_near = false;            ///< not on a face, but within rounding: it may be taken to start behind it
  std::vector<std::uint32_t> along{};  ///< faces with area that are met in their plane
  std::vector<std::uint32_t> flat{};   ///< faces without area that are met
  std::vector<Crossed> crossed{};      ///< by place, at one place by face
  std::vector<std::uint32_t> crossed_faces{};  ///< the same, ascending, as `along` and `flat` are
  std::vector<Place> places{};                 ///< nearest first
  std::vector<Passage> passages{};             ///< by their first places

  bool touches_nothing() const { return along.empty() && flat.empty() && crossed.empty(); }
  bool crosses(std::uint32_t face) const;
  bool meets(std::uint32_t face) const;
  std::span<const Crossed> at(const Place& p) const { return std::span(crossed).subspan(p.first, p.end - p.first); }
};

/// `candidates` has all faces that the ray meets, in ascending order.
RayTruth truth_of(const Surface& surface, const AimedRay& aimed, std::span<const std::uint32_t> candidates);

/// Whether the ray passes through the surface at the place: it meets the interior of a face; or, moved by an
/// infinitesimal, it crosses an odd number of faces, and no open edge is there. (If the number is even, the ray touches
/// an edge or a vertex from one side, and a test that gives each edge to one face may report none.) For a test that
/// culls back faces the same holds of front faces: the interior of one is met, or more faces are entered than left.
bool is_passed(const Surface& surface, const RayTruth& truth, const Place& place, Culling culling);

/// Whether all rays that differ from this one by no more than rounding pass through the surface in the passage.
bool is_passed(const Surface& surface, const RayTruth& truth, const Passage& passage, Culling culling);

/// The facing of a face in whose plane the ray does not start, as the source sees it.
Facing facing_of(const Surface& surface, const Ray& ray, std::uint32_t face);

}  // namespace tribunal::leak
