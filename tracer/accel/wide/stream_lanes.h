// Many walks at once on vector lanes. Included by files that are compiled for one instruction set each.
//
// A walk is a chain: which box comes next is known only when the last one has been tested, and the branches of a walk
// cannot be foreseen. So a single walk leaves most of a core idle. Here some dozens of walks are under way; each is cut
// into steps without branches that depend on the tree (enter a node; sift a leaf; take out the nearest box that waits),
// and waits in one queue for each kind of step. Steps of one kind are done sixteen in a row: they do not depend on each
// other, so that the core overlaps them, and what a step has prefetched comes while others run.
// Compare Barringer and Akenine-Möller, "Dynamic Ray Stream Traversal", ACM TOG 33(4), 2014; Áfra et al., "Local
// Shading Coherence Extraction for SIMD-Efficient Path Tracing", HPG 2016, which sort rays for vector lanes; here lanes
// hold the boxes of a node and the triangles of a leaf, as in the single walk, and what is gained is overlap.
#pragma once

#include "tracer/accel/wide/probe_lanes.h"
#include "tracer/accel/wide/waiting_lanes.h"

namespace tribunal::HWY_NAMESPACE {

/// One walk that is under way.
struct Walker {
  const RayWalk* walk;
  float limit;  ///< that of the finder
  NodeRef at;
  WaitingBoxes waiting;
};

/// What a walker does next. The last two are neighbours: see after().
enum Step : std::uint32_t { enter_node, sift_leaf, take_next, start_walk };
inline constexpr std::size_t steps = 4;

/// Walkers by what they do next, first come first served.
class StepQueues {
 public:
  static constexpr std::uint32_t walkers = 64;

  void add(std::uint32_t step, Walker* w) { at_[step][tail_[step]++ % walkers] = w; }
  std::uint32_t waiting(Step step) const { return tail_[step] - head_[step]; }

  /// Calls act(walker) for the first n.
  template <class Act>
  HWY_INLINE void take(Step step, std::uint32_t n, const Act& act) {
    const std::uint32_t from = head_[step];
    head_[step] += n;
    for (std::uint32_t i = from; i != from + n; ++i) act(*at_[step][i % walkers]);
  }

 private:
  std::uint32_t head_[steps] = {}, tail_[steps] = {};
  Walker* at_[steps][walkers];
};

/// The walks of a list.
class Stream {
 public:
  Stream(const WideTree& tree, std::span<const RayWalk> walks, WalkCounts& counts)
      : tree_(tree), prefetch_(tree), next_(walks.data()), end_(walks.data() + walks.size()), counts_(counts) {
    for (Walker& w : walkers_) queues_.add(start_walk, &w);
  }

  /// While all walkers are at work, some queue holds sixteen of them, there being more than four times fifteen.
  HWY_INLINE void run() {
    constexpr std::uint32_t in_a_row = 16;
    static_assert(StepQueues::walkers > steps * (in_a_row - 1));
    while (true) {
      if (queues_.waiting(enter_node) >= in_a_row) {
        enter_nodes(in_a_row);
      } else if (queues_.waiting(sift_leaf) >= in_a_row) {
        sift_leaves(in_a_row);
      } else if (queues_.waiting(take_next) >= in_a_row) {
        take_nexts(in_a_row);
      } else if (queues_.waiting(start_walk) >= in_a_row && next_ != end_) {
        start_walks(in_a_row);
      } else if (!do_the_rest()) {
        return;
      }
    }
  }

 private:
  /// All steps that wait, of which there are few. Whether there was any.
  HWY_INLINE bool do_the_rest() {
    start_walks(queues_.waiting(start_walk));
    const std::uint32_t nodes = queues_.waiting(enter_node), leaves = queues_.waiting(sift_leaf),
                        nexts = queues_.waiting(take_next);
    enter_nodes(nodes);
    sift_leaves(leaves);
    take_nexts(nexts);
    return nodes + leaves + nexts != 0;
  }

  /// Walkers for which there is no walk left are heard of no more.
  HWY_INLINE void start_walks(std::uint32_t n) {
    queues_.take(start_walk, n, [&](Walker& w) HWY_ATTR {
      if (next_ == end_) return;
      w.walk = next_++;
      w.limit = w.walk->finder->limit;
      w.waiting.clear();
      go_to(tree_.root(), w);
    });
  }

  HWY_INLINE void enter_nodes(std::uint32_t n) {
    counts_.boxes += std::uint64_t{n} * node_width;
    queues_.take(enter_node, n, [&](Walker& w) HWY_ATTR {
      if (HWY_UNLIKELY(!w.waiting.has_room())) return finish_alone(w);
      const WideNode& node = tree_.nodes()[w.at.index()];
      float entry[node_width];
      const unsigned met = BoxLanes(*w.walk->probe).entered(node, w.limit, entry), nearest = nearest_of(entry, met);
      w.waiting.push(entry, node.child, met & ~(1U << nearest));
      go_to(node.child[nearest], w, after(w), met == 0);
    });
  }

  HWY_INLINE void sift_leaves(std::uint32_t n) {
    queues_.take(sift_leaf, n, [&](Walker& w) HWY_ATTR {
      LeafSieve<Ray>(*w.walk->ray).sift(tree_, w.at, sifted_, counts_);
      if (sifted_.rest != 0) {
        sifted_.tell(w.at, *w.walk->finder);
        w.limit = w.walk->finder->limit;
      }
      queues_.add(after(w), &w);
    });
  }

  HWY_INLINE void take_nexts(std::uint32_t n) {
    queues_.take(take_next, n, [&](Walker& w) HWY_ATTR {
      NodeRef child;
      const float entry = w.waiting.pop(child);
      go_to(child, w, start_walk, entry > w.limit);
    });
  }

  /// What follows where a walk can get no deeper.
  static std::uint32_t after(const Walker& w) { return take_next + std::uint32_t{w.waiting.empty()}; }

  /// Sends a walker on to a node or leaf; or rather, if `else_if`, to another step. By arithmetic, not by branches.
  HWY_INLINE void go_to(NodeRef child, Walker& w, std::uint32_t other = start_walk, bool else_if = false) {
    w.at = child;
    prefetch_(child);
    const std::uint32_t leaf = child.is_leaf(), instead = else_if;
    queues_.add((leaf & ~instead) | instead * other, &w);
  }

  /// A walk in so deep a tree, or among so many boxes, that too many wait: starts again on its own, where proof bounds
  /// them, with what it has found.
  HWY_NOINLINE void finish_alone(Walker& w) {
    sift<Ray>(tree_, *w.walk->probe, *w.walk->ray, *w.walk->finder, counts_);
    queues_.add(start_walk, &w);
  }

  const WideTree& tree_;
  const Prefetcher prefetch_;
  const RayWalk* next_;
  const RayWalk* const end_;
  WalkCounts& counts_;
  StepQueues queues_;
  Sifted sifted_;
  Walker walkers_[StepQueues::walkers];
};

[[gnu::flatten]] inline void sift_rays(const WideTree& tree, std::span<const RayWalk> walks, WalkCounts& counts) {
  if (!tree.empty()) Stream(tree, walks, counts).run();
}

inline constexpr TreeTarget tree_target_here() { return {sift<Ray>, sift<Segment>, visit_all, make_probes, sift_rays}; }

}  // namespace tribunal::HWY_NAMESPACE
