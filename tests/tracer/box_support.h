// Trees over boxes alone, and the candidates of a walk through them.
#pragma once

#include <set>
#include <vector>

#include "tracer/accel/wide/traversal.h"
#include "tracer/accel/wide/tree.h"

namespace tribunal::testing {

inline Box box_between(const Point3& a, const Point3& b) {
  Box box;
  box.add(a);
  box.add(b);
  return box;
}

struct Collector final : CandidateQuery {
  explicit Collector(const WideTree& t) : tree(t) {}
  bool found(const Candidate& f) override {
    ids.insert(tree.id(f.place));
    return false;
  }
  const WideTree& tree;
  std::set<std::uint32_t> ids;
};

inline std::set<std::uint32_t> offered(const WideTree& tree, const WideProbe& probe, float limit) {
  Collector collector(tree);
  collector.limit = limit;
  WalkCounts counts;
  tree_target().visit_all(tree, probe, collector, counts);
  return collector.ids;
}

inline WideTree tree_over(const std::vector<Box>& boxes) {
  return WideTree(static_cast<std::uint32_t>(boxes.size()), [&](std::uint32_t i) { return Primitive{boxes[i], {}}; });
}

}  // namespace tribunal::testing
