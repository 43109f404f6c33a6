// The two queries of a ray tracer, the closest face and any face, answered by the method on trial alone.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/kernel.h"
#include "exact/filtered/filtered_polygon.h"
#include "tracer/accel/wide/packet.h"
#include "tracer/shading/known_faces.h"

namespace tribunal {

/// The answer to one query of the tracer. If the images of two methods differ, their decisions differ first.
struct Decision {
  RayKind kind;
  Probe probe;
  std::int64_t outcome;  ///< the primitive hit, −1 for none; for shadow rays 1 if blocked, 0 if not
};

/// Whether an answer is a hit in the tracer's reading, which is that of the paper: a face seen edge-on is not hit,
/// and neither is one without area.
inline bool is_visible_hit(const Answer& a) {
  return a.status == Status::ok && a.hit && a.contact != Contact::coplanar;
}

/// Whether a hit blocks the light: 0 < t < 1, if the method says which end is met. A surface through the light or
/// through the start of the shadow ray does not block.
inline bool is_blocking_hit(const Answer& a) { return is_visible_hit(a) && a.at != At::source && a.at != At::target; }

/// Whether the tracer takes the answer for a hit: rays look for the closest face, segments for what blocks the light.
inline bool is_hit_in_picture(const Probe& probe, const Answer& a) {
  return std::holds_alternative<Ray>(probe) ? is_visible_hit(a) : is_blocking_hit(a);
}

/// The query for the closest face on a ray, its answer, and what the answer cost.
struct RayQuestion {
  Ray ray;
  std::uint32_t excluded =
      no_face;  ///< the excluded face; its test is skipped, but counts as one that the filter decided
  std::optional<std::uint32_t> face{};
  Cost cost{};
};

/// The query whether a segment meets any face, its answer, and what the answer cost.
struct SegmentQuestion {
  Segment way;
  /// Excluded faces: those that the segment is known not to meet, and for Visibility::met also those that are to be
  /// ignored. Visibility::blocked uses the first alone.
  std::array<std::uint32_t, 2> excluded{no_face, no_face};
  bool met = false;
  Cost cost{};
};

/// Answers the queries of the tracer by one method in one world. Not thread-safe: one object per thread, which counts
/// into the caller's tally. Prepares every polygon.
///
/// Which faces are tested depends on the world's acceleration; the answers do not. If the method's filter runs on
/// vector lanes, then in mode `bvh` the method tests only faces for which the filter fails there; the other tests
/// count as decided by the filter.
class Visibility {
 public:
  Visibility(const World& world, const Method& method, RayTally& tally);

  /// The first face on each ray: the one with the smallest t by the method's order of hits, or by its t if it has no
  /// such order, or else by t in double. Equal hits: the lowest id. A ray that is not finite hits nothing.
  ///
  /// The tree is pruned by a proved bound: a face that is exactly hit lies in its box, so t is at most the upper end
  /// of the ray's span in that box, and boxes that the ray enters later hold only later hits. Only an inexact method
  /// that reports hits outside a face's box can answer differently with and without a tree.
  void first_hits(std::span<RayQuestion> questions);

  /// Finds for each segment, from the start of a shadow ray to a light, whether a face blocks it.
  void blocked(std::span<SegmentQuestion> questions);

  /// Finds for each closed segment whether it meets any face. The tests count as start_tests. A segment that is not
  /// finite counts as one that meets a face.
  void met(std::span<SegmentQuestion> questions);

  /// The same for a single probe.
  std::optional<std::uint32_t> first_hit(const Ray& ray, std::uint32_t excluded = no_face);
  bool is_blocked(const Segment& way, std::uint32_t excluded = no_face);
  bool meets_any(const Segment& way, std::array<std::uint32_t, 2> excluded);

  /// Whether a segment whose ends lie strictly on either side of this face's plane meets the face. Counted as a
  /// start_test.
  bool passes_through(const Segment& way, std::uint32_t id);

  /// Whether the probe hits this face by the method's answer, in the tracer's reading.
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

  /// Calls hit(id) for faces that the segment certainly hits, and other(id) for those that the method must test,
  /// until one of the calls returns true. Returns how many triangles were certainly missed.
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
  std::vector<FilteredPolygon> filtered_;  ///< in place of prepared_, if the method filters
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
