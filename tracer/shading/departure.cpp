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
  if (face != face_) plane_.emplace(world_.triangles[face]), face_ = face;
  if (const std::optional<Sign> side = plane_->side(x)) return value(*side);
  if (!is_finite_target(x)) return 0;
  const Triangle t = world_.triangles[face];
  return value(FilteredKernel().orient3d(t.a, t.b, t.c, x));
}

Point3 Departures::customary(const Landing& at, double side) const {
  return in_format(at.point + side * world_.step * at.normal, world_.format);
}

double Departures::smallest_step(const Landing& at) const {
  const double roundoff = world_.format == Format::binary32 ? 0x1p-24 : 0x1p-53;
  return roundoff * std::max(greatest(at.origin), greatest(at.point));
}

bool Departures::is_near_start(const Landing& at, const Point3& candidate, int side) {
  ++tally_.start_candidates;
  if (side_of(at.face, candidate) != side) return false;
  return candidate == at.origin ||
         visibility_.faces_met({at.origin, candidate}, Visibility::nobody, at.face) == Visibility::Met::none;
}

Start Departures::near_side(const Landing& at) {
  ++tally_.starts;
  if (!proves_) return {customary(at, 1)};
  const int side = side_of(at.face, at.origin);
  const Point3 back = at.origin - at.point;
  const double length = greatest(back);
  double step = smallest_step(at);
  for (int k = 0; side != 0 && k <= doublings && step < length; ++k, step *= 2) {
    const Point3 candidate = in_format(at.point + (step / length) * back, world_.format);
    if (is_near_start(at, candidate, side)) return {candidate, side};
  }
  if (side != 0 && is_near_start(at, at.origin, side)) return {at.origin, side};
  ++tally_.starts_unproved;
  return {customary(at, 1)};
}

template <class X>
std::uint32_t Departures::left_behind(const Landing& at, const Start& start, const X& target) {
  const bool leaves = start.side != 0 && side_of(at.face, target) == start.side;
  return leaves ? at.face : Visibility::nobody;
}

template std::uint32_t Departures::left_behind(const Landing&, const Start&, const Point3&);
template std::uint32_t Departures::left_behind(const Landing&, const Start&, const Direction&);

bool Departures::is_far_start(const Landing& at, const Point3& near, const Point3& candidate, int side) {
  ++tally_.start_candidates;
  if (side_of(at.face, candidate) != -side) return false;
  return visibility_.faces_met({near, candidate}, at.face) == Visibility::Met::only_the_one;
}

Point3 Departures::far_side(const Landing& at, const Point3& near) {
  ++tally_.starts;
  if (!proves_) return customary(at, -1);
  const Triangle& t = world_.triangles[at.face];
  const int side = side_of(at.face, near);
  const Point3 along = normalised((t.a - at.point) + (t.b - at.point) + (t.c - at.point));
  const Point3 across = glm::cross(at.normal, along);
  const Point3 shifts[] = {Point3(0), along, -along, across, -across};
  double step = smallest_step(at);
  for (int k = 0; side != 0 && k <= doublings; ++k, step *= 2) {
    for (const Point3& shift : shifts) {
      const Point3 candidate = in_format(at.point + step * (shift - at.normal), world_.format);
      if (is_far_start(at, near, candidate, side)) return candidate;
    }
  }
  ++tally_.starts_unproved;
  return near;
}

}  // namespace tribunal
