// Which faces of a mesh a probe may meet, or a rounded test may take it to meet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tracer/accel/wide/box.h"

namespace tribunal::leak {

/// A binary tree of boxes over triangles. It knows nothing of triangle tests, so that a wrong test can err on every
/// face that a tracer would hand it.
class FaceBoxes {
 public:
  FaceBoxes() = default;
  /// Each box is wider than its triangle by `margin` on every side.
  FaceBoxes(std::span<const Triangle> triangles, double margin);

  /// The faces whose boxes the probe may meet, in ascending order. Law: no face that it exactly meets is missing
  /// (tracer/accel/wide/box.h has the proof).
  void candidates(const BoxProbe& probe, std::vector<std::uint32_t>& faces) const;

 private:
  static constexpr std::uint32_t leaf_size = 4;

  /// A leaf has the faces order_[first] to order_[end − 1]; another node has its children at `child` and `child` + 1.
  struct Node {
    Box box;
    std::uint32_t first, end, child;
    bool is_leaf() const { return child == 0; }
  };

  Box box_over(std::uint32_t first, std::uint32_t end) const;
  void split(std::uint32_t node);

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace tribunal::leak
