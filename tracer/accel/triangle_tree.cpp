#include "tracer/accel/triangle_tree.h"

#include <stdexcept>

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

/// All that finding the closest hit of a ray takes.
class Search {
 public:
  Search(const WideTree& tree, const Ray& ray, const WideProbe& probe)
      : probe_(probe), judge_{tree, ray}, finder_(tree, probe, judge_) {}
  Search(const Search&) = delete;

  RayWalk walk() { return {&judge_.ray, &probe_, &finder_}; }

  std::optional<Nearest> nearest() const {
    if (!finder_.best()) return std::nullopt;
    return Nearest{finder_.best()->id, finder_.best()->t};
  }

 private:
  const WideProbe& probe_;
  Certified judge_;
  ClosestFinder<Certified> finder_;
};

constexpr std::size_t batch_size = 256;  ///< so that all searches stay in the first cache

void search_batch(const WideTree& tree, std::span<const Ray> rays, std::span<std::optional<Nearest>> hits) {
  std::optional<Search> searches[batch_size];
  RayWalk walks[batch_size];
  WideProbe probes[batch_size];
  tree_target().make_probes(rays, tree.frame(), probes);
  std::size_t count = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (is_finite(rays[i])) walks[count++] = searches[i].emplace(tree, rays[i], probes[i]).walk();
  }
  WalkCounts uncounted;
  tree_target().sift_rays(tree, {walks, count}, uncounted);
  for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = searches[i] ? searches[i]->nearest() : std::nullopt;
}

}  // namespace

TriangleTree::TriangleTree(std::span<const Triangle> triangles)
    : tree_(static_cast<std::uint32_t>(triangles.size()), [&](std::uint32_t i) {
        return Primitive{box_of(triangles[i]), triangles[i]};
      }) {}

std::optional<Nearest> TriangleTree::closest(const Ray& ray) const {
  if (!is_finite(ray)) return std::nullopt;
  const WideProbe probe(ray, tree_.frame());
  Search search(tree_, ray, probe);
  WalkCounts uncounted;
  tree_target().sift_ray(tree_, probe, ray, *search.walk().finder, uncounted);
  return search.nearest();
}

void TriangleTree::closest(std::span<const Ray> rays, std::span<std::optional<Nearest>> hits) const {
  if (rays.size() != hits.size()) throw std::invalid_argument("closest: as many hits as rays are needed");
  for (std::size_t from = 0; from < rays.size(); from += batch_size) {
    const std::size_t count = std::min(batch_size, rays.size() - from);
    search_batch(tree_, rays.subspan(from, count), hits.subspan(from, count));
  }
}

std::size_t TriangleTree::bytes() const { return tree_.bytes(); }

}  // namespace tribunal
