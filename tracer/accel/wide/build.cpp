// Builds the tree from the top: a set is cut in two again and again until there are eight, which become a node.
// Source of the order (the child of largest area is cut next): Wald, Benthin, Boulos, RT 2008; Embree's builders.
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/format.h"
#include "exact/filtered/stages/default_rounding.h"
#include "tracer/accel/wide/bins.h"
#include "tracer/accel/wide/tree.h"

namespace tribunal {
namespace {

constexpr std::size_t worth_a_task = 4096;  ///< sets of fewer primitives are not split among threads
constexpr float beyond = 0x1p100F;

/// A binary32 number at or below x that is neither subnormal itself nor so small that its products with reciprocals
/// are: processors take 150 cycles more for subnormal numbers.
float float_below(double x) {
  if (std::fabs(x) < 0x1p-100) return x < 0 ? -0x1p-100F : 0.0F;
  const float f = static_cast<float>(to_binary32(x));
  return static_cast<double>(f) > x ? std::nextafterf(f, -FrameBox::infinity) : f;
}

/// The frame of a box: the unit brings half of its largest side to between 1/2 and 1.
Frame frame_of(const Box& b) {
  Frame frame;
  if (b.lo.x > b.hi.x) return frame;
  const Point3 half = 0.5 * b.hi - 0.5 * b.lo;
  int exponent = 0;
  std::frexp(std::max({half.x, half.y, half.z}), &exponent);
  frame.centre = 0.5 * b.lo + 0.5 * b.hi;
  frame.unit = std::ldexp(1.0, std::clamp(-exponent, -1000, 1000));
  return frame;
}

/// A lower bound of (x − centre)·unit. No x lies farther than 2³⁰ units from the centre, whatever rounding says.
float low_in(const Frame& frame, double x, int axis) {
  const double scaled = below(below(x - frame.centre[axis]) * frame.unit);
  return float_below(std::max(scaled, -0x1p30));
}

float high_in(const Frame& frame, double x, int axis) { return -low_in({-frame.centre, frame.unit, 0}, -x, axis); }

FrameBox in_frame(const Frame& f, const Box& b) {
  FrameBox box;
  for (int i = 0; i < 3; ++i) {
    box.lo[i] = low_in(f, b.lo[i], i);
    box.hi[i] = high_in(f, b.hi[i], i);
  }
  box.lo[3] = box.hi[3] = 0;
  return box;
}

using Refs = std::span<BuildRef>;
using Nodes = std::vector<WideNode, LargePages<WideNode>>;

/// A part of the primitives on its way to become a child.
struct Part {
  Refs refs;
  BinExtent extent;
  std::uint32_t cuts = 0;  ///< how many cuts led from the whole set to this part
};

BinExtent extent_of(Refs refs) {
  BinExtent e;
  for (const BuildRef& r : refs) e.add(r);
  return e;
}

/// Sums over refs, in parallel if there are many. The result must not depend on the order, as that of least and
/// greatest does not.
template <class Sum, class Add, class Join>
Sum summed(Refs refs, const Sum& zero, const Add& add, const Join& join) {
  if (refs.size() < 8 * worth_a_task) return add(refs, zero);
  return tbb::parallel_deterministic_reduce(
      tbb::blocked_range<std::size_t>(0, refs.size(), worth_a_task), zero,
      [&](const tbb::blocked_range<std::size_t>& range, const Sum& sum) {
        return add(refs.subspan(range.begin(), range.size()), sum);
      },
      join);
}

/// Runs the work with the threads that are allowed. Where that is one, in an arena of its own: TBB would start a second
/// thread for its default arena all the same, and a process may not be allowed to.
template <class Work>
void in_allowed_threads(const Work& work) {
  using tbb::global_control;
  if (global_control::active_value(global_control::max_allowed_parallelism) > 1) return work();
  tbb::task_arena(1).execute(work);
}

}  // namespace

class WideBuilder {
 public:
  WideBuilder(WideTree& tree, std::uint32_t count, const std::function<Primitive(std::uint32_t)>& primitive)
      : tree_(tree), primitive_(primitive), refs_(count) {}

