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

/// The exact side of the face's plane on which a point lies, or to which a direction leads; 0 if that is not finite.
template <class X>
int Departures::side_of(std::uint32_t face, const X& x) {
  const KnownFace& known = faces_[face];
  if (const std::optional<Sign> side = known.plane.side(x)) return value(*side);
  if (!is_finite_target(x)) return 0;
  return value(orient3d_exactly(known.triangle, x));
}

Point3 Departures::customary(const Landing& at, double side) const {
  return in_format(at.point + side * world_.step * at.normal, world_.format);
}

double Departures::smallest_step(const Landing& at) const {
  const double roundoff = world_.format == Format::binary32 ? 0x1p-24 : 0x1p-53;
  return roundoff * std::max(greatest(at.origin), greatest(at.point));
}

/// Back from the hit by the k-th step; nothing where that is too far.
std::optional<Point3> Departures::near_candidate(const Landing& at, int k) const {
  const Point3 back = at.origin - at.point;
  const double length = greatest(back), step = k == 0 ? smallest_step(at) : std::ldexp(smallest_step(at), k);
  if (k > doublings || !(step < length)) return std::nullopt;
  return in_format(at.point + (step / length) * back, world_.format);
}

/// From the origin. Neither the face that was hit matters, if the candidate lies on the origin's side of it, nor the
/// one that the ray left behind, if the candidate does so too.
void Departures::add_way_to(const Landing& at, const Point3& candidate) {
  const Behind& b = at.behind;
  const bool stays = b.face != no_face && side_of(b.face, candidate) == b.side;
  SegmentQuestion& q = ways_.emplace_back();
  q.way.p = at.origin;
  q.way.q = candidate;
  q.apart[0] = at.face;
  if (stays) q.apart[1] = b.face;
}

bool Departures::is_near_start(const Landing& at, const Point3& candidate, int side) {
  ++tally_.start_candidates;
  if (side_of(at.face, candidate) != side) return false;
  if (candidate == at.origin) return true;
  add_way_to(at, candidate);
  const SegmentQuestion q = ways_.back();
  ways_.pop_back();
  return !visibility_.meets_any(q.way, q.apart);
}

/// From the k-th candidate on, one by one; the origin is the last.
Start Departures::search_near(const Landing& at, int side, int k) {
  for (bool last = side == 0; !last; ++k) {
    const std::optional<Point3> candidate = near_candidate(at, k);
    const Point3 point = candidate.value_or(at.origin);
    if (is_near_start(at, point, side)) return {point, side};
    last = !candidate;
  }
  ++tally_.starts_unproved;
  return {customary(at, 1)};
}

/// All first candidates are asked together; who needs another goes on alone.
void Departures::near_sides(std::span<NearQuestion> questions) {
  tally_.starts += questions.size();
  ways_.clear();
  for (NearQuestion& q : questions) {
    const Landing& at = *q.at;
    if (!proves_) q.start = {customary(at, 1)};
    if (!proves_) continue;
    q.start.point = at.origin;
    q.start.side = side_of(at.face, at.origin);
    const std::optional<Point3> candidate = near_candidate(at, 0);
    if (q.start.side == 0 || !candidate || *candidate == at.origin || side_of(at.face, *candidate) != q.start.side)
      continue;
    q.start.point = *candidate;
    add_way_to(at, *candidate);
  }
  visibility_.met(ways_);
  const SegmentQuestion* way = ways_.data();
  for (NearQuestion& q : questions) {
    if (!proves_) continue;
    const bool asked = q.start.point != q.at->origin;
    tally_.start_candidates += asked;
    const RayTally before = tally_;
    if (!asked) {
      q.start = search_near(*q.at, q.start.side, 0);
    } else if (way->met) {
      q.start = search_near(*q.at, q.start.side, 1);
    }
    q.cost += cost_between(before, tally_);
    if (asked) q.cost += (way++)->cost;
  }
}

Start Departures::near_side(const Landing& at) {
  NearQuestion q{&at};
  near_sides({&q, 1});
  return q.start;
}

template <class X>
Behind Departures::left_behind(const Landing& at, const Start& start, const X& target) {
  const bool leaves = start.side != 0 && side_of(at.face, target) == start.side;
  return leaves ? Behind{at.face, start.side} : Behind{};
}

template Behind Departures::left_behind(const Landing&, const Start&, const Point3&);
template Behind Departures::left_behind(const Landing&, const Start&, const Direction&);

/// Behind the hit by the step of `shifts` k, straight or shifted along the face.
Point3 Departures::far_candidate(const Landing& at, int k) const {
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

bool Departures::is_far_start(const Landing& at, const Point3& near, const Point3& candidate, int side) {
  ++tally_.start_candidates;
  if (side_of(at.face, candidate) != -side) return false;
  const Segment way{near, candidate};
  return !visibility_.meets_any(way, {at.face, no_face}) && visibility_.passes_through(way, at.face);
}

/// From the k-th candidate on, one by one.
Start Departures::search_far(const FarQuestion& q, int side, int k) {
  for (; side != 0 && k < 5 * (doublings + 1); ++k) {
    const Point3 candidate = far_candidate(*q.at, k);
    if (is_far_start(*q.at, q.near.point, candidate, side)) return {candidate, -side};
  }
  ++tally_.starts_unproved;
  return q.near;
}

void Departures::far_sides(std::span<FarQuestion> questions) {
  tally_.starts += questions.size();
  ways_.clear();
  for (FarQuestion& q : questions) {
    q.start.point = proves_ ? far_candidate(*q.at, 0) : customary(*q.at, -1);
    if (proves_) ways_.push_back({{q.near.point, q.start.point}, {q.at->face, no_face}});
  }
  visibility_.met(ways_);
  for (std::size_t i = 0; i < ways_.size(); ++i) {
    FarQuestion& q = questions[i];
    const int side = side_of(q.at->face, q.near.point);
    const RayTally before = tally_;
    ++tally_.start_candidates;
    const bool proved = side != 0 && !ways_[i].met && side_of(q.at->face, q.start.point) == -side &&
                        visibility_.passes_through(ways_[i].way, q.at->face);
    q.start = proved ? Start{q.start.point, -side} : search_far(q, side, 1);
    q.cost += cost_between(before, tally_);
    q.cost += ways_[i].cost;
  }
}

Start Departures::far_side(const Landing& at, const Start& near) {
  FarQuestion q{&at, near};
  far_sides({&q, 1});
  return q.start;
}

}  // namespace tribunal
