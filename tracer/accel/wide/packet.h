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
  alignas(64) double excluded[2][packet_size] = {};  ///< ids of faces that do not matter to the probe
  unsigned lanes = 0;                                ///< where a probe is, a bit each

  void set(std::size_t lane, const Point3& from, const Point3& to, std::uint32_t face = ~0U,
           std::uint32_t other = ~0U) {
    for (int i = 0; i < 3; ++i) source[i][lane] = from[i], target[i][lane] = to[i];
    excluded[0][lane] = face;
    excluded[1][lane] = other;
    lanes |= 1U << lane;
  }
};

/// What a walk found. A lane that is not `known` met a face of which doubles cannot tell, or two hits that are too
/// close to order, or its probe is not finite or beyond what the boxes' binary32 can hold: it is to be asked alone.
struct PacketAnswer {
  unsigned known = 0;                          ///< lanes whose answer is certain
  unsigned hit = 0;                            ///< of these: whose probe hits a face
  unsigned close = 0;                          ///< of these: whose t is within 2⁻²⁰ of the exact one, relatively
  alignas(64) double id[packet_size] = {};     ///< the first face hit, of rays
  alignas(64) double t[packet_size] = {};      ///< where, in double; any number unless close
  alignas(64) double tests[packet_size] = {};  ///< certain answers about a face

  // Of all lanes together: certain answers about a face, those that said hit, and box tests.
  std::uint64_t triangle_tests = 0, triangle_hits = 0, polygon_tests = 0, polygon_hits = 0, boxes = 0;

  std::uint64_t boxes_visited =
      0;  ///< by the packet: were all lanes at work in each, `boxes` would be eight times that
};

/// The faces that packets are asked about: a tree, and what its primitives are that are no triangles.
struct PacketFaces {
  const WideTree& tree;
  std::span<const std::int32_t> polygon_of;  ///< of face id: an index into polygons, −1 for triangles
  std::span<const PolygonFigures> polygons;
};

/// Laws, for the lanes that are known. `first_hits`: the face on the ray with the least exact t; no other is at that t.
/// `any_hits`: whether the segment meets any face; where it does, it certainly does so in general position, away from
/// its own ends and from the face's boundary.
struct PacketTarget {
  void (*first_hits)(const PacketFaces&, const ProbePacket&, PacketAnswer&);
  void (*any_hits)(const PacketFaces&, const ProbePacket&, PacketAnswer&);
};

extern const PacketTarget packet_avx512, packet_avx2, packet_portable;

/// That of the batch's target in use (exact/filtered/batch.h).
const PacketTarget& packet_target();

}  // namespace tribunal
