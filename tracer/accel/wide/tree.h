// Eight boxes a node, up to eight triangles a leaf: what the tree of mode `bvh` is made of.
// Source of the shape: Wald, Benthin, Boulos, "Getting Rid of Packets", RT 2008 (wide nodes for single rays); Dammertz,
// Hanika, Keller, "Shallow Bounding Volume Hierarchies for Fast SIMD Ray Tracing of Incoherent Rays", CGF 27(4), 2008.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "tracer/accel/wide/box.h"
#include "tracer/accel/wide/large_pages.h"

namespace tribunal {

inline constexpr std::size_t node_width = 8, leaf_size = 8, column_count = 10;

/// What a slot of a node refers to: a node by its index, or a leaf by its first primitive, their number, and whether
/// they are triangles.
class NodeRef {
 public:
  static constexpr std::uint32_t most_primitives = 1u << 27;

  constexpr NodeRef() = default;
  explicit constexpr NodeRef(std::uint32_t bits) : bits_(bits) {}
  static constexpr NodeRef node(std::uint32_t index) { return NodeRef(index); }
  static constexpr NodeRef leaf(std::uint32_t first, std::uint32_t count, bool triangles = true) {
    return NodeRef(1u << 31 | (count - 1) << 28 | (triangles ? 0 : most_primitives) | first);
  }

  constexpr bool is_leaf() const { return bits_ >> 31 != 0; }
  constexpr std::uint32_t index() const { return bits_; }
  constexpr std::uint32_t first() const { return bits_ & (most_primitives - 1); }
  constexpr std::uint32_t count() const { return (bits_ >> 28 & 7) + 1; }
  constexpr bool holds_triangles() const { return (bits_ & most_primitives) == 0; }
  constexpr std::uint32_t bits() const { return bits_; }

 private:
  std::uint32_t bits_ = 0;
};

/// The builder cuts a set in two where that is cheapest; after this many cuts it halves sets by number instead, which
/// bounds the depth.
inline constexpr std::uint32_t most_cuts_by_cost = 48;

/// The size of the left half of a set of n; if n is odd, the right half has one more.
constexpr std::size_t half_of(std::size_t n) { return n / 2; }

/// The greatest number of halvings until each of n primitives is alone.
constexpr std::uint32_t most_halvings(std::size_t n) { return n < 2 ? 0 : 1 + most_halvings(n - half_of(n)); }

/// The greatest number of cuts between the whole set and a leaf. A single primitive is always a leaf, so after the
/// cuts by cost no set is halved more often than the largest possible set would be.
inline constexpr std::uint32_t most_cuts = most_cuts_by_cost + most_halvings(NodeRef::most_primitives);
static_assert(most_cuts == 48 + 27);

/// The greatest number of nodes and leaves on the traversal stack at once. Each node is at least one cut below its
/// parent and a leaf is no node, so no path has more than `most_cuts` nodes. While all children of the last node on a
/// path wait, each other node of the path has all but one of its children waiting.
inline constexpr std::size_t most_waiting = most_cuts * (node_width - 1) + 1;

/// Where the boxes' binary32 coordinates live: X = (x − centre)·unit, so that a mesh keeps sharp boxes however far from
/// the origin it lies. `unit` is a power of two; it makes the largest |X| about 1 where its own range allows.
struct Frame {
  Point3 centre{0};
  double unit = 1;
  double reach = 0;  ///< the largest |X| of any box
};

/// Boxes by planes: lo x, lo y, lo z, hi x, hi y, hi z, of up to eight children. A box in the frame contains the box of
/// its primitives. Slots without a child have empty boxes (planes ±2¹⁰⁰), which no probe meets.
struct alignas(32) WideNode {
  float plane[6][node_width];
  NodeRef child[node_width];

  bool is_empty(std::size_t k) const { return plane[0][k] > plane[3][k]; }
};

/// A primitive for the tree: its box, and its vertices if it is a triangle. Tests of other primitives are left to the
/// caller.
struct Primitive {
  Box box;
  std::optional<Triangle> triangle;
};

/// The position of a primitive in the tree: lane `lane` of a leaf.
struct Place {
  NodeRef leaf;
  std::uint32_t lane;
};

/// The tree. Leaves hold their triangles by columns (a.x of all, a.y of all, …, c.z of all, and the ids, as doubles)
/// without gaps, so that 8 lanes load them at once. A primitive that is no triangle has NaN coordinates, for which
/// every filter fails.
class WideTree {
 public:
  WideTree() = default;

  /// Builds the tree over the primitives 0 … count − 1. It depends on the primitives alone, not on the number of
  /// threads that build it. Coordinates must be finite. Throws std::length_error beyond 2²⁷ primitives.
  WideTree(std::uint32_t count, const std::function<Primitive(std::uint32_t)>& primitive);

  bool empty() const { return columns_.empty(); }
  NodeRef root() const { return root_; }
  const Frame& frame() const { return frame_; }
  const WideNode* nodes() const { return nodes_.data(); }

  /// Columns of a leaf, each `count` long; 8 numbers may be read from the start of each.
  const double* columns(NodeRef leaf) const { return columns_.data() + column_count * leaf.first(); }

  std::uint32_t id(Place p) const { return static_cast<std::uint32_t>(columns(p.leaf)[9 * p.leaf.count() + p.lane]); }

  /// The coordinates of a triangle, bit for bit; NaN for a primitive that is no triangle.
  Triangle triangle(Place p) const;

  /// Calls visit(place) for every primitive.
  template <class Visit>
  void for_each_place(const Visit& visit) const {
    const auto visit_leaf = [&](NodeRef r) {
      for (std::uint32_t lane = 0; lane < r.count(); ++lane) visit(Place{r, lane});
    };
    if (root_.is_leaf() && !empty()) visit_leaf(root_);
    for (const WideNode& node : nodes_) {
      for (std::size_t k = 0; k < node_width && !node.is_empty(k); ++k) {
        if (node.child[k].is_leaf()) visit_leaf(node.child[k]);
      }
    }
  }

  std::size_t node_count() const { return nodes_.size(); }
  std::size_t bytes() const;

 private:
  friend class WideBuilder;

  Frame frame_;
  NodeRef root_;
  std::vector<WideNode, LargePages<WideNode>> nodes_;
  std::vector<double, LargePages<double>> columns_;
};

}  // namespace tribunal
