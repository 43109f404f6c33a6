#include "tracer/shading/departure.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "exact/filtered/filtered_kernel.h"
#include "tracer/shading/camera_rays.h"

namespace tribunal {
namespace {

constexpr int doublings = 64;  ///< from one unit roundoff (2⁻⁵³) to beyond the greatest coordinate

double greatest(const Point3& p) { return std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}); }

bool is_finite_target(const Point3& p) { return is_finite(p); }
bool is_finite_target(const Direction& d) { return is_finite(d.v); }

}  // namespace

/// The exact side of the face's plane on which a point lies, or to which a direction leads; 0 if x is not finite.
template <class X>
int Departures::side_of(std::uint32_t face, const X& x) {
  const KnownFace& known = faces_[face];
  if (const std::optional<Sign> side = known.plane.side(x)) return value(*side);
  if (!is_finite_target(x)) return 0;
  return value(orient3d_exactly(known.triangle, x));
}

Point3 Departures::customary(const HitPoint& at, double side) const {
  return in_format(at.point + side * world_.step * at.normal, world_.format);
}

double Departures::smallest_step(const HitPoint& at) const {
  const double roundoff = world_.format == Format::binary32 ? 0x1p-24 : 0x1p-53;
  return roundoff * std::max(greatest(at.origin), greatest(at.point));
}

/// The k-th candidate on the near side: the rounded hit point moved back along the ray by 2^k smallest steps. None if
/// that is beyond the origin.
std::optional<Point3> Departures::near_candidate(const HitPoint& at, int k) const {
  const Point3 back = at.origin - at.point;
  const double length = greatest(back), step = k == 0 ? smallest_step(at) : std::ldexp(smallest_step(at), k);
  if (k > doublings || !(step < length)) return std::nullopt;
  return in_format(at.point + (step / length) * back, world_.format);
}

/// Makes q the query whether the segment from the origin to the candidate meets a face. Excluded are the face that
/// was hit, since the caller checks that the candidate lies on the origin's side of it, and the face that the ray
/// left behind if the candidate lies on the ray's side of that one.
void Departures::lead_to(const Point3& candidate, const HitPoint& at, SegmentQuestion& q) {
  const Behind& b = at.behind;
  const bool stays = b.face != no_face && side_of(b.face, candidate) == b.side;
  q.way.p = at.origin;
  q.way.q = candidate;
  q.excluded[0] = at.face;
  if (stays) q.excluded[1] = b.face;
}

bool Departures::is_near_start(const HitPoint& at, const Point3& candidate, int side) {
  ++tally_.start_candidates;
  if (side_of(at.face, candidate) != side) return false;
  if (candidate == at.origin) return true;
  SegmentQuestion q;
  lead_to(candidate, at, q);
  return !visibility_.meets_any(q.way, q.excluded);
}

/// Tries the near candidates from the k-th on, one by one; the origin is the last.
void Departures::search_near(NearQuestion& q, int side, int k) {
  const RayTally before = tally_;
  q.start.side = 0;
  for (bool last = side == 0; !last && q.start.side == 0; ++k) {
    const std::optional<Point3> candidate = near_candidate(*q.at, k);
    q.start.point = candidate.value_or(q.at->origin);
    if (is_near_start(*q.at, q.start.point, side)) q.start.side = side;
    last = !candidate;
  }
  if (q.start.side == 0) {
    ++tally_.starts_unproved;
    q.start.point = customary(*q.at, 1);
  }
  q.cost += cost_between(before, tally_);
}

/// Sets the start to the first candidate; false if there is none on the origin's side of the face.
bool Departures::propose_near(NearQuestion& q) {
  q.start.side = side_of(q.at->face, q.at->origin);
  if (q.start.side == 0) return false;
  const std::optional<Point3> candidate = near_candidate(*q.at, 0);
  if (!candidate || *candidate == q.at->origin || side_of(q.at->face, *candidate) != q.start.side) return false;
  q.start.point = *candidate;
  return true;
}

