// Pairs of a segment and a triangle, drawn for a benchmark: as structures and by columns.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/operands.h"
#include "exact/filtered/batch.h"

namespace tribunal::bench {

/// Of a segment, or of a ray: then `segment.q` is its direction.
struct Pair {
  Segment segment;
  Triangle triangle;

  Ray ray() const { return {segment.p, {segment.q}}; }
};

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

/// Five points of the unit cube with 53-bit coordinates, k-th draw.
Pair random_pair(std::uint64_t k);

/// Random pairs of which this percentage hits. The paper counted 7 % in its scenes.
std::vector<Pair> random_pairs(std::size_t n, int percent_hits);

/// The same with rays, from the first point of a random pair towards the second.
std::vector<Pair> random_rays(std::size_t n, int percent_hits);

/// One segment, repeated, with random triangles of which 7 % meet it.
std::vector<Pair> one_segment_pairs(std::size_t n);

/// Affine images of the classes with five affinely dependent points among them: exactly degenerate pairs, each operand
/// regular, as CGAL asks. The map's entries have `bits` bits; 50 fills the mantissas.
std::vector<Pair> degenerate_pairs(std::size_t n, int bits);

/// Degenerate pairs with one vertex moved by some units in the last place.
std::vector<Pair> near_pairs(std::size_t n);

/// Random pairs (7 % hits), with a share of full-mantissa degenerate ones dealt among them.
std::vector<Pair> mixed_pairs(std::size_t n, int percent_degenerate);

}  // namespace tribunal::bench
