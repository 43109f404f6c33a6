// Many walks at once on vector lanes. Included by files that are compiled for one instruction set each.
//
// A walk is a chain: which box comes next is known only when the last one has been tested, and the branches of a walk
// cannot be foreseen. So a single walk leaves most of a core idle. Here some dozens of walks are under way; each is cut
// into steps without branches that depend on the tree (enter a node; filter a leaf; take out the nearest box that
// waits), and waits in one queue for each kind of step. Queues are served in turn: the steps of one do not depend on
// each other, so that the core overlaps them, and what a step has prefetched comes while others run. Compare Barringer
// and Akenine-Möller, "Dynamic Ray Stream Traversal", ACM TOG 33(4), 2014; Áfra et al., "Local Shading Coherence
// Extraction for SIMD-Efficient Path Tracing", HPG 2016, which sort rays for vector lanes; here lanes hold the boxes of
// a node and the triangles of a leaf, as in the single walk, and what is gained is overlap.
#pragma once

#include "tracer/accel/wide/probe_lanes.h"
#include "tracer/accel/wide/waiting_lanes.h"

namespace tribunal::HWY_NAMESPACE {

/// One walk that is under way.
struct Walker {
  const RayWalk* walk;
  float limit;  ///< the query's limit, copied after each leaf
  NodeRef at;
  WaitingBoxes waiting;
};

/// What a walker does next. The order matters: after() adds 1 to take_next to get start_walk.
enum Step : std::uint32_t { enter_node, filter_leaf, take_next, start_walk };
inline constexpr std::size_t steps = 4;

/// Walkers by what they do next, first come first served.
class StepQueues {
 public:
  static constexpr std::uint32_t walkers = 64;

  void add(std::uint32_t step, Walker* w) { at_[step][tail_[step]++ % walkers] = w; }

  bool any_waits() const { return !std::equal(head_, head_ + steps, tail_); }

  /// Calls act(walker) for all that wait now, not for those that are added meanwhile. Returns how many.
  template <class Act>
  HWY_INLINE std::uint32_t take_all(Step step, const Act& act) {
    const std::uint32_t from = head_[step], to = tail_[step];
    head_[step] = to;
    for (std::uint32_t i = from; i != to; ++i) act(*at_[step][i % walkers]);
    return to - from;
  }

 private:
  std::uint32_t head_[steps] = {}, tail_[steps] = {};
  Walker* at_[steps][walkers];
};

/// Runs all walks of a list, up to 64 in turn.
class Stream {
 public:
  Stream(const WideTree& tree, std::span<const RayWalk> walks, WalkCounts& counts)
      : tree_(tree), prefetch_(tree), next_(walks.data()), end_(walks.data() + walks.size()), counts_(counts) {
    for (Walker& w : walkers_) queues_.add(start_walk, &w);
  }

  HWY_INLINE void run() {
    do {
      start_walks();
      enter_nodes();
      filter_leaves();
      take_nexts();
    } while (queues_.any_waits());
  }

 private:
  /// Gives the next walks of the list to idle walkers. A walker for which no walk is left enters no queue again.
  HWY_INLINE void start_walks() {
    queues_.take_all(start_walk, [&](Walker& w) HWY_ATTR {
      if (next_ == end_) return;
      w.walk = next_++;
      w.limit = w.walk->query->limit;
      w.waiting.clear();
      go_to(tree_.root(), w);
    });
  }

  HWY_INLINE void enter_nodes() {
    const std::uint32_t nodes = queues_.take_all(enter_node, [&](Walker& w) HWY_ATTR {
      if (HWY_UNLIKELY(!w.waiting.has_room())) return finish_alone(w);
      const WideNode& node = tree_.nodes()[w.at.index()];
      float entry[node_width];
      const unsigned met = BoxLanes(*w.walk->probe).entered(node, w.limit, entry), nearest = nearest_of(entry, met);
      w.waiting.push(entry, node.child, met & ~(1U << nearest));
      go_to(node.child[nearest], w, after(w), met == 0);
    });
    counts_.boxes += std::uint64_t{nodes} * node_width;
  }

  HWY_INLINE void filter_leaves() {
    queues_.take_all(filter_leaf, [&](Walker& w) HWY_ATTR {
      LeafFilter<Ray>(*w.walk->ray).filter(tree_, w.at, filtered_, counts_);
      if (filtered_.rest != 0) {
        filtered_.report(w.at, *w.walk->query);
        w.limit = w.walk->query->limit;
      }
      queues_.add(after(w), &w);
    });
  }

  HWY_INLINE void take_nexts() {
    queues_.take_all(take_next, [&](Walker& w) HWY_ATTR {
      NodeRef child;
      const float entry = w.waiting.pop(child);
      go_to(child, w, start_walk, entry > w.limit);
    });
  }

  /// The next step of a walk that is done with a node or leaf: take_next while boxes wait, else start_walk.
  static std::uint32_t after(const Walker& w) { return take_next + std::uint32_t{w.waiting.empty()}; }

  /// Queues a walker for the child, a node or a leaf; if `else_if`, for the step `other` instead. Computed without
  /// branches.
  HWY_INLINE void go_to(NodeRef child, Walker& w, std::uint32_t other = start_walk, bool else_if = false) {
    w.at = child;
    prefetch_(child);
    const std::uint32_t leaf = child.is_leaf(), instead = else_if;
    queues_.add((leaf & ~instead) | instead * other, &w);
  }

  /// For a walk in which more boxes wait than a walker holds: the walk starts again as a single walk, the stack of
  /// which is proved to be large enough. Its query keeps the candidates that it has taken.
  HWY_NOINLINE void finish_alone(Walker& w) {
    filter<Ray>(tree_, *w.walk->probe, *w.walk->ray, *w.walk->query, counts_);
    queues_.add(start_walk, &w);
  }

  const WideTree& tree_;
  const Prefetcher prefetch_;
  const RayWalk* next_;
  const RayWalk* const end_;
  WalkCounts& counts_;
  StepQueues queues_;
  Filtered filtered_;
  Walker walkers_[StepQueues::walkers];
};

[[gnu::flatten]] inline void filter_rays(const WideTree& tree, std::span<const RayWalk> walks, WalkCounts& counts) {
  if (!tree.empty()) Stream(tree, walks, counts).run();
}

inline constexpr TreeTarget tree_target_here() {
  return {filter<Ray>, filter<Segment>, visit_all, make_probes, filter_rays};
}

}  // namespace tribunal::HWY_NAMESPACE
