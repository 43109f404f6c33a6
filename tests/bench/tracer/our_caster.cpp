#include "tests/bench/tracer/peers.h"
#include "tracer/accel/triangle_tree.h"

namespace tribunal::bench {
namespace {

std::vector<Triangle> triangles_of(const Mesh& mesh) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) triangles.push_back(mesh.triangle(i));
  return triangles;
}

class OurCaster : public Caster {
 public:
  explicit OurCaster(const Mesh& mesh) : tree_(triangles_of(mesh)) {}

  std::int64_t first_hit(const Ray& ray) override {
    const auto hit = tree_.closest(ray);
    return hit ? std::int64_t{hit->id} : -1;
  }

  std::size_t bytes() const override { return tree_.bytes(); }

 private:
  TriangleTree tree_;
};

}  // namespace

std::unique_ptr<Caster> make_ours(const Mesh& mesh) { return std::make_unique<OurCaster>(mesh); }

}  // namespace tribunal::bench
