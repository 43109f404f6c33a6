// The exact answer to a case.
#pragma once

#include "core/due.h"
#include "exact/cases/families/family.h"

namespace tribunal {

/// The exact answer.
struct Truth {
  ClassId class_id = 0;  ///< the class of a triangle case; 0 for a polygon, which has none
  Contact contact = Contact::none;
  bool planar = true;     ///< the polygon's vertices lie in one plane
  bool boundary = false;  ///< a ring edge of the polygon is met: where the contact is edge or vertex, and perhaps where
                          ///< it is coplanar
  bool of_ray = false;    ///< the probe is a ray, else a segment
  Facing facing = Facing::unsaid;  ///< known wherever the probe crosses a triangle
  At at = At::unsaid;  ///< which part of the probe is in contact, where the reference says so: of a polygon, and of a
                       ///< ray with bounds, whose ends these are
  bool bounded =
      false;  ///< the probe is a ray with bounds: the class is the ray's, all else is of what the bounds leave
  bool at_origin = false;  ///< of a ray with bounds: it meets the triangle at t = 0

  bool hit() const { return contact != Contact::none; }
  Operands operands() const { return class_id != 0 ? Operands::triangles : Operands::polygons; }
};

/// The truth of a query of this class; CGAL's EPICK decides what the class does not say.
Truth truth_in_class(ClassId id, const Query& query);

/// The same without `facing`, which matters only to methods that cull.
Truth truth_of_class(ClassId id);

/// The exact answer by several formulations, which must agree. Fails with Exit::oracles_contradict and both witnesses
/// where two differ; there is no majority. Of a triangle: the class table (signs looked up), the Segura–Feito decision
/// of the reference kernel, Carathéodory's theorem on the differences (which shares no formula with them), and CGAL's
/// do_intersect where its preconditions hold. Of a polygon: the reference kernel's covering test, with and without
/// preparation; if it is planar, whether the point where the probe meets the plane is inside, by a generic ray and by
/// half-open crossings; and the signed crossings of the covering surface, point by point. Ring edges are met by
/// Carathéodory's theorem, and off the plane the contact says the same of them. Of a ray with bounds: as above without
/// them, and then by the same decision within the bounds, Carathéodory's theorem on the exact ends, and the parameter
/// of the hit as a fraction.
Truth exact_truth(const Query& query);

/// By construction where a triangle case knows its class, else exact_truth, which must also be what the construction
/// proves. Case numbers divisible by 257 (prime, so that all classes and levels come up) are judged both ways.
Truth truth_of(const Trial& trial, std::uint64_t k);

/// The oracles that judged a family's cases, and those that judge cases from elsewhere, in words for reports.
const char* oracle_of(const Family& family);
const char* oracles_of(Operands operands);

/// Those that judge triangles of which no class is known by construction.
extern const char* const judges_of_triangles;

/// Those that judge the cases of methods that promise to be exact, but for the share that all oracles judge.
const char* formulations_in_words();

}  // namespace tribunal
