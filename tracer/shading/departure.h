// Where secondary rays start.
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

/// A face that a ray leaves behind: the ray starts and runs strictly on one side of its plane, whose sign this is.
struct Behind {
  std::uint32_t face = no_face;
  int side = 0;
};

/// A hit from which rays may depart. `point` is rounded; `normal` is a unit vector on the side of the viewer.
struct HitPoint {
  Point3 origin;  ///< of the ray that hit
  std::uint32_t face;
  Point3 point, normal;
  Behind behind{};  ///< by that ray
};

/// A start on one side of a face.
struct Start {
  Point3 point;
  int side = 0;  ///< where it is proved: the sign of orient3d(a, b, c, point), not zero; else 0
};

/// Where a ray may depart on the side from which the face was hit, and what it cost to know.
struct NearQuestion {
  const HitPoint* at = nullptr;
  Start start{};
  Cost cost{};
};

/// Where it may depart beyond the face. `near` is the answer to the other question.
struct FarQuestion {
  const HitPoint* at = nullptr;
  Start near;
  Start start{};
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

  /// On the side of the origin. Adds what that cost.
  void near_sides(std::span<NearQuestion> questions);

  /// Beyond the face.
  void far_sides(std::span<FarQuestion> questions);

  /// The same of one.
  Start near_side(const HitPoint& at);
  Start far_side(const HitPoint& at, const Start& near);

  /// The face itself, if a probe from a proved start to a point, or in a direction, stays strictly on the start's side
  /// of its plane, and so cannot meet it; else none. Without it each shadow ray would put the question that is
  /// hardest for a filter: whether a point one rounding off a plane lies on it.
  template <class X>
  Behind left_behind(const HitPoint& at, const Start& start, const X& target);

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
  std::vector<SegmentQuestion> ways_;  ///< to first candidates
  std::vector<NearQuestion*> askers_;  ///< whose
};

}  // namespace tribunal
