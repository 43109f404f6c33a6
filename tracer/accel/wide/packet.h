// Up to eight probes that walk down the tree together, each on a lane of its own: neighbours on the screen visit the
// same boxes and ask the same faces.
// Source of the idea: Wald, Slusallek, Benthin, Wagner, "Interactive Rendering with Coherent Ray Tracing", CGF 20(3),
// 2001.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "exact/filtered/polygon_figures.h"
#include "tracer/accel/wide/tree.h"

namespace tribunal {

using namespace detail;

inline constexpr std::size_t packet_size = 8;

/// Probes by columns: source, and target of a segment or direction of a ray.
struct ProbePacket {
  alignas(64) double source[3][packet_size] = {}, target[3][packet_size] = {};
  alignas(64) double excluded[2][packet_size] = {};  ///< ids of two excluded faces of each probe
  unsigned lanes = 0;                                ///< the lanes that hold a probe, a bit each

  void set(std::size_t lane, const Point3& from, const Point3& to, std::uint32_t face = ~0U,
           std::uint32_t other = ~0U) {
    for (int i = 0; i < 3; ++i) source[i][lane] = from[i], target[i][lane] = to[i];
    excluded[0][lane] = face;
    excluded[1][lane] = other;
    lanes |= 1U << lane;
  }
};

/// What the walk of a packet found. A lane is not `known` if the filter failed for one of its faces, or two hits were
/// too close to be ordered by their bounds, or its probe is not finite or outside the range of the boxes' binary32:
/// its query must then be answered on its own.
struct PacketAnswer {
  unsigned known = 0;                          ///< lanes whose answer is certain
  unsigned hit = 0;                            ///< of these, the lanes of which the probe hits a face
  unsigned close = 0;                          ///< of these, the lanes of which t has a relative error below 2⁻²⁰
  alignas(64) double id[packet_size] = {};     ///< for rays: the first face hit
  alignas(64) double t[packet_size] = {};      ///< its parameter; means nothing unless close
  alignas(64) double tests[packet_size] = {};  ///< faces of which the lane's answer was certain

  // Of all lanes together: certain answers about a face, those that said hit, and box tests.
  std::uint64_t triangle_tests = 0, triangle_hits = 0, polygon_tests = 0, polygon_hits = 0, boxes = 0;

  std::uint64_t boxes_visited =
      0;  ///< boxes that the packet tested; `boxes` is eight times that if all lanes took part in each
};

/// The faces that packets are tested against: the tree, and the polygons among its primitives.
struct PacketFaces {
  const WideTree& tree;
  std::span<const std::int32_t> polygon_of;  ///< of face id: an index into polygons, −1 for triangles
  std::span<const PolygonFigures> polygons;
};

/// Laws, for the lanes that are known. `first_hits` finds the face on the ray with the least exact t, and no other
/// face is hit at that t. `any_hits` finds whether the segment meets any face; if so, it meets one in general
/// position: away from the segment's ends and from the face's boundary.
struct PacketTarget {
  void (*first_hits)(const PacketFaces&, const ProbePacket&, PacketAnswer&);
  void (*any_hits)(const PacketFaces&, const ProbePacket&, PacketAnswer&);
};

extern const PacketTarget packet_avx512, packet_avx2, packet_portable;

/// The functions for the instruction set that the batch uses too (exact/filtered/batch.h).
const PacketTarget& packet_target();

}  // namespace tribunal
