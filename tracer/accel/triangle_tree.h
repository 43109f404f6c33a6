// Certified hits without a scene: triangles in; out come the closest exact hit of a ray, any, all, and what is inside.
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

/// A triangle that a ray hits. Which one it is was decided by exact parameters. `t` is the parameter in double: off by
/// less than 2⁻²⁰ of the exact one, and mostly by some units in the last place. Where the filter's bounds do not
/// promise as much it is correctly rounded: exactly 0 at the ray's origin, subnormal where it must be, +∞ beyond
/// DBL_MAX. `rounded_parameter` (exact/filtered/rounded_parameter.h) gives the correctly rounded one of any hit.
struct Nearest {
  std::uint32_t id;
  double t;
};

/// How a ray crosses the triangles: how often, and the sum of +1 for each that it leaves by its counterclockwise side
/// and −1 for each that it enters there. A ray through edges and vertices counts as one that was moved by next to
/// nothing, all triangles agreeing how (exact/filtered/crossing.h has the proof). Of a ray that starts on a triangle
/// nothing is counted.
struct Parity {
  bool on_surface = false;
  std::uint64_t crossings = 0;
  std::int64_t winding = 0;

  friend bool operator==(const Parity&, const Parity&) = default;
};

/// Where a point is to a closed mesh. `boundary`: on one of its closed triangles, those without area included.
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

  /// hits[i] = closest(rays[i]). Takes less time a ray: rays that follow their neighbours walk with them in packets,
  /// and of rays that have nothing to do with each other many are under way at once. A few of each call tell which
  /// these are; best a thousand in a call, and neighbours next to each other. Both have the same length, else
  /// std::invalid_argument is thrown. Nothing is allocated.
  void closest(std::span<const Ray> rays, std::span<std::optional<Nearest>> hits) const;

  /// Whether any triangle is hit, by the ray or by the closed segment, ends included.
  bool any(const Ray& ray) const;
  bool any(const Segment& way) const;

  /// met[i] = 1 if any(rays[i]), else 0. Segments go eight at a time where neighbours are alike. The two
  /// lists have the same length, else std::invalid_argument is thrown; so below.
  void any(std::span<const Ray> rays, std::span<std::uint8_t> met) const;
  void any(std::span<const Segment> ways, std::span<std::uint8_t> met) const;

  /// Every triangle hit, by exact parameter, at equal ones by id.
  std::vector<Nearest> all(const Ray& ray) const;
  void all(std::span<const Ray> rays, std::span<std::vector<Nearest>> hits) const;

  /// Law: if every edge belongs to an even number of triangles, `crossings` is odd for all rays from a point or for
  /// none, whatever vertices and edges they meet; if every edge is run along as often one way as the other, `winding`
  /// is the same for all, the winding number of the mesh about the point. `on_surface` depends on the point alone. A
  /// ray without direction counts as one along x.
  Parity parity(const Ray& ray) const;
  void parity(std::span<const Ray> rays, std::span<Parity> counts) const;

  /// Whether a point is inside the closed mesh that the triangles are: whether a ray from it crosses an odd number of
  /// them. Where parts of the mesh overlap, an even number of them is outside; `parity` tells the winding number. Of a
  /// mesh that is not closed the answer is that of one ray. A point that is not finite is outside.
  Side inside(const Point3& p) const;
  void inside(std::span<const Point3> points, std::span<Side> sides) const;

  /// Memory in all: boxes, triangles, ids.
  std::size_t bytes() const;

 private:
  std::shared_ptr<const WideTree> tree_;  ///< copies of a tree share it
};

}  // namespace tribunal