/// The first candidates of all hits are tested together; where one fails, the further ones are tried one by one.
void Departures::near_sides(std::span<NearQuestion> questions) {
  tally_.starts += questions.size();
  if (!proves_) {
    for (NearQuestion& q : questions) q.start = {customary(*q.at, 1)};
    return;
  }
  ways_.clear();
  askers_.clear();
  for (NearQuestion& q : questions) {
    if (propose_near(q)) {
      lead_to(q.start.point, *q.at, ways_.emplace_back());
      askers_.push_back(&q);
    } else {
      search_near(q, q.start.side, 0);
    }
  }
  visibility_.met(ways_);
  tally_.start_candidates += ways_.size();
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    askers_[i]->cost += ways_[i].cost;
    if (ways_[i].met) search_near(*askers_[i], askers_[i]->start.side, 1);
  }
}

Departure Departures::near_side(const HitPoint& at) {
  NearQuestion q{&at};
  near_sides({&q, 1});
  return q.start;
}

template <class X>
Behind Departures::left_behind(const HitPoint& at, const Departure& start, const X& target) {
  const bool leaves = start.side != 0 && side_of(at.face, target) == start.side;
  return leaves ? Behind{at.face, start.side} : Behind{};
}

template Behind Departures::left_behind(const HitPoint&, const Departure&, const Point3&);
template Behind Departures::left_behind(const HitPoint&, const Departure&, const Direction&);

/// The k-th candidate beyond the face: five for each step length, one straight behind the rounded hit point and four
/// that are also shifted along the face.
Point3 Departures::far_candidate(const HitPoint& at, int k) const {
  const double step = std::ldexp(smallest_step(at), k / 5);
  Point3 shift(0);
  if (k % 5 != 0) {
    const Triangle& t = faces_[at.face].triangle;
    const Point3 along = normalised((t.a - at.point) + (t.b - at.point) + (t.c - at.point));
    const Point3 across = glm::cross(at.normal, along);
    const Point3 shifts[] = {along, -along, across, -across};
    shift = shifts[k % 5 - 1];
  }
  return in_format(at.point + step * (shift - at.normal), world_.format);
}

bool Departures::is_far_start(const HitPoint& at, const Point3& near, const Point3& candidate, int side) {
  ++tally_.start_candidates;
  if (side_of(at.face, candidate) != -side) return false;
  const Segment way{near, candidate};
  return !visibility_.meets_any(way, {at.face, no_face}) && visibility_.passes_through(way, at.face);
}

/// Tries the far candidates from the k-th on, one by one.
void Departures::search_far(FarQuestion& q, int side, int k) {
  const RayTally before = tally_;
  q.start = {};
  for (; side != 0 && q.start.side == 0 && k < 5 * (doublings + 1); ++k) {
    const Point3 candidate = far_candidate(*q.at, k);
    if (is_far_start(*q.at, q.near.point, candidate, side)) q.start = {candidate, -side};
  }
  if (q.start.side == 0) {
    ++tally_.starts_unproved;
    q.start = q.near;
  }
  q.cost += cost_between(before, tally_);
}

void Departures::far_sides(std::span<FarQuestion> questions) {
  tally_.starts += questions.size();
  if (!proves_) {
    for (FarQuestion& q : questions) q.start = {customary(*q.at, -1)};
    return;
  }
  ways_.clear();
  for (FarQuestion& q : questions) ways_.push_back({{q.near.point, far_candidate(*q.at, 0)}, {q.at->face, no_face}});
  visibility_.met(ways_);
  tally_.start_candidates += ways_.size();
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    FarQuestion& q = questions[i];
    const Segment& way = ways_[i].way;
    q.cost += ways_[i].cost;
    const int side = side_of(q.at->face, way.p);
    const bool beyond = side != 0 && !ways_[i].met && side_of(q.at->face, way.q) == -side;
    q.cost.tests += beyond;
    if (beyond && visibility_.passes_through(way, q.at->face)) {
      q.start = {way.q, -side};
    } else {
      search_far(q, side, 1);
    }
  }
}

Departure Departures::far_side(const HitPoint& at, const Departure& near) {
  FarQuestion q{&at, near};
  far_sides({&q, 1});
  return q.start;
}

}  // namespace tribunal
