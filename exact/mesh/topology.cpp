#include "exact/mesh/topology.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <tuple>
#include <utility>

namespace tribunal {
namespace {

/// For each vertex the first one, in order of coordinates, at the same place; −0 and 0 are the same.
std::vector<std::uint32_t> places(const std::vector<Point3>& vertices) {
  const auto key = [&](std::uint32_t v) { return std::tie(vertices[v].x, vertices[v].y, vertices[v].z); };
  std::vector<std::uint32_t> order(vertices.size()), place(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i - 1]) == key(order[i]);
    place[order[i]] = same ? place[order[i - 1]] : order[i];
  }
  return place;
}

/// An edge as one face uses it, the lower vertex first.
struct Use {
  std::uint32_t low, high;
  bool upwards;
};

class Uses {
 public:
  explicit Uses(const Mesh& mesh) : place_(places(mesh.vertices)) {
    for (const auto& t : mesh.triangles) add_ring(t);
    for (const Rings& rings : mesh.polygons) {
      for (const auto& ring : rings) add_ring(ring);
    }
    const auto key = [](const Use& u) { return std::pair(u.low, u.high); };
    std::sort(uses_.begin(), uses_.end(), [&](const Use& a, const Use& b) { return key(a) < key(b); });
  }

  Topology count() const {
    Topology t;
    for (std::size_t first = 0, end = 0; first < uses_.size(); first = end) {
      std::size_t upwards = 0;
      for (; end < uses_.size() && is_same_edge(uses_[first], uses_[end]); ++end) upwards += uses_[end].upwards;
      const std::size_t all = end - first;
      ++t.edges;
      t.odd += all % 2;
      t.crowded += all > 2;
      t.unmatched += all % 2 == 0 && 2 * upwards != all;
    }
    return t;
  }

 private:
  template <class Ring>
  void add_ring(const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t a = place_[ring[i]], b = place_[ring[i + 1 == ring.size() ? 0 : i + 1]];
      if (a != b) uses_.push_back({std::min(a, b), std::max(a, b), a < b});
    }
  }

  static bool is_same_edge(const Use& a, const Use& b) { return a.low == b.low && a.high == b.high; }

  std::vector<std::uint32_t> place_;
  std::vector<Use> uses_;
};

/// Whether the enclosed volume is certainly negative. Six times the volume is summed from the first vertex over all
/// ring edges (each ring as a fan); the error of n terms is below (n + 16)·2⁻⁵² of the sum of their magnitudes, and
/// twice that is required.
bool is_certainly_negative_inside(const Mesh& mesh) {
  if (mesh.vertices.empty()) return false;
  const Point3& o = mesh.vertices.front();
  double sum = 0, magnitudes = 0, terms = 16;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Point3 u = mesh.vertices[a] - o, v = mesh.vertices[b] - o, w = mesh.vertices[c] - o;
    sum += glm::dot(u, glm::cross(v, w));
    magnitudes +=
        glm::dot(glm::abs(u), glm::abs(glm::cross(v, w))) + 2 * glm::length(u) * glm::length(v) * glm::length(w);
    ++terms;
  };
  for (const auto& t : mesh.triangles) add(t[0], t[1], t[2]);
  for (const Rings& rings : mesh.polygons) {
    for (const auto& ring : rings) {
      for (std::size_t i = 1; i + 1 < ring.size(); ++i) add(ring[0], ring[i], ring[i + 1]);
    }
  }
  return sum < -terms * 0x1p-51 * magnitudes;
}

std::string of_edges(std::size_t n, std::size_t all) {
  return std::to_string(n) + " of " + std::to_string(all) + (all == 1 ? " edge" : " edges");
}

}  // namespace

Topology topology_of(const Mesh& mesh) {
  Topology t = Uses(mesh).count();
  t.inward = t.oriented() && is_certainly_negative_inside(mesh);
  return t;
}

std::string describe(const Topology& t) {
  std::string text = t.closed() ? "closed" : "open: " + of_edges(t.odd, t.edges) + " with an odd number of faces";
  if (t.closed()) text += t.oriented() ? ", oriented" : "; faces turn against each other along ";
  if (t.closed() && !t.oriented()) text += of_edges(t.unmatched, t.edges);
  if (t.inward) text += ", but its faces look inwards";
  if (t.crowded > 0) text += "; non-manifold along " + of_edges(t.crowded, t.edges);
  return text;
}

}  // namespace tribunal
