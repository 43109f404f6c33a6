#include "tracer/leak/face_boxes.h"

#include <algorithm>
#include <numeric>

#include "core/longest_axis.h"

namespace tribunal::leak {
namespace {

/// The centre of a box on an axis; each bound is halved first, so that the sum does not overflow.
double centre(const Box& b, int axis) { return b.lo[axis] / 2 + b.hi[axis] / 2; }

/// Along which the box is longest; halves are taken first, as for the centre.
int axis_to_split(const Box& b) {
  const Point3 half = b.hi / 2.0 - b.lo / 2.0;
  return static_cast<int>(longest_axis(lift<double>(half)));
}

Box widened(const Box& b, double margin) { return {b.lo - margin, b.hi + margin}; }

}  // namespace

FaceBoxes::FaceBoxes(std::span<const Triangle> triangles, double margin) : order_(triangles.size()) {
  for (const Triangle& t : triangles) boxes_.push_back(widened(box_of(t), margin));
  std::iota(order_.begin(), order_.end(), 0u);
  const auto count = static_cast<std::uint32_t>(triangles.size());
  nodes_.push_back({box_over(0, count), 0, count, 0});
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) split(node);
}

Box FaceBoxes::box_over(std::uint32_t first, std::uint32_t end) const {
  Box box;
  for (std::uint32_t i = first; i < end; ++i) box.add(boxes_[order_[i]]);
  return box;
}

void FaceBoxes::split(std::uint32_t node) {
  const Node whole = nodes_[node];
  if (whole.end - whole.first <= leaf_size) return;
  const int axis = axis_to_split(whole.box);
  const std::uint32_t middle = whole.first + (whole.end - whole.first) / 2;
  std::nth_element(order_.begin() + whole.first, order_.begin() + middle, order_.begin() + whole.end,
                   [&](std::uint32_t a, std::uint32_t b) {
                     const double x = centre(boxes_[a], axis), y = centre(boxes_[b], axis);
                     return x != y ? x < y : a < b;
                   });
  nodes_[node].child = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({box_over(whole.first, middle), whole.first, middle, 0});
  nodes_.push_back({box_over(middle, whole.end), middle, whole.end, 0});
}

void FaceBoxes::candidates(const BoxProbe& probe, std::vector<std::uint32_t>& faces) const {
  faces.clear();
  std::uint32_t waiting[64];  // a median split halves, so that no path has more than 32 nodes
  std::size_t count = 0;
  for (waiting[count++] = 0; count > 0;) {
    const Node& node = nodes_[waiting[--count]];
    if (probe.span(node.box).empty()) continue;
    if (!node.is_leaf()) {
      waiting[count++] = node.child;
      waiting[count++] = node.child + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.end; ++i) {
      if (!probe.span(boxes_[order_[i]]).empty()) faces.push_back(order_[i]);
    }
  }
  std::sort(faces.begin(), faces.end());
}

}  // namespace tribunal::leak
