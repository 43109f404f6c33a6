#include "exact/methods.h"
#include "tests/bench/tracer/peers.h"
#include "tracer/shading/visibility.h"

namespace tribunal::bench {
namespace {

Scene scene_of(const Mesh& mesh) {
  Scene scene{};
  scene.solids.push_back({"mesh", mesh, {}});
  return scene;
}

class OurCaster : public Caster {
 public:
  explicit OurCaster(const Mesh& mesh)
      : scene_(scene_of(mesh)),
        world_(make_world(scene_, Format::binary64, Accel::bvh)),
        visibility_(world_, *find_method("sf-filtered"), tally_) {}

  std::int64_t first_hit(const Ray& ray) override {
    const auto hit = visibility_.first_hit(ray);
    return hit ? std::int64_t{*hit} : -1;
  }

  std::size_t bytes() const override { return 0; }

 private:
  Scene scene_;
  World world_;
  RayTally tally_;
  Visibility visibility_;
};

}  // namespace

std::unique_ptr<Caster> make_ours(const Mesh& mesh) { return std::make_unique<OurCaster>(mesh); }

}  // namespace tribunal::bench
