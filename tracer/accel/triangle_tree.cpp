#include "tracer/accel/triangle_tree.h"

#include <cmath>
#include <stdexcept>

#include "exact/filtered/stages/default_rounding.h"
#include "tracer/accel/certified.h"
#include "tracer/accel/lanes_at_work.h"

namespace tribunal {
namespace {

/// The search for the closest hit of one ray: its probe, judge and query.
class Search {
 public:
  Search(const WideTree& tree, const Ray& ray, const WideProbe& probe)
      : probe_(probe), judge_{tree, ray}, finder_(tree, probe, judge_) {}
  Search(const Search&) = delete;

  RayWalk walk() { return {&judge_.ray, &probe_, &finder_}; }

  std::optional<Nearest> nearest() const {
    if (!finder_.best()) return std::nullopt;
    return judge_.handed_out(*finder_.best());
  }

 private:
  const WideProbe& probe_;
  CertifiedRay judge_;
  ClosestQuery<CertifiedRay> finder_;
};

constexpr std::size_t batch_size = 1024;  ///< so that few walks end alone; what they need takes 300 KB of the stack

void search_batch(const WideTree& tree, std::span<const Ray> rays, std::span<std::optional<Nearest>> hits) {
  std::optional<Search> searches[batch_size];
  RayWalk walks[batch_size];
  WideProbe probes[batch_size];
  tree_target().make_probes(rays, tree.frame(), probes);
  std::size_t count = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!std::isnan(probes[i].scale)) walks[count++] = searches[i].emplace(tree, rays[i], probes[i]).walk();
  }
  WalkCounts uncounted;
  tree_target().filter_rays(tree, {walks, count}, uncounted);
  for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = searches[i] ? searches[i]->nearest() : std::nullopt;
}

std::optional<Nearest> search(const WideTree& tree, const Ray& ray) {
  if (!is_finite(ray)) return std::nullopt;
  const WideProbe probe(ray, tree.frame());
  Search alone(tree, ray, probe);
  WalkCounts uncounted;
  tree_target().filter_ray(tree, probe, ray, *alone.walk().query, uncounted);
  return alone.nearest();
}

/// Answers eight rays at a time; where the packet is not certain of a lane, or its bounds of t are not close, the ray
/// walks on its own.
LanesAtWork search_packets(const WideTree& tree, std::span<const Ray> rays, std::span<std::optional<Nearest>> hits) {
  LanesAtWork lanes;
  for (std::size_t from = 0; from < rays.size(); from += packet_size) {
    const std::span<const Ray> some = rays.subspan(from, std::min(packet_size, rays.size() - from));
    ProbePacket packet;
    for (std::size_t lane = 0; lane < some.size(); ++lane) packet.set(lane, some[lane].o, some[lane].d.v);
    PacketAnswer a;
    packet_target().first_hits({tree, {}, {}}, packet, a);
    for (std::size_t lane = 0; lane < some.size(); ++lane) {
      std::optional<Nearest>& hit = hits[from + lane];
      const unsigned answered = a.known & (a.close | ~a.hit);
      if ((answered >> lane & 1) == 0) {
        hit = search(tree, some[lane]);
      } else if ((a.hit >> lane & 1) == 0) {
        hit.reset();
      } else {
        hit = Nearest{static_cast<std::uint32_t>(a.id[lane]), a.t[lane]};
      }
    }
    lanes += LanesAtWork(a);
  }
  return lanes;
}

void search_stream(const WideTree& tree, std::span<const Ray> rays, std::span<std::optional<Nearest>> hits) {
  for (std::size_t from = 0; from < rays.size(); from += batch_size) {
    const std::size_t count = std::min(batch_size, rays.size() - from);
    search_batch(tree, rays.subspan(from, count), hits.subspan(from, count));
  }
}

constexpr std::size_t first_stream = batch_size - packet_size;

}  // namespace

TriangleTree::TriangleTree(std::span<const Triangle> triangles)
    : tree_(std::make_shared<const WideTree>(static_cast<std::uint32_t>(triangles.size()), [&](std::uint32_t i) {
        return Primitive{box_of(triangles[i]), triangles[i]};
      })) {}

std::optional<Nearest> TriangleTree::closest(const Ray& ray) const {
  const DefaultRounding in_this_scope;  // the bounds of boxes rest on it
  return search(*tree_, ray);
}

void TriangleTree::closest(std::span<const Ray> rays, std::span<std::optional<Nearest>> hits) const {
  if (rays.size() != hits.size()) throw std::invalid_argument("closest: as many hits as rays are needed");
  const DefaultRounding in_this_scope;
  const auto part = [&](const auto& all, std::size_t from, std::size_t count) {
    return all.subspan(from, std::min(count, all.size() - from));
  };
  LanesAtWork of_late;
  for (std::size_t from = 0, in_a_stream = first_stream; from < rays.size();) {
    of_late += search_packets(*tree_, part(rays, from, packet_size), part(hits, from, packet_size));
    from += packet_size;
    if (of_late.share() > LanesAtWork::alike) {
      in_a_stream = first_stream;
    } else if (from < rays.size()) {
      search_stream(*tree_, part(rays, from, in_a_stream), part(hits, from, in_a_stream));
      from += in_a_stream;
      in_a_stream *= 4;
    }
    of_late.forget_some();
  }
}

std::size_t TriangleTree::bytes() const { return tree_->bytes(); }

}  // namespace tribunal
