#include "tracer/accel/bvh.h"

#include <array>
#include <numeric>

namespace tribunal {
namespace {

constexpr std::uint32_t leaf_size = 2;
constexpr int bins = 16;
constexpr int deepest_by_cost = 48;  ///< below this the median halves what is left, so the depth stays bounded

/// Half of the area, up to a factor; +∞ where it overflows, which only makes the tree worse.
double cost_area(const Box& b) {
  const Point3 d = b.hi - b.lo;
  return d.x * d.y + d.y * d.z + d.z * d.x;
}

/// Halved before they are added: the sum of two coordinates may overflow.
double centre(const Box& b, int axis) { return 0.5 * b.lo[axis] + 0.5 * b.hi[axis]; }

struct Bin {
  Box box;
  std::uint32_t count = 0;
};

int bin_of(double x, double lo, double hi) {
  const double part = (0.5 * x - 0.5 * lo) / (0.5 * hi - 0.5 * lo);
  return part > 0 ? std::min(bins - 1, static_cast<int>(part * bins)) : 0;
}

/// The best of the cuts between bins by the surface area heuristic: the number of bins on the left.
int best_cut(const std::array<Bin, bins>& bin) {
  std::array<double, bins> right_cost{};
  Bin right;
  for (int i = bins - 1; i > 0; --i) {
    if (bin[i].count > 0) right.box.add(bin[i].box);
    right.count += bin[i].count;
    right_cost[i] = right.count > 0 ? right.count * cost_area(right.box) : 0;
  }
  Bin left;
  int best = bins / 2;
  double best_cost = std::numeric_limits<double>::infinity();
  for (int i = 1; i < bins; ++i) {
    if (bin[i - 1].count > 0) left.box.add(bin[i - 1].box);
    left.count += bin[i - 1].count;
    const double cost = (left.count > 0 ? left.count * cost_area(left.box) : 0) + right_cost[i];
    if (cost < best_cost) best = i, best_cost = cost;
  }
  return best;
}

}  // namespace

BoxTree::BoxTree(Accel mode, std::vector<Box> boxes, std::span<const std::uint32_t> solid_of)
    : ids_(boxes.size()), boxes_(std::move(boxes)) {
  std::iota(ids_.begin(), ids_.end(), 0u);
  nodes_.push_back({Box(), 0, static_cast<std::uint32_t>(ids_.size()), true});
  if (mode == Accel::boxes) make_solid_boxes(solid_of);
  if (mode == Accel::bvh) split(0, 0);
  boxes_ = {};
}

Box BoxTree::box_of_ids(std::uint32_t first, std::uint32_t count) const {
  Box box;
  for (std::uint32_t i = first; i < first + count; ++i) box.add(boxes_[ids_[i]]);
  return box;
}

void BoxTree::make_solid_boxes(std::span<const std::uint32_t> solid_of) {
  for (std::uint32_t first = 0; first < solid_of.size();) {
    std::uint32_t end = first;
    while (end < solid_of.size() && solid_of[end] == solid_of[first]) ++end;
    nodes_.push_back({box_of_ids(first, end - first), first, end - first, true});
    first = end;
  }
  nodes_[0] = {Box(), 1, static_cast<std::uint32_t>(nodes_.size() - 1), false};
}

/// Splits a leaf in two along the longest extent of the centres, by cost or, where that fails, in the middle.
void BoxTree::split(std::uint32_t index, int level) {
  const std::uint32_t first = nodes_[index].first, count = nodes_[index].count;
  if (count <= leaf_size) return;
  const auto begin = ids_.begin() + first, end = begin + count;
  Box centres;
  for (auto i = begin; i != end; ++i)
    centres.add(Point3(centre(boxes_[*i], 0), centre(boxes_[*i], 1), centre(boxes_[*i], 2)));
  const Point3 extent = 0.5 * centres.hi - 0.5 * centres.lo;
  const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
  const auto bin = [&](std::uint32_t id) {
    return bin_of(centre(boxes_[id], axis), centres.lo[axis], centres.hi[axis]);
  };

  auto middle = begin;
  if (level < deepest_by_cost && extent[axis] > 0) {
    std::array<Bin, bins> filled;
    for (auto i = begin; i != end; ++i) {
      filled[bin(*i)].box.add(boxes_[*i]);
      ++filled[bin(*i)].count;
    }
    const int cut = best_cut(filled);
    middle = std::stable_partition(begin, end, [&](std::uint32_t id) { return bin(id) < cut; });
  }
  if (middle == begin || middle == end) {
    middle = begin + count / 2;
    std::nth_element(begin, middle, end, [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(centre(boxes_[a], axis), a) < std::pair(centre(boxes_[b], axis), b);
    });
  }
  const std::uint32_t left = static_cast<std::uint32_t>(middle - begin);
  const std::uint32_t children = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({box_of_ids(first, left), first, left, true});
  nodes_.push_back({box_of_ids(first + left, count - left), first + left, count - left, true});
  nodes_[index].first = children;
  nodes_[index].count = 2;
  nodes_[index].leaf = false;
  split(children, level + 1);
  split(children + 1, level + 1);
}

}  // namespace tribunal
