#include "tracer/accel/triangle_tree.h"

#include "exact/filtered/filtered.h"
#include "tracer/accel/wide/closest.h"

namespace tribunal {
namespace {

/// Asks the certified test.
struct Certified {
  const WideTree& tree;
  const Ray& ray;

  bool sees(Place p, std::uint32_t, double) const {
    const Answer a = intersect(ray, tree.triangle(p));
    return a.hit && a.contact != Contact::coplanar;
  }
  Span span(Place p, std::uint32_t) const { return BoxProbe(ray).span(box_of(tree.triangle(p))); }
  Triangle plane(Place p, std::uint32_t) const { return tree.triangle(p); }
  static bool is_exact() { return true; }
  Sign order(const BoundedHit& a, const BoundedHit& b) const {
    return compare_hits(ray, tree.triangle(a.place), tree.triangle(b.place));
  }
};

}  // namespace

TriangleTree::TriangleTree(std::span<const Triangle> triangles)
    : tree_(static_cast<std::uint32_t>(triangles.size()), [&](std::uint32_t i) {
        return Primitive{box_of(triangles[i]), triangles[i]};
      }) {}

std::optional<Nearest> TriangleTree::closest(const Ray& ray) const {
  if (!is_finite(ray)) return std::nullopt;
  const WideProbe probe(ray, tree_.frame());
  Certified judge{tree_, ray};
  ClosestFinder finder(tree_, probe, judge);
  WalkCounts uncounted;
  tree_target().sift_ray(tree_, probe, ray, finder, uncounted);
  if (!finder.best()) return std::nullopt;
  return Nearest{finder.best()->id, finder.best()->t};
}

std::size_t TriangleTree::bytes() const { return tree_.bytes(); }

}  // namespace tribunal
