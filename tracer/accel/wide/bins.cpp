#include "tracer/accel/wide/bins.h"

#include "tracer/accel/wide/tree.h"

namespace tribunal {
namespace {

/// The cost of one side of a cut: its area times the number of leaves that it fills, since testing eight triangles
/// costs as much as one.
float cost(const FrameBox& box, std::uint32_t count) {
  return box.area() * static_cast<float>((count + leaf_size - 1) / leaf_size);
}

}  // namespace

void Bins::add(std::span<const BuildRef> refs, const Binning& binning) {
  for (const BuildRef& r : refs) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis), b = static_cast<std::size_t>(binning.bin(r, axis));
      box[a][b].add(r.box);
      ++count[a][b];
    }
  }
}

void Bins::add(const Bins& other) {
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < bin_count; ++b) {
      box[a][b].add(other.box[a][b]);
      count[a][b] += other.count[a][b];
    }
  }
}

Cut Bins::best(const Binning& binning) const {
  Cut cut;
  float least_cost = std::numeric_limits<float>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (!binning.splits(axis)) continue;
    const auto a = static_cast<std::size_t>(axis);
    std::array<float, bin_count> right_cost{};
    FrameBox right;
    std::uint32_t right_count = 0;
    for (std::size_t b = bin_count - 1; b > 0; --b) {
      right.add(box[a][b]);
      right_cost[b] = cost(right, right_count += count[a][b]);
    }
    FrameBox left;
    std::uint32_t left_count = 0;
    for (std::size_t b = 1; b < bin_count; ++b) {
      left.add(box[a][b - 1]);
      const float sum = cost(left, left_count += count[a][b - 1]) + right_cost[b];
      if (sum < least_cost) least_cost = sum, cut = {axis, static_cast<int>(b)};
    }
  }
  return cut;
}

}  // namespace tribunal