  void build() {
    const std::uint32_t count = static_cast<std::uint32_t>(refs_.size());
    tree_.frame_ = frame_of(bounds(count));
    tbb::parallel_for(std::uint32_t{0}, count, [&](std::uint32_t i) {
      const Primitive p = primitive_(i);
      refs_[i] = {in_frame(tree_.frame_, p.box), i, p.triangle.has_value()};
    });
    if (count == 0) return;
    tree_.columns_.resize(column_count * count + leaf_size);
    const Part all{refs_, extent_in_parallel(refs_), 0};
    tree_.frame_.reach = reach_of(all.extent.box);
    tree_.root_ = grow(all, tree_.nodes_);
    tree_.nodes_.shrink_to_fit();
  }

 private:
  Box bounds(std::uint32_t count) const {
    return tbb::parallel_deterministic_reduce(
        tbb::blocked_range<std::uint32_t>(0, count, worth_a_task), Box(),
        [&](const tbb::blocked_range<std::uint32_t>& range, Box box) {
          for (std::uint32_t i = range.begin(); i < range.end(); ++i) box.add(primitive_(i).box);
          return box;
        },
        [](Box a, const Box& b) {
          a.add(b);
          return a;
        });
  }

  static BinExtent extent_in_parallel(Refs refs) {
    return summed(
        refs, BinExtent(),
        [](Refs some, BinExtent e) {
          e.add(extent_of(some));
          return e;
        },
        [](BinExtent a, const BinExtent& b) {
          a.add(b);
          return a;
        });
  }

  static double reach_of(const FrameBox& b) {
    double reach = 0;
    for (int i = 0; i < 3; ++i) reach = std::max({reach, std::fabs(double{b.lo[i]}), std::fabs(double{b.hi[i]})});
    return reach;
  }

  /// Partitions the refs by the cheapest cut and returns the size of the left side; 0 if no cut separates them.
  static std::size_t part_by_cost(const Part& p) {
    const Binning binning(p.extent.centres);
    const Bins bins = summed(
        p.refs, Bins(),
        [&](Refs some, Bins b) {
          b.add(some, binning);
          return b;
        },
        [](Bins a, const Bins& b) {
          a.add(b);
          return a;
        });
    const Cut cut = bins.best(binning);
    if (cut.axis < 0) return 0;
    const auto middle = std::partition(p.refs.begin(), p.refs.end(),
                                       [&](const BuildRef& r) { return binning.bin(r, cut.axis) < cut.bin; });
    return static_cast<std::size_t>(middle - p.refs.begin());
  }

  /// Halves the refs by number, along the axis on which the centres extend farthest; ids break ties. Returns the size
  /// of the left half.
  static std::size_t part_by_number(const Part& p) {
    const Float4 size = p.extent.centres.hi - p.extent.centres.lo;
    const int axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : size[1] >= size[2] ? 1 : 2;
    const std::size_t middle = half_of(p.refs.size());
    std::nth_element(p.refs.begin(), p.refs.begin() + static_cast<std::ptrdiff_t>(middle), p.refs.end(),
                     [axis](const BuildRef& a, const BuildRef& b) {
                       return std::pair(a.centre()[axis], a.id) < std::pair(b.centre()[axis], b.id);
                     });
    return middle;
  }

  static std::pair<Part, Part> cut(const Part& p) {
    std::size_t middle = p.cuts < most_cuts_by_cost ? part_by_cost(p) : 0;
    if (middle == 0 || middle == p.refs.size()) middle = part_by_number(p);
    const Refs left = p.refs.first(middle), right = p.refs.subspan(middle);
    return {{left, extent_in_parallel(left), p.cuts + 1}, {right, extent_in_parallel(right), p.cuts + 1}};
  }

  /// Whether the refs make one leaf: up to eight triangles, which are tested together, or a single primitive of
  /// another kind.
  static bool fits_leaf(Refs refs) {
    return refs.size() == 1 || (refs.size() <= leaf_size &&
                                std::all_of(refs.begin(), refs.end(), [](const BuildRef& r) { return r.is_triangle; }));
  }

  /// Cuts a part into up to eight, in the order of their refs. The next to be cut is the one of largest area that is
  /// too large for a leaf; if slots are left then, parts that fit a leaf are cut too, since all eight boxes of a node
  /// are tested anyway.
  static std::vector<Part> children_of(const Part& whole) {
    std::vector<Part> parts{whole};
    while (parts.size() < node_width) {
      const auto gain = [](const Part& p) {
        const bool must = !fits_leaf(p.refs);
        return std::pair(must, must || p.refs.size() > 2 ? p.extent.box.area() : -1);
      };
      const auto best =
          std::max_element(parts.begin(), parts.end(), [&](const Part& a, const Part& b) { return gain(a) < gain(b); });
      if (gain(*best).second < 0) break;
      const auto [left, right] = cut(*best);
      *best = left;
      parts.insert(best + 1, right);
    }
    return parts;
  }

