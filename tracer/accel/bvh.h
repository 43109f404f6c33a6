// Which faces a probe may meet: all of them, those of the solids whose box it meets, or those of a tree of boxes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "tracer/accel/box.h"
#include "tracer/statistics.h"

namespace tribunal {

/// `none`: every face is tested; `boxes`: one box a solid, as in the paper; `bvh`: a binary tree of boxes.
enum class Accel : std::uint8_t { none, boxes, bvh };

constexpr std::string_view name_of(Accel a) {
  constexpr std::string_view names[] = {"none", "boxes", "bvh"};
  return names[static_cast<int>(a)];
}

/// A tree of boxes over primitives, of any shape; the three modes are three shapes, and one traversal serves all.
/// Law: every primitive that a probe exactly meets at t ≤ limit is visited. It may over-report, never under-report.
class BoxTree {
 public:
  /// Primitive ids are indices into `boxes`; those of one solid follow each other, `solid_of` ascending.
  BoxTree(Accel mode, std::vector<Box> boxes, std::span<const std::uint32_t> solid_of);

  /// Room for a traversal, one a thread.
  using Stack = std::vector<std::pair<double, std::uint32_t>>;

  /// Calls visit(id) for candidates, nearer boxes first, until it returns true. Boxes that begin beyond `limit` are
  /// skipped; visit may lower it on the way.
  template <class Visit>
  void traverse(const BoxProbe& probe, const double& limit, Stack& stack, RayTally& tally, const Visit& visit) const {
    stack.assign(1, {0.0, 0});
    while (!stack.empty()) {
      const auto [entry, index] = stack.back();
      stack.pop_back();
      if (entry > limit) continue;
      const Node& node = nodes_[index];
      if (!node.leaf) {
        push_children(node, probe, limit, stack, tally);
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        if (visit(ids_[i])) return;
      }
    }
  }

  std::size_t node_count() const { return nodes_.size(); }
  std::size_t bytes() const { return nodes_.size() * sizeof(Node) + ids_.size() * sizeof ids_[0]; }

 private:
  /// A leaf holds ids_[first .. first+count), an inner node the children nodes_[first .. first+count).
  struct Node {
    Box box;
    std::uint32_t first = 0, count = 0;
    bool leaf = true;
  };

  void push_children(const Node& node, const BoxProbe& probe, double limit, Stack& stack, RayTally& tally) const {
    const std::size_t old = stack.size();
    for (std::uint32_t child = node.first; child < node.first + node.count; ++child) {
      ++tally.box_tests;
      const Span span = probe.span(nodes_[child].box);
      if (!span.empty() && span.first <= limit) stack.emplace_back(span.first, child);
    }
    std::sort(stack.begin() + static_cast<std::ptrdiff_t>(old), stack.end(), std::greater<>());
  }

  void make_solid_boxes(std::span<const std::uint32_t> solid_of);
  void split(std::uint32_t index, int level);
  Box box_of_ids(std::uint32_t first, std::uint32_t count) const;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> ids_;
  std::vector<Box> boxes_;  ///< of each primitive; only while building
};

}  // namespace tribunal
