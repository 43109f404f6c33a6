#include <algorithm>

#include "tests/bench/tracer/peers.h"
#include "tracer/accel/triangle_tree.h"

namespace tribunal::bench {
namespace {

std::vector<Triangle> triangles_of(const Mesh& mesh) {
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) triangles.push_back(mesh.triangle(i));
  return triangles;
}

std::int64_t id_of(const std::optional<Nearest>& hit) { return hit ? std::int64_t{hit->id} : -1; }

class OneByOne : public Caster {
 public:
  explicit OneByOne(const Mesh& mesh) : tree_(triangles_of(mesh)) {}

  void first_hits(std::span<const Ray> rays, std::span<std::int64_t> hits) override {
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = id_of(tree_.closest(rays[i]));
  }

  std::size_t bytes() const override { return tree_.bytes(); }

 protected:
  TriangleTree tree_;
};

class InBatches : public OneByOne {
 public:
  using OneByOne::OneByOne;

  void first_hits(std::span<const Ray> rays, std::span<std::int64_t> hits) override {
    std::optional<Nearest> nearest[call];
    for (std::size_t from = 0; from < rays.size(); from += call) {
      const std::size_t count = std::min(call, rays.size() - from);
      tree_.closest(rays.subspan(from, count), std::span(nearest).first(count));
      std::transform(nearest, nearest + count, hits.begin() + static_cast<std::ptrdiff_t>(from), id_of);
    }
  }

 private:
  static constexpr std::size_t call = 1024;  ///< rays in a call; so few that the answers stay in the cache
};

}  // namespace

std::unique_ptr<Caster> make_ours(const Mesh& mesh) { return std::make_unique<OneByOne>(mesh); }

std::unique_ptr<Caster> make_ours_batch(const Mesh& mesh) { return std::make_unique<InBatches>(mesh); }

}  // namespace tribunal::bench