  /// Appends the nodes of a part to `nodes` and returns its root. The children of a large part are built in parallel,
  /// each into nodes of its own, which are then appended in order.
  NodeRef grow(const Part& part, Nodes& nodes) {
    if (fits_leaf(part.refs)) return fill_leaf(part.refs);
    const std::vector<Part> parts = children_of(part);
    const auto index = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back(empty_node());
    if (part.refs.size() < worth_a_task) {
      for (std::size_t k = 0; k < parts.size(); ++k) {
        const NodeRef child = grow(parts[k], nodes);
        set_child(nodes[index], k, parts[k].extent.box, child);
      }
      return NodeRef::node(index);
    }
    std::array<Nodes, node_width> grown;
    std::array<NodeRef, node_width> roots;
    tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t k) { roots[k] = grow(parts[k], grown[k]); });
    for (std::size_t k = 0; k < parts.size(); ++k) {
      set_child(nodes[index], k, parts[k].extent.box, append(nodes, grown[k], roots[k]));
    }
    return NodeRef::node(index);
  }

  static NodeRef moved(NodeRef r, std::uint32_t by) { return r.is_leaf() ? r : NodeRef::node(r.index() + by); }

  static NodeRef append(Nodes& nodes, const Nodes& grown, NodeRef root) {
    const auto by = static_cast<std::uint32_t>(nodes.size());
    for (WideNode node : grown) {
      for (NodeRef& child : node.child) child = moved(child, by);
      nodes.push_back(node);
    }
    return moved(root, by);
  }

  static WideNode empty_node() {
    WideNode node;
    for (std::size_t i = 0; i < 6; ++i) std::fill_n(node.plane[i], node_width, i < 3 ? beyond : -beyond);
    std::fill_n(node.child, node_width, NodeRef::leaf(0, 1));
    return node;
  }

  static void set_child(WideNode& node, std::size_t k, const FrameBox& box, NodeRef child) {
    for (int i = 0; i < 3; ++i) {
      node.plane[i][k] = box.lo[i];
      node.plane[i + 3][k] = box.hi[i];
    }
    node.child[k] = child;
  }

  NodeRef fill_leaf(Refs refs) {
    const auto first = static_cast<std::uint32_t>(refs.data() - refs_.data());
    const NodeRef leaf = NodeRef::leaf(first, static_cast<std::uint32_t>(refs.size()), refs[0].is_triangle);
    std::sort(refs.begin(), refs.end(), [](const BuildRef& a, const BuildRef& b) { return a.id < b.id; });
    double* column = tree_.columns_.data() + column_count * first;
    for (std::size_t lane = 0; lane < refs.size(); ++lane) {
      const Point3 nowhere(std::numeric_limits<double>::quiet_NaN());
      const Triangle t = primitive_(refs[lane].id).triangle.value_or(Triangle{nowhere, nowhere, nowhere});
      std::size_t k = lane;
      for (const Point3& v : {t.a, t.b, t.c}) {
        for (int i = 0; i < 3; ++i, k += refs.size()) column[k] = v[i];
      }
      column[k] = refs[lane].id;
    }
    return leaf;
  }

  WideTree& tree_;
  const std::function<Primitive(std::uint32_t)>& primitive_;
  std::vector<BuildRef> refs_;
};

WideTree::WideTree(std::uint32_t count, const std::function<Primitive(std::uint32_t)>& primitive) {
  if (count > NodeRef::most_primitives) throw std::length_error("tree: more than 2^27 primitives");
  // The proofs that boxes are rounded outward assume rounding to nearest; tasks in other threads inherit it from the
  // context that is captured here.
  const DefaultRounding in_this_scope;
  in_allowed_threads([&] {
    tbb::task_group_context context(tbb::task_group_context::isolated,
                                    tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
    tbb::task_group all(context);
    all.run_and_wait([&] { WideBuilder(*this, count, primitive).build(); });
  });
}

}  // namespace tribunal
