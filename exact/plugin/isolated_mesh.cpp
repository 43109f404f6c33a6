#include "exact/plugin/isolated_mesh.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace tribunal {
namespace {

class IsolatedMeshCalls final : public MeshCalls {
 public:
  IsolatedMeshCalls(std::shared_ptr<const PluginChildren> children, std::span<const double> vertices,
                    std::span<const std::size_t> corners)
      : children_(std::move(children)), mesh_(question(vertices, corners)) {
    idle_.give_back(start());
  }

  ~IsolatedMeshCalls() override {
    for (const Child& child : idle_.take_all()) children_->end(child);
  }

  IsolatedMeshCalls(const IsolatedMeshCalls&) = delete;
  IsolatedMeshCalls& operator=(const IsolatedMeshCalls&) = delete;

  void closest(std::span<const double> rays, std::span<tribunal_mesh_hit> hits,
               std::span<tribunal_mesh_normal> normals) const override {
    const std::size_t n = hits.size();
    const Reply reply = reply_to(question(Kind::mesh_closest, rays),
                                 [n](const Reply& r) { return r.hits.size() == n && r.normals.size() == n; });
    std::ranges::copy(reply.hits, hits.begin());
    std::ranges::copy(reply.normals, normals.begin());
  }

  void any(std::span<const double> rays, std::span<int> answers) const override { ask(Kind::mesh_any, rays, answers); }

  void inside(std::span<const double> rays, std::span<int> answers) const override {
    ask(Kind::mesh_inside, rays, answers);
  }

  std::vector<tribunal_mesh_hit> all(std::span<const double> rays, std::span<std::size_t> counts) const override {
    const std::size_t n = counts.size();
    const Reply reply = reply_to(question(Kind::mesh_all, rays), [n](const Reply& r) {
      const bool counted = std::ranges::all_of(r.answers, [](int count) { return count >= 0; });
      return r.answers.size() == n && counted &&
             std::accumulate(r.answers.begin(), r.answers.end(), std::size_t{0}) == r.hits.size();
    });
    std::ranges::transform(reply.answers, counts.begin(), [](int count) { return static_cast<std::size_t>(count); });
    return reply.hits;
  }

  bool isolated() const override { return true; }
  std::size_t largest_batch() const override { return 256; }

 private:
  void ask(Kind kind, std::span<const double> rays, std::span<int> answers) const {
    const std::size_t n = answers.size();
    const Reply reply = reply_to(question(kind, rays), [n](const Reply& r) { return r.answers.size() == n; });
    std::ranges::copy(reply.answers, answers.begin());
  }

  template <class Whole>
  Reply reply_to(const Message& asked, const Whole& is_whole) const {
    const Child child = idle_.take_or([this] { return start(); });
    const Reply reply = children_->ask(child, asked, children_->time_limit(), is_whole);
    idle_.give_back(child);
    return reply;
  }

  /// A child that has prepared the mesh.
  Child start() const {
    const Child child = children_->take();
    children_->ask(child, mesh_, std::max(10 * children_->time_limit(), 10.0), [](const Reply&) { return true; });
    return child;
  }

  std::shared_ptr<const PluginChildren> children_;
  Message mesh_;
  mutable IdleChildren idle_;
};

}  // namespace

std::shared_ptr<const MeshCalls> isolated_mesh_calls(const std::shared_ptr<const PluginChildren>& children,
                                                     std::span<const double> vertices,
                                                     std::span<const std::size_t> corners) {
  return std::make_shared<IsolatedMeshCalls>(children, vertices, corners);
}

}  // namespace tribunal
