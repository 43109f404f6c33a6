// CGAL's AABB tree at its fastest: without the checks of its preconditions.
#define CGAL_NDEBUG
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

#include "tests/bench/tracer/peers.h"

namespace tribunal::bench {
namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<K::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<K, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<K, Primitive>>;

K::Point_3 point(const Point3& p) { return {p.x, p.y, p.z}; }

Triangles triangles_of(const Mesh& mesh) {
  Triangles triangles;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    triangles.emplace_back(point(t.a), point(t.b), point(t.c));
  }
  return triangles;
}

class AabbCaster : public Caster {
 public:
  explicit AabbCaster(const Mesh& mesh) : triangles_(triangles_of(mesh)), tree_(triangles_.begin(), triangles_.end()) {
    tree_.build();
  }

  void first_hits(std::span<const Ray> rays, std::span<std::int64_t> hits) override {
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = first_hit(rays[i]);
  }

  std::size_t bytes() const override { return 0; }

 private:
  std::int64_t first_hit(const Ray& r) {
    const auto hit = tree_.first_intersected_primitive(K::Ray_3(point(r.o), K::Vector_3(r.d.v.x, r.d.v.y, r.d.v.z)));
    return hit ? *hit - triangles_.begin() : -1;
  }

  Triangles triangles_;
  Tree tree_;
};

}  // namespace

std::unique_ptr<Caster> make_aabb(const Mesh& mesh) { return std::make_unique<AabbCaster>(mesh); }

}  // namespace tribunal::bench
