#include "tracer/shading/visibility.h"

#include <limits>
#include <type_traits>

namespace tribunal {

Visibility::Visibility(const World& world, const Method& method, RayTally& tally)
    : world_(world), method_(method), tally_(tally) {
  for (const PolygonData& polygon : world.polygons) prepared_.push_back(method.polygon(polygon));
}

template <class P>
Answer Visibility::ask(const P& probe, std::uint32_t id) const {
  constexpr bool is_ray = std::is_same_v<P, Ray>;
  if (world_.polygon_of[id] >= 0) {
    const PreparedPolygon& polygon = prepared_[static_cast<std::size_t>(world_.polygon_of[id])];
    if constexpr (is_ray) return polygon.ray(probe).answer;
    if constexpr (!is_ray) return polygon.segment(probe).answer;
  }
  if constexpr (is_ray) return method_.ray(probe, world_.triangles[id]);
  if constexpr (!is_ray) return method_.segment(probe, world_.triangles[id]);
}

template <class P>
Answer Visibility::ask_counted(const P& probe, std::uint32_t id) {
  const Answer answer = ask(probe, id);
  constexpr bool is_ray = std::is_same_v<P, Ray>;
  const bool hit = is_ray ? is_visible_hit(answer) : is_blocking_hit(answer);
  const bool polygon = world_.polygon_of[id] >= 0;
  ++(polygon ? tally_.polygon_tests : tally_.triangle_tests);
  (polygon ? tally_.polygon_hits : tally_.triangle_hits) += hit;
  ++tally_.by_stage[static_cast<std::size_t>(answer.stage)];
  return answer;
}

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
    if (!is_visible_hit(ask_counted(ray, id))) return false;
    if (!best || is_nearer(ray, id, *best)) best = id;
    const Span span = probe.span(world_.box(id));
    if (!span.empty()) limit = std::min(limit, span.last);
    return false;
  });
  return best;
}

bool Visibility::is_blocked(const Segment& way) {
  if (!is_finite(way)) return false;
  const double limit = 1;
  bool blocked = false;
  world_.tree.traverse(BoxProbe(way), limit, stack_, tally_,
                       [&](std::uint32_t id) { return blocked = is_blocking_hit(ask_counted(way, id)); });
  return blocked;
}

Visibility::Met Visibility::faces_met(const Segment& way, std::uint32_t the_one) {
  if (!is_finite(way)) return Met::more;
  const double limit = 1;
  RayTally uncounted;
  bool met_the_one = false, met_another = false;
  world_.tree.traverse(BoxProbe(way), limit, stack_, uncounted, [&](std::uint32_t id) {
    ++tally_.start_tests;
    if (!is_visible_hit(ask(way, id))) return false;
    (id == the_one ? met_the_one : met_another) = true;
    return met_another;
  });
  return met_another ? Met::more : met_the_one ? Met::only_the_one : Met::none;
}

bool Visibility::sees(const Probe& probe, std::uint32_t id) const {
  if (const Ray* ray = std::get_if<Ray>(&probe)) return is_visible_hit(ask(*ray, id));
  return is_blocking_hit(ask(std::get<Segment>(probe), id));
}

std::vector<std::uint32_t> candidates(const World& world, const Probe& probe) {
  const BoxProbe boxes = std::visit([](const auto& p) { return BoxProbe(p); }, probe);
  const double limit = std::numeric_limits<double>::infinity();
  BoxTree::Stack stack;
  RayTally uncounted;
  std::vector<std::uint32_t> ids;
  world.tree.traverse(boxes, limit, stack, uncounted, [&](std::uint32_t id) {
    ids.push_back(id);
    return false;
  });
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace tribunal
