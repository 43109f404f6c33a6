// Exact queries of a set of triangles: the closest hit of a ray, any hit, all hits, and whether a point is inside.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/operands.h"

namespace tribunal {

class WideTree;

/// A triangle that a ray hits. Which triangle is the closest was decided by exact parameters. `t` is the parameter in
/// double: its relative error is below 2⁻²⁰, and mostly some units in the last place. Where the filter's bounds do
/// not guarantee this, t is correctly rounded: exactly 0 at the ray's origin, subnormal where it must be, +∞ beyond
/// DBL_MAX. `rounded_parameter` (exact/filtered/rounded_parameter.h) gives the correctly rounded parameter of any
/// hit.
struct Nearest {
  std::uint32_t id;
  double t;
};

/// How a ray crosses the triangles: how often, and the sum of +1 for each triangle that it crosses towards the side
/// from which the vertices are seen counterclockwise, and −1 for each that it crosses away from that side. A ray
/// through edges and vertices is counted as if it had been moved by an infinitesimal, the same for all triangles
/// (exact/filtered/crossing.h has the proof). For a ray that starts on a triangle nothing is counted.
struct Parity {
  bool on_surface = false;
  std::uint64_t crossings = 0;
  std::int64_t winding = 0;

  friend bool operator==(const Parity&, const Parity&) = default;
};

/// Where a point lies with respect to a closed mesh. `boundary`: on one of its closed triangles, those without area
/// included.
enum class Side : std::uint8_t { outside, inside, boundary };

/// A hierarchy of boxes over triangles with finite coordinates; ids are indices into the list given.
///
/// Laws. (1) `closest`, `any` and `all` are what a test of every triangle by exact arithmetic gives, in the tracer's
/// reading: a triangle that holds the ray in its plane, or has no area, is not hit. (2) A ray that is not finite hits
/// nothing. (3) All const functions may be called from any number of threads at once. (4) Rays in a batch get the ids
/// that they get one by one; t may differ within its bound. (5) Neither the rounding mode nor flush-to-zero of the
/// calling thread changes an answer.
class TriangleTree {
 public:
  explicit TriangleTree(std::span<const Triangle> triangles);

  std::optional<Nearest> closest(const Ray& ray) const;

  /// hits[i] = closest(rays[i]), in less time per ray: rays that take nearly the same path as their neighbours in the
  /// list walk in packets, other rays walk as a stream, many in turn. Samples within the call decide which of the
  /// two is used; it is best to pass a thousand rays or more, with similar rays next to each other. Throws
  /// std::invalid_argument if the lists differ in length. Allocates nothing.
  void closest(std::span<const Ray> rays, std::span<std::optional<Nearest>> hits) const;

  /// Whether any triangle is hit, by the ray or by the closed segment, ends included.
  bool any(const Ray& ray) const;
  bool any(const Segment& way) const;

  /// met[i] = 1 if any(rays[i]), else 0. Segments walk in packets of eight where neighbours in the list are similar.
  /// This and the other batch functions throw std::invalid_argument if the lists differ in length.
  void any(std::span<const Ray> rays, std::span<std::uint8_t> met) const;
  void any(std::span<const Segment> ways, std::span<std::uint8_t> met) const;

  /// Every triangle that the ray hits, in the order of the exact parameter; equal parameters in the order of ids.
  std::vector<Nearest> all(const Ray& ray) const;
  void all(std::span<const Ray> rays, std::span<std::vector<Nearest>> hits) const;

  /// Law: if every edge belongs to an even number of triangles, `crossings` has the same parity for all rays from one
  /// point, whatever vertices and edges they meet. If every edge occurs equally often in either direction, `winding`
  /// is the same for all these rays: the winding number of the mesh about the point. `on_surface` depends on the
  /// point alone. A ray without direction counts as one along x.
  Parity parity(const Ray& ray) const;
  void parity(std::span<const Ray> rays, std::span<Parity> counts) const;

  /// Whether a point is inside the closed mesh that the triangles form: whether a ray from the point crosses an odd
  /// number of triangles. So a point inside an even number of overlapping parts is outside; `parity` gives the
  /// winding number. If the mesh is not closed, the answer is that of one particular ray. A point that is not finite
  /// is outside.
  Side inside(const Point3& p) const;
  void inside(std::span<const Point3> points, std::span<Side> sides) const;

  /// The memory that the tree takes, in bytes: boxes, triangles and ids.
  std::size_t bytes() const;

 private:
  std::shared_ptr<const WideTree> tree_;  ///< copies of a tree share it
};

}  // namespace tribunal
