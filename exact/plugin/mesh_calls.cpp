#include "exact/plugin/mesh_calls.h"

#include <cstdint>
#include <limits>

#include "exact/base/fp_environment.h"
#include "exact/plugin/without_exceptions.h"

namespace tribunal {
namespace {

/// What the call returns, if it keeps the promises of tribunal_plugin.h.
template <class Call>
auto guarded(const Call& call) {
  const auto returned = without_exceptions(call);
  if (has_exact_rounding()) return returned;
  require_exact_rounding();
  throw CallFailed{{Status::changed_environment}};
}

class MeshCallsHere final : public MeshCalls {
 public:
  MeshCallsHere(const tribunal_mesh_plugin& plugin, std::span<const double> vertices,
                std::span<const std::size_t> corners)
      : plugin_(plugin), face_count_(corners.size() / 3) {
    void* const made =
        guarded([&] { return plugin_.prepare(vertices.size() / 3, vertices.data(), face_count_, corners.data()); });
    if (made == nullptr) throw CallFailed{{Status::gave_no_answer, "returned NULL"}};
    mesh_ = std::shared_ptr<void>(made, [release = plugin_.release](void* p) {
      if (release != nullptr) release(p);
    });
  }

  void closest(std::span<const double> rays, std::span<tribunal_mesh_hit> hits,
               std::span<tribunal_mesh_normal> normals) const override {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (tribunal_mesh_hit& hit : hits) hit = {face_count_, 0};
    for (tribunal_mesh_normal& normal : normals) normal = {{nan, nan, nan}, TRIBUNAL_SIDE_UNSAID};
    guarded([&] {
      if (plugin_.closest_normal != nullptr) {
        plugin_.closest_normal(mesh_.get(), hits.size(), rays.data(), hits.data(), normals.data());
      } else {
        plugin_.closest(mesh_.get(), hits.size(), rays.data(), hits.data());
      }
      return 0;
    });
  }

  void any(std::span<const double> rays, std::span<int> answers) const override { ask(plugin_.any, rays, answers); }

  void inside(std::span<const double> rays, std::span<int> answers) const override {
    ask(plugin_.inside, rays, answers);
  }

  std::vector<tribunal_mesh_hit> all(std::span<const double> rays, std::span<std::size_t> counts) const override {
    std::vector<tribunal_mesh_hit> hits;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const std::vector<tribunal_mesh_hit> found = all_of(rays.data() + 6 * i);
      counts[i] = found.size();
      hits.insert(hits.end(), found.begin(), found.end());
    }
    return hits;
  }

  bool isolated() const override { return false; }
  std::size_t largest_batch() const override { return SIZE_MAX; }

 private:
  template <class Function>
  void ask(Function* function, std::span<const double> rays, std::span<int> answers) const {
    for (int& answer : answers) answer = -1;
    guarded([&] {
      function(mesh_.get(), answers.size(), rays.data(), answers.data());
      return 0;
    });
  }

  std::vector<tribunal_mesh_hit> all_of(const double* ray) const {
    std::vector<tribunal_mesh_hit> hits(16, {face_count_, 0});
    const auto ask = [&] { return guarded([&] { return plugin_.all(mesh_.get(), ray, hits.size(), hits.data()); }); };
    const std::size_t count = ask();
    if (count > 64 * (face_count_ + 1)) {
      throw CallFailed{{Status::gave_no_answer,
                        "returned " + std::to_string(count) + " hits of " + std::to_string(face_count_) + " faces"}};
    }
    const bool more = count > hits.size();
    if (more) hits.assign(count, {face_count_, 0});
    if (more && ask() != count) {
      throw CallFailed{{Status::gave_no_answer, "found another number of hits when asked again"}};
    }
    hits.resize(count);
    return hits;
  }

  tribunal_mesh_plugin plugin_;
  std::size_t face_count_;
  std::shared_ptr<void> mesh_{};
};

}  // namespace

std::shared_ptr<const MeshCalls> mesh_calls_here(const tribunal_mesh_plugin& plugin, std::span<const double> vertices,
                                                 std::span<const std::size_t> corners) {
  return std::make_shared<MeshCallsHere>(plugin, vertices, corners);
}

}  // namespace tribunal
