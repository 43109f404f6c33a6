// The two questions that a ray tracer asks, answered by the method on trial and by nothing else.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/kernel.h"
#include "exact/filtered/filtered_polygon.h"
#include "tracer/accel/wide/packet.h"
#include "tracer/shading/known_faces.h"

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

/// Which face a ray meets first, and what it cost to know.
struct RayQuestion {
  Ray ray;
  std::uint32_t excluded =
      no_face;  ///< a face that the caller knows the ray not to meet: it counts as asked, but is not
  std::optional<std::uint32_t> face{};
  Cost cost{};
};

/// Whether a segment meets any face, and what it cost to know.
struct SegmentQuestion {
  Segment way;
  /// Faces that are known not to be met; of `met` also faces that do not matter. `blocked` looks at the first alone.
  std::array<std::uint32_t, 2> excluded{no_face, no_face};
  bool met = false;
  Cost cost{};
};

/// One method looking at a world. One object a thread; counts into the caller's tally. Prepares every polygon.
///
/// Which faces are asked depends on the world's acceleration; the answers do not. In mode `bvh` a method whose filter
/// runs on vector lanes is asked only of faces of which those are not certain; the certain ones count as tests that the
/// filter decided.
class Visibility {
 public:
  Visibility(const World& world, const Method& method, RayTally& tally);

  /// The first face on each ray: smallest t by the method's own order of hits (by its t if it has none, else by t in
  /// double), ties by lowest primitive id. A ray that overflowed hits nothing.
  ///
  /// The tree is pruned by a proved bound: a face that is exactly hit lies in its box, so t is at most the upper
  /// end of the ray's span in that box; boxes whose span begins later hold only later hits. Only an inexact method
  /// that reports hits outside a face's box can answer differently with and without a tree.
  void first_hits(std::span<RayQuestion> questions);

  /// Whether something blocks the light on its way.
  void blocked(std::span<SegmentQuestion> questions);

  /// Whether a closed segment, ends included, meets any face. Counted as start_tests. A segment that is not finite
  /// meets one.
  void met(std::span<SegmentQuestion> questions);

  /// The same of one.
  std::optional<std::uint32_t> first_hit(const Ray& ray, std::uint32_t excluded = no_face);
  bool is_blocked(const Segment& way, std::uint32_t excluded = no_face);
  bool meets_any(const Segment& way, std::array<std::uint32_t, 2> excluded);

  /// Whether a segment whose ends lie strictly on either side of this face's plane meets the face. Counted as a
  /// start_test.
  bool passes_through(const Segment& way, std::uint32_t id);

  /// Whether the method counts this face as a hit of this probe, as the tracer reads it.
  bool sees(const Probe& probe, std::uint32_t id) const;

  const World& world() const { return world_; }

 private:
  struct Judge;

  template <class Question, class Together, class Alone>
  void answer(std::span<Question> questions, const Together& together, const Alone& alone);
  template <bool starts, class Alone>
  void any_met(std::span<SegmentQuestion> questions, const Alone& alone);
  void count_packet(const PacketAnswer& answer);
  PacketFaces packet_faces() const;

  std::optional<std::uint32_t> first_in_tree(const Ray& ray, std::uint32_t excluded);
  std::optional<std::uint32_t> first_in_list(const Ray& ray, std::uint32_t excluded);

  /// Calls hit(id) for all hits on a segment, and other(id) for faces that are to be asked, until one returns true.
  /// Returns how many triangles were certainly missed.
  template <class Hit, class Other>
  std::uint64_t along(const Segment& way, RayTally& tally, const Hit& hit, const Other& other);

  template <class P>
  bool is_worth_asking(const P& probe, double limit, std::uint32_t id, RayTally& tally) const;

  template <class P>
  Answer ask(const P& probe, std::uint32_t id) const;
  template <class P>
  Answer ask_counted(const P& probe, std::uint32_t id, std::uint32_t excluded);
  void count_certain(std::uint64_t tests, std::uint64_t hits);
  Sign order(const Ray& ray, std::uint32_t id, std::uint32_t other) const;
  double parameter(const Ray& ray, const Triangle& t) const;

  const World& world_;
  const Method& method_;
  const bool filters_;  ///< the method's filter runs on the tree's lanes
  RayTally& tally_;
  std::vector<PreparedPolygon> prepared_;
  std::vector<FilteredPolygon> filtered_;  ///< instead, if it filters
  std::vector<PolygonFigures> figures_;
  BoxedFaces::Waiting waiting_;
};

/// The faces that the acceleration offers for a probe, without pruning.
std::vector<std::uint32_t> candidates(const World& world, const Probe& probe);

/// Parameter of the hit in double, from signed volumes: for shading, and for methods without an order of their own.
inline double shading_parameter(const Ray& r, const Triangle& t) {
  const HitParameter<double> p = hit_parameter<double>(r, t);
  return p.num / p.den;
}

}  // namespace tribunal
