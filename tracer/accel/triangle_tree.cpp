#include "tracer/accel/triangle_tree.h"

#include <limits>

#include "core/kernel.h"
#include "exact/filtered/filtered.h"
#include "tracer/accel/bvh.h"

namespace tribunal {
namespace {

std::vector<Box> boxes_of(std::span<const Triangle> triangles) {
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const Triangle& t : triangles) boxes.push_back(box_of(t));
  return boxes;
}

bool is_visible(const Answer& a) { return a.hit && a.contact != Contact::coplanar; }

}  // namespace

struct TriangleTree::Parts {
  explicit Parts(std::span<const Triangle> list)
      : triangles(list.begin(), list.end()), tree(Accel::bvh, boxes_of(list), {}) {}

  std::vector<Triangle> triangles;
  BoxTree tree;
};

TriangleTree::TriangleTree(std::span<const Triangle> triangles) : parts_(std::make_unique<const Parts>(triangles)) {}
TriangleTree::TriangleTree(TriangleTree&&) noexcept = default;
TriangleTree& TriangleTree::operator=(TriangleTree&&) noexcept = default;
TriangleTree::~TriangleTree() = default;

std::optional<Nearest> TriangleTree::closest(const Ray& ray) const {
  if (!is_finite(ray)) return std::nullopt;
  const std::vector<Triangle>& triangles = parts_->triangles;
  const BoxProbe probe(ray);
  double limit = std::numeric_limits<double>::infinity();
  std::optional<std::uint32_t> best;
  RayTally tally;
  thread_local BoxTree::Stack stack;
  parts_->tree.traverse(probe, limit, stack, tally, [&](std::uint32_t id) {
    if (!is_visible(intersect(ray, triangles[id]))) return false;
    const Sign order = best ? compare_hits(ray, triangles[id], triangles[*best]) : Sign::negative;
    if (order == Sign::negative || (order == Sign::zero && id < *best)) best = id;
    limit = std::min(limit, probe.span(box_of(triangles[id])).last);
    return false;
  });
  if (!best) return std::nullopt;
  const HitParameter<double> t = hit_parameter<double>(ray, triangles[*best]);
  return Nearest{*best, t.num / t.den};
}

std::size_t TriangleTree::bytes() const { return parts_->triangles.size() * sizeof(Triangle) + parts_->tree.bytes(); }

}  // namespace tribunal
