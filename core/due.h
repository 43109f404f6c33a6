// What a contract owes to a case: a hit, a miss, or nothing.
#pragma once

#include <cstdint>

#include "core/contract.h"
#include "core/kernel.h"

namespace tribunal {

/// The exact facts of a case on which a contract can depend.
struct Facts {
  bool of_ray = false;
  bool of_polygon = false;
  bool bounded = false;     ///< a ray with bounds
  bool degenerate = false;  ///< the triangle has no area, or the probe is a point
  bool planar = true;       ///< the polygon's vertices lie in one plane
  Contact contact = Contact::none;
  bool boundary = false;   ///< an edge or a vertex of the target is met
  At at = At::unsaid;      ///< `between`: no end of the probe is in contact; `unsaid`: not known, or many points
  bool at_origin = false;  ///< of a ray with bounds: the contact is at t = 0
  Facing facing = Facing::unsaid;
};

/// What a method owes by its contract. `nothing`: the contract says nothing of such a case, so it is not judged.
enum class Due : std::uint8_t { hit, miss, nothing };

namespace due_detail {

constexpr bool takes(const Contract& c, const Facts& f) {
  if (!(f.bounded ? c.probes.bounds : f.of_ray ? c.probes.rays : c.probes.segments)) return false;
  if (f.of_polygon) return c.polygons == Polygons::any || (c.polygons == Polygons::planar && f.planar);
  return c.triangles == Triangles::any || (c.triangles == Triangles::proper && !f.degenerate);
}

constexpr Due in_plane(const Contract& c, const Facts& f, Boundary boundary) {
  if (c.convention == Convention::transversal) return Due::miss;
  if (c.convention == Convention::unspecified) return Due::nothing;
  const bool reads_bounds = f.bounded && c.bounds != Ends::closed;
  const bool turns_on_more = c.ends != Ends::closed || reads_bounds || c.culling != Culling::none ||
                             (f.boundary && boundary != Boundary::closed);
  return turns_on_more ? Due::nothing : Due::hit;
}

constexpr Due at_boundary(Boundary boundary) {
  if (boundary == Boundary::closed) return Due::hit;
  return boundary == Boundary::open ? Due::miss : Due::nothing;
}

/// What the reading of ends makes of a contact at `at`; where that is `unsaid`, an end may be all that is in contact.
constexpr Due at_end(Ends ends, At at) {
  if (ends == Ends::closed || at == At::between) return Due::hit;
  return ends == Ends::open && at != At::unsaid ? Due::miss : Due::nothing;
}

/// The ends of a ray with bounds are those that the bounds make; its origin is an end of the ray too.
constexpr Due at_ends_of(const Contract& c, const Facts& f) {
  if (!f.bounded) return at_end(c.ends, f.at);
  if (f.at != At::source) return at_end(c.bounds, f.at);
  return f.at_origin && c.bounds == Ends::closed ? at_end(c.ends, f.at) : at_end(c.bounds, f.at);
}

constexpr Due by_facing(Culling culling, Facing facing) {
  if (culling == Culling::none || facing == Facing::front) return Due::hit;
  return facing == Facing::back ? Due::miss : Due::nothing;
}

/// A contact is a hit if all readings say so, and a miss if one does.
constexpr Due both(Due a, Due b) {
  if (a == Due::miss || b == Due::miss) return Due::miss;
  return a == Due::hit && b == Due::hit ? Due::hit : Due::nothing;
}

}  // namespace due_detail

/// What the contract owes to a case with these facts. The format is not looked at here: it belongs to the case.
constexpr Due due(const Contract& c, const Facts& f) {
  using namespace due_detail;
  const Boundary boundary = f.of_polygon ? c.polygon_boundary : c.boundary;
  if (!takes(c, f) || (f.boundary && boundary == Boundary::unspecified)) return Due::nothing;
  if (f.contact == Contact::none) return Due::miss;
  if (f.contact == Contact::coplanar) return in_plane(c, f, boundary);
  const Due crossing = both(by_facing(c.culling, f.facing), at_ends_of(c, f));
  return f.boundary ? both(crossing, at_boundary(boundary)) : crossing;
}

/// From which side the probe crosses the triangle. The probe must meet the triangle and not lie in its plane.
template <Kernel K, class P>
Facing facing(const P& probe, const Triangle& t, const K& k) {
  const Sign start = k.orient3d(t.a, t.b, t.c, source(probe));
  if (start != Sign::zero) return start == Sign::positive ? Facing::front : Facing::back;
  return k.orient3d(t.a, t.b, t.c, target(probe)) == Sign::negative ? Facing::front : Facing::back;
}

}  // namespace tribunal
