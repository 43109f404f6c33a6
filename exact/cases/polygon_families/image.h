// Exact affine images of polygons and probes with small integer coordinates.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "exact/cases/families/affine.h"
#include "exact/cases/families/family.h"
#include "exact/cases/families/probe.h"

namespace tribunal {

/// A point before the map.
using Lattice3 = std::array<std::int64_t, 3>;

constexpr Lattice3 in_plane(const PlanePoint& x) { return {x.u, x.v, 0}; }

/// A probe before the map: the segment between the two points, or the ray from the one through the other.
struct ProbeEnds {
  Lattice3 from, to;
};

/// Of the points of shapes and of probes that pierce them the coordinates sum to at most 43 = 20 + 20 + 3, so for
/// entries of M of `bits` bits their images, and differences of these, are below 2^(bits + polygon_image_bits).
inline constexpr int polygon_image_bits = 6;

/// Bit lengths of the entries of M that the families sweep.
std::span<const int> polygon_fills(Format format);

/// One of these bit lengths, at random.
int draw_fill(Draw& draw, Format format);

/// A random map with entries of `bits` bits and half of the time an offset that images below 43·2^bits leave room for
/// in the format.
AffineMap draw_polygon_map(Draw& draw, Format format, int bits);

Point3 image(const AffineMap& map, const Lattice3& x);

/// The image of the rings, which lie in the plane w = 0.
PolygonData image(const AffineMap& map, std::span<const PlaneRing> rings);

/// The least and the largest coordinate on one axis of M·x, without offset, for the rings' vertices and both ends.
Extent extent_of(const AffineMap& map, std::size_t axis, std::span<const PlaneRing> rings, const ProbeEnds& ends);

/// The image of the probe, exact. A ray's direction is multiplied by 2^direction_scale, or by a random power of two,
/// which changes no contact. Ends that coincide give a segment that is a point or a direction that is zero.
Probe image(bool is_ray, const AffineMap& map, const ProbeEnds& ends, Format format, Draw& draw,
            std::optional<int> direction_scale = {});

/// A random number from one above the level before up to this level.
int draw_up_to_level(Draw& draw, std::span<const int> levels, std::size_t level);

}  // namespace tribunal
