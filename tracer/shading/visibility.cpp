#include "tracer/shading/visibility.h"

#include <limits>

namespace tribunal {

bool Visibility::is_nearer(const Ray& ray, std::uint32_t id, std::uint32_t best) const {
  const Triangle& s = world_.triangles[id];
  const Triangle& t = world_.triangles[best];
  const Sign order = method_.compare_hits ? method_.compare_hits(ray, s, t)
                                          : sign_of(shading_parameter(ray, s) - shading_parameter(ray, t));
  return order == Sign::negative || (order == Sign::zero && id < best);
}

std::optional<std::uint32_t> Visibility::first_hit(const Ray& ray) {
  if (!is_finite(ray)) return std::nullopt;
  const BoxProbe probe(ray);
  double limit = std::numeric_limits<double>::infinity();
  std::optional<std::uint32_t> best;
  world_.tree.traverse(probe, limit, stack_, tally_, [&](std::uint32_t id) {
    const Triangle& t = world_.triangles[id];
    ++tally_.triangle_tests;
    if (!is_visible_hit(method_.ray(ray, t))) return false;
    ++tally_.triangle_hits;
    if (!best || is_nearer(ray, id, *best)) best = id;
    const Span span = probe.span(box_of(t));
    if (!span.empty()) limit = std::min(limit, span.last);
    return false;
  });
  return best;
}

bool Visibility::is_blocked(const Segment& way) {
  if (!is_finite(way)) return false;
  const double limit = 1;
  bool blocked = false;
  world_.tree.traverse(BoxProbe(way), limit, stack_, tally_, [&](std::uint32_t id) {
    ++tally_.triangle_tests;
    blocked = is_blocking_hit(method_.segment(way, world_.triangles[id]));
    tally_.triangle_hits += blocked;
    return blocked;
  });
  return blocked;
}

bool sees(const Method& method, const Probe& probe, const Triangle& t) {
  if (const Ray* ray = std::get_if<Ray>(&probe)) return is_visible_hit(method.ray(*ray, t));
  return is_blocking_hit(method.segment(std::get<Segment>(probe), t));
}

std::vector<std::uint32_t> candidates(const World& world, const Probe& probe) {
  const BoxProbe boxes = std::visit([](const auto& p) { return BoxProbe(p); }, probe);
  const double limit = std::numeric_limits<double>::infinity();
  BoxTree::Stack stack;
  Tally uncounted;
  std::vector<std::uint32_t> ids;
  world.tree.traverse(boxes, limit, stack, uncounted, [&](std::uint32_t id) {
    ids.push_back(id);
    return false;
  });
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace tribunal
