// The pairs of a benchmark, as structures and by columns.
#pragma once

#include <array>
#include <vector>

#include "exact/chart/pairs.h"
#include "exact/filtered/batch.h"

namespace tribunal::bench {

using Pair = SegmentPair;

/// The same pairs twice: `pairs`, and the columns of source, target, a, b, c.
class PairTable {
 public:
  explicit PairTable(std::vector<Pair> pairs);

  const std::vector<Pair>& pairs() const { return pairs_; }
  std::size_t size() const { return pairs_.size(); }
  SegmentColumns segments() const { return {points(0), points(1)}; }
  RayColumns rays() const { return {points(0), points(1)}; }
  TriangleColumns triangles() const { return {points(2), points(3), points(4)}; }
  std::array<const double*, 15> columns() const;

 private:
  PointColumns points(std::size_t vertex) const {
    return {columns_[3 * vertex], columns_[3 * vertex + 1], columns_[3 * vertex + 2]};
  }

  std::vector<Pair> pairs_;
  std::array<std::vector<double>, 15> columns_;
};

}  // namespace tribunal::bench
