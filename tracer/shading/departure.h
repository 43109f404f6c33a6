// Where secondary rays start: origins that are proved to lie on the right side of the surface that was hit.
//
// A hit is known exactly, but its point rarely is a double. Whoever starts a shadow or reflected ray at the rounded
// point starts on the wrong side of the surface half of the time; the usual remedy is a constant step along the normal,
// which is too short somewhere (a surface shadows itself) and too long elsewhere (light leaks through a corner).
//
// For an exact method a start S is *proved*:
//
//   near side (shadow, reflection): S lies strictly on the side of the face on which the parent's origin o lies, and
//   the closed segment [o, S] meets no face of the scene;
//   far side (refraction): S lies strictly on the other side, and the closed segment from the near start to S
//   meets exactly one face: the one that was hit.
//
// "Meets" is the method's exact answer in the tracer's reading (a face in whose plane the segment lies does not count),
// asked of every face. By induction each ray of the tree starts in free space and is joined to the eye by a path of
// segments that crosses only faces that were refracted through. So where a closed surface separates eye and
// light, some segment of the path eye – S₁ – … – light meets it, and that is the shadow ray: no light leaks, however
// thin the walls. And no face shadows a point that it does not separate from the light.
//
// The search is short and ends. Candidates for the near side run back along the parent's ray from the rounded hit
// point, by one unit roundoff of the greatest coordinate, then twice that, four times, …: all points of the exact ray
// before the hit are free, and the last candidate is o itself, which is free if the eye is. No candidate is trusted,
// only tested; so rounding in finding them harms nothing. For the far side, candidates go behind the face by the same
// doubling steps, straight and shifted four ways along it, as the hit may lie on an edge, where straight on means
// through two faces. If none is proved within the size of the scene, that is counted, and:
//
//   near side: the eye itself lies on the face; the customary step is taken;
//   far side: no segment crosses this face alone. The ray grazes an edge whose lowest face looks away, so that it
//   does not enter; or faces coincide. The refracted ray then starts where a reflected one does: still no light leaks.
//
// Inexact methods take the customary step always: along the normal by World::step, which is Scene::bias times
// the greatest coordinate.
#pragma once

#include "tracer/shading/visibility.h"

namespace tribunal {

/// An excluded face: the ray starts and runs strictly on one side of its plane, so it cannot meet the face. `side` is
/// the sign of that side.
struct Behind {
  std::uint32_t face = no_face;
  int side = 0;
};

/// A hit from which rays may depart. `point` is rounded; `normal` is a unit vector on the side of the viewer.
struct HitPoint {
  Point3 origin;  ///< the origin of the ray that hit the face
  std::uint32_t face;
  Point3 point, normal;
  Behind behind{};  ///< the excluded face of that ray
};

/// The start of a secondary ray, on one side of the face that was hit.
struct Departure {
  Point3 point;
  int side = 0;  ///< if the start is proved, the sign of orient3d(a, b, c, point), not zero; else 0
};

/// The query for a start on the side from which the face was hit, its answer, and what the answer cost.
struct NearQuestion {
  const HitPoint* at = nullptr;
  Departure start{};
  Cost cost{};
};

/// The query for a start beyond the face. `near` is the start that was found on the side from which it was hit.
struct FarQuestion {
  const HitPoint* at = nullptr;
  Departure near;
  Departure start{};
  Cost cost{};
};

/// Finds starts for one method in one world. One object a thread.
class Departures {
 public:
  Departures(const World& world, const Method& method, Visibility& visibility, KnownFaces& faces, RayTally& tally)
      : world_(world),
        proves_(method.contract.exact && reads_point_sets(method.contract)),
        visibility_(visibility),
        faces_(faces),
        tally_(tally) {}

  /// Finds starts on the side from which the faces were hit, and adds to each query's cost.
  void near_sides(std::span<NearQuestion> questions);

  /// Finds starts beyond the faces that were hit, and adds to each query's cost.
  void far_sides(std::span<FarQuestion> questions);

  /// The same for a single hit.
  Departure near_side(const HitPoint& at);
  Departure far_side(const HitPoint& at, const Departure& near);

  /// The face that was hit, as an excluded face, if the probe from the start to `target` (a point or a direction)
  /// stays strictly on the start's side of its plane; else no face. Without this, each shadow ray would be tested
  /// against the face that it starts next to, for which the filter fails most often.
  template <class X>
  Behind left_behind(const HitPoint& at, const Departure& start, const X& target);

 private:
  Point3 customary(const HitPoint& at, double side) const;
  std::optional<Point3> near_candidate(const HitPoint& at, int k) const;
  Point3 far_candidate(const HitPoint& at, int k) const;
  bool propose_near(NearQuestion& q);
  void search_near(NearQuestion& q, int side, int k);
  void search_far(FarQuestion& q, int side, int k);
  void lead_to(const Point3& candidate, const HitPoint& at, SegmentQuestion& q);
  bool is_near_start(const HitPoint& at, const Point3& candidate, int side);
  bool is_far_start(const HitPoint& at, const Point3& near, const Point3& candidate, int side);
  double smallest_step(const HitPoint& at) const;
  template <class X>
  int side_of(std::uint32_t face, const X& x);

  const World& world_;
  bool proves_;
  Visibility& visibility_;
  KnownFaces& faces_;
  RayTally& tally_;
  std::vector<SegmentQuestion> ways_;  ///< segments to the first candidates
  std::vector<NearQuestion*> askers_;  ///< the queries for which these are tested, in the order of ways_
};

}  // namespace tribunal
