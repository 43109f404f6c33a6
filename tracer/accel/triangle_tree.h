// Certified closest hit without a scene: triangles in, the nearest exact hit of a ray out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/query.h"
#include "tracer/accel/wide/tree.h"

namespace tribunal {

/// A face that a ray hits. Which one it is was decided by exact parameters; `t` is the parameter in double, for people
/// and pictures, off by less than 2⁻²⁰ of the exact one: by some units in the last place where the filter tells that
/// much, else correctly rounded, so exactly 0 at the ray's origin, subnormal where it must be, and +∞ beyond DBL_MAX.
/// `rounded_parameter` (exact/filtered/rounded_parameter.h) gives the correctly rounded one of any hit.
struct Nearest {
  std::uint32_t id;
  double t;
};

/// A hierarchy of boxes over triangles with finite coordinates; ids are indices into the list given.
///
/// Laws. (1) `closest` is what a test of every triangle by exact arithmetic gives, in the tracer's reading: a
/// triangle that holds the ray in its plane, or has no area, is not hit. (2) A ray that is not finite hits nothing.
/// (3) All const functions may be called from any number of threads at once. (4) Rays in a batch get the ids that they
/// get one by one; t may differ within its bound. (5) Neither the rounding mode nor flush-to-zero of the calling thread
/// changes an answer.
class TriangleTree {
 public:
  explicit TriangleTree(std::span<const Triangle> triangles);

  std::optional<Nearest> closest(const Ray& ray) const;

  /// hits[i] = closest(rays[i]). Takes less time a ray: rays that follow their neighbours walk with them in packets,
  /// and of rays that have nothing to do with each other many are under way at once. A few of each call tell which
  /// these are; best a thousand in a call, and neighbours next to each other. Both have the same length, else
  /// std::invalid_argument is thrown. Nothing is allocated.
  void closest(std::span<const Ray> rays, std::span<std::optional<Nearest>> hits) const;

  /// Memory in all: boxes, triangles, ids.
  std::size_t bytes() const;

 private:
  WideTree tree_;
};

}  // namespace tribunal
