#include "tracer/accel/triangle_tree.h"

#include <stdexcept>

#include "exact/filtered/filtered.h"
#include "tracer/accel/wide/closest.h"
#include "tracer/accel/wide/packet.h"

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

std::optional<Nearest> search(const WideTree& tree, const Ray& ray) {
  if (!is_finite(ray)) return std::nullopt;
  const WideProbe probe(ray, tree.frame());
  Search alone(tree, ray, probe);
  WalkCounts uncounted;
  tree_target().sift_ray(tree, probe, ray, *alone.walk().finder, uncounted);
  return alone.nearest();
}

/// Eight rays at a time; those that a packet cannot tell of alone. Returns which share of the lanes was at work.
double search_packets(const WideTree& tree, std::span<const Ray> rays, std::span<std::optional<Nearest>> hits) {
  std::uint64_t at_work = 0, offered = 0;
  for (std::size_t from = 0; from < rays.size(); from += packet_size) {
    const std::span<const Ray> some = rays.subspan(from, std::min(packet_size, rays.size() - from));
    ProbePacket packet;
    for (std::size_t lane = 0; lane < some.size(); ++lane) packet.set(lane, some[lane].o, some[lane].d.v);
    PacketAnswer a;
    packet_target().first_hits({tree, {}, {}}, packet, a);
    for (std::size_t lane = 0; lane < some.size(); ++lane) {
      std::optional<Nearest>& hit = hits[from + lane];
      if ((a.known >> lane & 1) == 0) {
        hit = search(tree, some[lane]);
      } else if ((a.hit >> lane & 1) == 0) {
        hit.reset();
      } else {
        hit = Nearest{static_cast<std::uint32_t>(a.id[lane]), a.t[lane]};
      }
    }
    at_work += a.boxes;
    offered += packet_size * a.boxes_visited;
  }
  return offered == 0 ? 0 : static_cast<double>(at_work) / static_cast<double>(offered);
}

// Rays that visit the same boxes are faster in packets, others as a stream; a few of each call tell which these are.
// Measured: packets win at 0.8 of the lanes at work, and lose at 0.5.
constexpr std::size_t samples = 2 * packet_size, worth_sampling = 8 * samples;
constexpr double alike = 0.65;

}  // namespace

TriangleTree::TriangleTree(std::span<const Triangle> triangles)
    : tree_(static_cast<std::uint32_t>(triangles.size()), [&](std::uint32_t i) {
        return Primitive{box_of(triangles[i]), triangles[i]};
      }) {}

std::optional<Nearest> TriangleTree::closest(const Ray& ray) const { return search(tree_, ray); }

void TriangleTree::closest(std::span<const Ray> rays, std::span<std::optional<Nearest>> hits) const {
  if (rays.size() != hits.size()) throw std::invalid_argument("closest: as many hits as rays are needed");
  if (rays.size() >= worth_sampling) {
    const double share = search_packets(tree_, rays.first(samples), hits.first(samples));
    rays = rays.subspan(samples);
    hits = hits.subspan(samples);
    if (share > alike) {
      search_packets(tree_, rays, hits);
      return;
    }
  }
  for (std::size_t from = 0; from < rays.size(); from += batch_size) {
    const std::size_t count = std::min(batch_size, rays.size() - from);
    search_batch(tree_, rays.subspan(from, count), hits.subspan(from, count));
  }
}

std::size_t TriangleTree::bytes() const { return tree_.bytes(); }

}  // namespace tribunal
