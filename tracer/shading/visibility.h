// The two questions that a ray tracer asks, answered by the method on trial and by nothing else.
#pragma once

#include <optional>
#include <vector>

#include "core/kernel.h"
#include "tracer/world.h"

namespace tribunal {

/// One answer to one of the questions: what differs between two methods' images differs here first.
struct Decision {
  RayKind kind;
  Probe probe;
  std::int64_t outcome;  ///< the primitive hit, −1 for none; for shadow rays 1 if blocked, 0 if not
};

/// The paper's reading of an answer: a face seen edge-on is not hit, and neither is one without area.
inline bool is_visible_hit(const Answer& a) {
  return a.status == Status::ok && a.hit && a.contact != Contact::coplanar;
}

/// A hit that blocks the light: 0 < t < 1, as far as the method can tell. A surface through the light itself or
/// through the start of the shadow ray does not block.
inline bool is_blocking_hit(const Answer& a) { return is_visible_hit(a) && a.at != At::source && a.at != At::target; }

/// One method looking at a world. One object a thread; counts into the caller's tally.
class Visibility {
 public:
  Visibility(const World& world, const Method& method, Tally& tally) : world_(world), method_(method), tally_(tally) {}

  /// The first triangle on the ray: smallest t by the method's own order of hits (by t in double if it has none),
  /// ties by lowest primitive id. A ray that overflowed hits nothing.
  ///
  /// The tree is pruned by a proved bound: a triangle that is exactly hit lies in its box, so t is at most the upper
  /// end of the ray's span in that box; boxes whose span begins later hold only later hits. Only an inexact method
  /// that reports hits outside a triangle's box can answer differently with and without a tree.
  std::optional<std::uint32_t> first_hit(const Ray& ray);

  /// Whether something blocks the light on its way.
  bool is_blocked(const Segment& way);

  const World& world() const { return world_; }

 private:
  bool is_nearer(const Ray& ray, std::uint32_t id, std::uint32_t best) const;

  const World& world_;
  const Method& method_;
  Tally& tally_;
  BoxTree::Stack stack_;
};

/// Whether the method counts this triangle as a hit of this probe, as the tracer reads it.
bool sees(const Method& method, const Probe& probe, const Triangle& t);

/// The triangles that the tree offers for a probe, without pruning.
std::vector<std::uint32_t> candidates(const World& world, const Probe& probe);

/// Parameter of the hit in double, from signed volumes: for shading, and for methods without an order of their own.
inline double shading_parameter(const Ray& r, const Triangle& t) {
  const HitParameter<double> p = hit_parameter<double>(r, t);
  return p.num / p.den;
}

}  // namespace tribunal
