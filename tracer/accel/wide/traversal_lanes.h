// The walk on vector lanes. Included by files that are compiled for one instruction set each.
#pragma once

#include <hwy/cache_control.h>

#include <bit>

#include "tracer/accel/wide/box_lanes.h"
#include "tracer/accel/wide/leaf_filter.h"

namespace tribunal::HWY_NAMESPACE {

inline constexpr std::size_t cache_line = 64;

/// The constants of a probe in every lane.
struct BoxLanes {
  struct Axis {
    BoxVector r, near_c, far_c;
    std::uint32_t near_plane, far_plane;  ///< where the near and far planes start in WideNode::plane
  };

  explicit BoxLanes(const WideProbe& p) : x(axis(p.axes[0])), y(axis(p.axes[1])), z(axis(p.axes[2])) {}

  /// The children that the probe may meet at τ ≤ limit, a bit each; entry[k] is a lower bound of the τ at which. No
  /// entry is −0, since Max returns the second of equal operands.
  HWY_INLINE unsigned entered(const WideNode& node, float limit, float* entry) const {
    unsigned met = 0;
    for (std::size_t k = 0; k < node_width; k += hn::Lanes(box_tag)) {
      const BoxVector first =
          hn::Max(hn::Max(near(node, x, k), near(node, y, k)), hn::Max(near(node, z, k), hn::Zero(box_tag)));
      const BoxVector last =
          hn::Min(hn::Min(far(node, x, k), far(node, y, k)), hn::Min(far(node, z, k), hn::Set(box_tag, limit)));
      hn::StoreU(first, box_tag, entry + k);
      met |= bits_of(box_tag, hn::Le(first, last)) << k;
    }
    return met;
  }

 private:
  static Axis axis(const WideProbe::Axis& a) {
    return {hn::Set(box_tag, a.r), hn::Set(box_tag, a.near_c), hn::Set(box_tag, a.far_c), a.near_plane, a.far_plane};
  }
  static HWY_INLINE BoxVector near(const WideNode& node, const Axis& a, std::size_t k) {
    return hn::MulSub(hn::LoadU(box_tag, node.plane[0] + a.near_plane + k), a.r, a.near_c);
  }
  static HWY_INLINE BoxVector far(const WideNode& node, const Axis& a, std::size_t k) {
    return hn::MulSub(hn::LoadU(box_tag, node.plane[0] + a.far_plane + k), a.r, a.far_c);
  }

  Axis x, y, z;
};

/// The traversal stack; the child that is entered first is on top. Entry and child are packed into one integer, which
/// sorts by the entry since no entry is negative.
class WaitingNodes {
 public:
  static std::uint64_t key(float entry, NodeRef child) {
    return std::uint64_t{std::bit_cast<std::uint32_t>(entry)} << 32 | child.bits();
  }

  bool empty() const { return size_ == 0; }
  std::uint64_t pop() { return keys_[--size_]; }
  void push(std::uint64_t key) { keys_[size_++] = key; }

  /// Sorts the elements from index `from` on, the least entry on top.
  void sort_from(std::size_t from) {
    for (std::size_t i = from + 1; i < size_; ++i) {
      const std::uint64_t key = keys_[i];
      std::size_t k = i;
      for (; k > from && keys_[k - 1] < key; --k) keys_[k] = keys_[k - 1];
      keys_[k] = key;
    }
  }
  std::size_t size() const { return size_; }

 private:
  std::size_t size_ = 0;
  std::uint64_t keys_[most_waiting];
};

/// Prefetches the first cache lines of a node or leaf.
class Prefetcher {
 public:
  explicit Prefetcher(const WideTree& tree)
      : start_{as_bytes(tree.nodes()), as_bytes(tree.columns(NodeRef::leaf(0, 1)))} {}

  /// Has no branch: whether r is a node or a leaf cannot be predicted.
  HWY_INLINE void operator()(NodeRef r) const {
    static constexpr std::size_t size[] = {sizeof(WideNode), column_count * sizeof(double)};
    const char* const wanted = start_[r.is_leaf()] + size[r.is_leaf()] * r.first();
    for (std::size_t offset = 0; offset < 256; offset += cache_line) hwy::Prefetch(wanted + offset);
  }

 private:
  static const char* as_bytes(const void* p) { return static_cast<const char*>(p); }

  const char* start_[2];
};

/// Pushes the children that are met, but for the one entered first, which is returned. At least one must be met.
HWY_INLINE std::uint64_t first_of(const Prefetcher& prefetch, const WideNode& node, unsigned met, const float* entry,
                                  WaitingNodes& waiting) {
  const auto next = [&] {
    const auto k = static_cast<std::size_t>(std::countr_zero(met));
    met &= met - 1;
    prefetch(node.child[k]);
    return WaitingNodes::key(entry[k], node.child[k]);
  };
  const std::uint64_t a = next();
  if (met == 0) return a;
  const std::uint64_t b = next();
  if (met == 0) {
    waiting.push(a < b ? b : a);
    return a < b ? a : b;
  }
  const std::size_t from = waiting.size();
  waiting.push(a);
  waiting.push(b);
  while (met != 0) waiting.push(next());
  waiting.sort_from(from);
  return waiting.pop();
}

/// Calls leaf(ref) for every leaf that the probe may meet at τ ≤ the query's limit, nearer ones first, until `leaf`
/// returns true.
template <class Leaf>
HWY_INLINE void walk(const WideTree& tree, const WideProbe& probe, const CandidateQuery& query, WalkCounts& counts,
                     const Leaf& leaf) {
  if (tree.empty()) return;
  const BoxLanes lanes(probe);
  const Prefetcher prefetch(tree);
  const WideNode* const nodes = tree.nodes();
  WaitingNodes waiting;
  NodeRef at = tree.root();
  while (true) {
    bool descend = false;
    if (at.is_leaf()) {
      if (leaf(at)) return;
    } else {
      const WideNode& node = nodes[at.index()];
      float entry[node_width];
      counts.boxes += node_width;
      const unsigned met = lanes.entered(node, query.limit, entry);
      descend = met != 0;
      if (descend) at = NodeRef(static_cast<std::uint32_t>(first_of(prefetch, node, met, entry, waiting)));
    }
    while (!descend) {
      if (waiting.empty()) return;
      const std::uint64_t key = waiting.pop();
      at = NodeRef(static_cast<std::uint32_t>(key));
      descend = std::bit_cast<float>(static_cast<std::uint32_t>(key >> 32)) <= query.limit;
    }
  }
}

template <class P>
[[gnu::flatten]] void filter(const WideTree& tree, const WideProbe& probe, const P& exact_probe, CandidateQuery& query,
                             WalkCounts& counts) {
  const LeafFilter<P> filter(exact_probe);
  Filtered filtered;
  walk(tree, probe, query, counts, [&](NodeRef leaf) HWY_ATTR {
    if (!leaf.holds_triangles()) return report_all(leaf, query);
    filter.filter(tree, leaf, filtered, counts);
    return filtered.rest != 0 && filtered.report(leaf, query);
  });
}

[[gnu::flatten]] inline void visit_all(const WideTree& tree, const WideProbe& probe, CandidateQuery& query,
                                       WalkCounts& counts) {
  walk(tree, probe, query, counts, [&](NodeRef leaf) { return report_all(leaf, query); });
}

}  // namespace tribunal::HWY_NAMESPACE
