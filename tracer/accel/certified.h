// The certified test as the judge of the candidates of a walk through a tree of triangles.
#pragma once

#include "exact/filtered/filtered.h"
#include "exact/filtered/rounded_parameter.h"
#include "tracer/accel/triangle_tree.h"
#include "tracer/accel/wide/closest.h"
#include "tracer/accel/wide/tree.h"

namespace tribunal {

/// Whether the probe hits a triangle of the tree, in the tracer's reading: not in its plane, nor one without area.
template <class P>
struct Certified {
  const WideTree& tree;
  const P& probe;

  bool sees(Place p, std::uint32_t, double) const {
    const Answer a = intersect(probe, tree.triangle(p));
    return a.hit && a.contact != Contact::coplanar;
  }
  static bool accepts(std::uint32_t) { return true; }
};

/// The same for a ray, with what ClosestQuery and AllQuery ask to order the hits along it.
struct CertifiedRay : Certified<Ray> {
  CertifiedRay(const WideTree& t, const Ray& r) : Certified<Ray>{t, r}, ray(r) {}

  const Ray& ray;

  Span span(Place p, std::uint32_t) const { return BoxProbe(ray).span(box_of(tree.triangle(p))); }
  Triangle plane(Place p, std::uint32_t) const { return tree.triangle(p); }
  static bool is_exact() { return true; }
  Sign order(const BoundedHit& a, const BoundedHit& b) const {
    return compare_hits(ray, tree.triangle(a.place), tree.triangle(b.place));
  }

  /// The hit as the library returns it: its t keeps the error bound stated at Nearest.
  Nearest handed_out(const BoundedHit& hit) const {
    return {hit.id, hit.bounds.are_close() ? hit.t : rounded_parameter(ray, tree.triangle(hit.place))};
  }
};

}  // namespace tribunal
