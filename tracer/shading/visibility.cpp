#include "tracer/shading/visibility.h"

#include <limits>
#include <type_traits>

#include "core/capability.h"
#include "exact/filtered/filtered.h"
#include "tracer/accel/wide/queries.h"

namespace tribunal {

namespace {

void put(ProbePacket& packet, std::size_t lane, const RayQuestion& q) {
  packet.set(lane, q.ray.o, q.ray.d.v, q.excluded, no_face);
}

void put(ProbePacket& packet, std::size_t lane, const SegmentQuestion& q) {
  packet.set(lane, q.way.p, q.way.q, q.excluded[0], q.excluded[1]);
}

Cost cost_of(const PacketAnswer& a, std::size_t lane) {
  const auto tests = static_cast<std::uint64_t>(a.tests[lane]);
  return {tests, tests > 0 ? Stage::filter : Stage::none};
}

}  // namespace

Visibility::Visibility(const World& world, const Method& method, RayTally& tally)
    : world_(world), method_(method), filters_(has(method, Capability::tree_lanes)), tally_(tally) {
  for (const PolygonData& polygon : world.polygons) {
    if (filters_) {
      filtered_.emplace_back(polygon);
      figures_.push_back(filtered_.back().figures());
    } else {
      prepared_.push_back(method.polygon(polygon));
    }
  }
}

template <class P>
Answer Visibility::ask(const P& probe, std::uint32_t id) const {
  constexpr bool is_ray = std::is_same_v<P, Ray>;
  if (world_.polygon_of[id] >= 0) {
    const auto number = static_cast<std::size_t>(world_.polygon_of[id]);
    if (filters_) return filtered_[number].meet(probe);
    const PreparedPolygon& polygon = prepared_[number];
    if constexpr (is_ray) return polygon.ray(probe);
    if constexpr (!is_ray) return polygon.segment(probe);
  }
  if constexpr (is_ray) return method_.ray(probe, world_.triangles[id]);
  if constexpr (!is_ray) return method_.segment(probe, world_.triangles[id]);
}

template <class P>
Answer Visibility::ask_counted(const P& probe, std::uint32_t id, std::uint32_t excluded) {
  const Answer answer = id == excluded ? certain(false) : ask(probe, id);
  constexpr bool is_ray = std::is_same_v<P, Ray>;
  const bool hit = is_ray ? is_visible_hit(answer) : is_blocking_hit(answer);
  const bool polygon = world_.polygon_of[id] >= 0;
  ++(polygon ? tally_.polygon_tests : tally_.triangle_tests);
  (polygon ? tally_.polygon_hits : tally_.triangle_hits) += hit;
  ++tally_.by_stage[static_cast<std::size_t>(answer.stage)];
  return answer;
}

/// Counts tests of triangles that the filter decided on the vector lanes.
void Visibility::count_certain(std::uint64_t tests, std::uint64_t hits) {
  tally_.triangle_tests += tests;
  tally_.triangle_hits += hits;
  tally_.by_stage[static_cast<std::size_t>(Stage::filter)] += tests;
}

/// The order of two hits by the method: the sign of the t of `id` minus the t of `other`.
Sign Visibility::order(const Ray& ray, std::uint32_t id, std::uint32_t other) const {
  const Triangle s = world_.triangles[id], t = world_.triangles[other];
  return method_.compare_hits ? method_.compare_hits(ray, s, t) : sign_of(parameter(ray, s) - parameter(ray, t));
}

/// The parameter of a hit by the method, if it computes one; else shading_parameter.
double Visibility::parameter(const Ray& ray, const Triangle& t) const {
  const std::optional<double> own = method_.parameter ? method_.parameter(ray, t) : std::nullopt;
  return own ? *own : shading_parameter(ray, t);
}

/// Answers all queries: in packets of eight if the method's filter runs on vector lanes, and one by one where the
/// packet is not certain. together(packet, questions) answers some and returns their lanes; alone(question) answers
/// one.
template <class Question, class Together, class Alone>
void Visibility::answer(std::span<Question> questions, const Together& together, const Alone& alone) {
  const auto ask_alone = [&](Question& q) {
    const RayTally before = tally_;
    alone(q);
    q.cost += cost_between(before, tally_);
  };
  if (!filters_ || world_.triangles.tree() == nullptr || questions.size() < 2) {
    for (Question& q : questions) ask_alone(q);
    return;
  }
  for (std::size_t from = 0; from < questions.size(); from += packet_size) {
    const std::span<Question> some = questions.subspan(from, std::min(packet_size, questions.size() - from));
    ProbePacket packet;
    for (std::size_t lane = 0; lane < some.size(); ++lane) put(packet, lane, some[lane]);
    const unsigned known = together(packet, some);
    for (std::size_t lane = 0; lane < some.size(); ++lane) {
      if ((known >> lane & 1) == 0) ask_alone(some[lane]);
    }
  }
}

/// Adds the counts of a packet to the tally.
void Visibility::count_packet(const PacketAnswer& a) {
  tally_.box_tests += a.boxes;
  tally_.triangle_tests += a.triangle_tests;
  tally_.triangle_hits += a.triangle_hits;
  tally_.polygon_tests += a.polygon_tests;
  tally_.polygon_hits += a.polygon_hits;
  tally_.by_stage[static_cast<std::size_t>(Stage::filter)] += a.triangle_tests + a.polygon_tests;
}

PacketFaces Visibility::packet_faces() const { return {*world_.triangles.tree(), world_.polygon_of, figures_}; }

void Visibility::first_hits(std::span<RayQuestion> questions) {
  const auto together = [&](const ProbePacket& packet, std::span<RayQuestion> some) {
    PacketAnswer a;
    packet_target().first_hits(packet_faces(), packet, a);
    count_packet(a);
    for (std::size_t lane = 0; lane < some.size(); ++lane) {
      some[lane].cost += cost_of(a, lane);
      if ((a.known & a.hit) >> lane & 1) some[lane].face = static_cast<std::uint32_t>(a.id[lane]);
    }
    return a.known;
  };
  answer(questions, together, [&](RayQuestion& q) { q.face = first_hit(q.ray, q.excluded); });
}

template <bool starts, class Alone>
void Visibility::any_met(std::span<SegmentQuestion> questions, const Alone& alone) {
  const auto together = [&](const ProbePacket& packet, std::span<SegmentQuestion> some) {
    PacketAnswer a;
    packet_target().any_hits(packet_faces(), packet, a);
    if (starts) tally_.start_tests += a.triangle_tests + a.polygon_tests;
    if (!starts) count_packet(a);
    for (std::size_t lane = 0; lane < some.size(); ++lane) {
      const Cost cost = cost_of(a, lane);
      some[lane].cost += starts ? Cost{cost.tests, Stage::none} : cost;
      some[lane].met = ((a.known & a.hit) >> lane & 1) != 0;
    }
    return a.known;
  };
  answer(questions, together, alone);
}

void Visibility::blocked(std::span<SegmentQuestion> questions) {
  any_met<false>(questions, [&](SegmentQuestion& q) { q.met = is_blocked(q.way, q.excluded[0]); });
}

void Visibility::met(std::span<SegmentQuestion> questions) {
  any_met<true>(questions, [&](SegmentQuestion& q) { q.met = meets_any(q.way, q.excluded); });
}

std::optional<std::uint32_t> Visibility::first_hit(const Ray& ray, std::uint32_t excluded) {
  if (!is_finite(ray)) return std::nullopt;
  return world_.triangles.tree() != nullptr ? first_in_tree(ray, excluded) : first_in_list(ray, excluded);
}

std::optional<std::uint32_t> Visibility::first_in_list(const Ray& ray, std::uint32_t excluded) {
  const BoxProbe probe(ray);
  double limit = std::numeric_limits<double>::infinity();
  std::optional<std::uint32_t> best;
  world_.triangles.visit(probe, limit, waiting_, tally_, [&](std::uint32_t id) {
    if (!is_visible_hit(ask_counted(ray, id, excluded))) return false;
    const Sign sign = best ? order(ray, id, *best) : Sign::negative;
    if (sign == Sign::negative || (sign == Sign::zero && id < *best)) best = id;
    const Span span = probe.span(world_.box(id));
    if (!span.empty()) limit = std::min(limit, span.last);
    return false;
  });
  return best;
}

/// Whether the method is to test a candidate. Always, if the method filters, since its test costs as little as a box
/// test. Else only if the probe enters the face's own box at t ≤ limit, since the box of the leaf holds up to eight
/// faces.
template <class P>
bool Visibility::is_worth_asking(const P& probe, double limit, std::uint32_t id, RayTally& tally) const {
  if (filters_) return true;
  ++tally.box_tests;
  const Span span = BoxProbe(probe).span(world_.box(id));
  return !span.empty() && span.first <= limit;
}

/// The judge of ClosestQuery: the method itself.
struct Visibility::Judge {
  Visibility& eye;
  const Ray& ray;
  std::uint32_t excluded;

  bool sees(Place, std::uint32_t id, double limit) const {
    return eye.is_worth_asking(ray, limit, id, eye.tally_) && is_visible_hit(eye.ask_counted(ray, id, excluded));
  }
  Span span(Place, std::uint32_t id) const { return BoxProbe(ray).span(eye.world_.box(id)); }
  Triangle plane(Place, std::uint32_t id) const { return eye.world_.triangles[id]; }
  bool is_exact() const { return eye.filters_; }
  Sign order(const BoundedHit& a, const BoundedHit& b) const { return eye.order(ray, a.id, b.id); }
};

std::optional<std::uint32_t> Visibility::first_in_tree(const Ray& ray, std::uint32_t excluded) {
  const WideTree& tree = *world_.triangles.tree();
  const WideProbe probe(ray, tree.frame());
  Judge judge{*this, ray, excluded};
  ClosestQuery query(tree, probe, judge);
  WalkCounts counts;
  if (filters_) {
    tree_target().filter_ray(tree, probe, ray, query, counts);
  } else {
    tree_target().visit_all(tree, probe, query, counts);
  }
  tally_.box_tests += counts.boxes;
  count_certain(counts.missed + query.certain(), query.certain());
  if (!query.best()) return std::nullopt;
  return query.best()->id;
}

namespace {

/// The judge of AnyQuery that passes ids on: certain hits to `hit`, uncertain candidates to `other`.
template <class Hit, class Other>
struct PassOn {
  const Hit& hit;
  const Other& other;

  bool accepts(std::uint32_t id) const { return hit(id); }
  bool sees(Place, std::uint32_t id, double) const { return other(id); }
};

}  // namespace

template <class Hit, class Other>
std::uint64_t Visibility::along(const Segment& way, RayTally& tally, const Hit& hit, const Other& other) {
  const WideTree* const tree = world_.triangles.tree();
  if (tree == nullptr) {
    const double end = 1;
    world_.triangles.visit(BoxProbe(way), end, waiting_, tally, other);
    return 0;
  }
  const WideProbe probe(way, tree->frame());
  const auto ask = [&](std::uint32_t id) { return is_worth_asking(way, 1, id, tally) && other(id); };
  const PassOn judge{hit, ask};
  AnyQuery query(*tree, judge);
  query.limit = probe.limit_at(1);
  WalkCounts counts;
  if (filters_) {
    tree_target().filter_segment(*tree, probe, way, query, counts);
  } else {
    tree_target().visit_all(*tree, probe, query, counts);
  }
  tally.box_tests += counts.boxes;
  return counts.missed;
}

bool Visibility::is_blocked(const Segment& way, std::uint32_t excluded) {
  if (!is_finite(way)) return false;
  bool blocked = false, certainly = false;
  const std::uint64_t missed = along(
      way, tally_, [&](std::uint32_t) { return blocked = certainly = true; },
      [&](std::uint32_t id) { return blocked = is_blocking_hit(ask_counted(way, id, excluded)); });
  count_certain(missed + certainly, certainly);
  return blocked;
}

bool Visibility::meets_any(const Segment& way, std::array<std::uint32_t, 2> excluded) {
  if (!is_finite(way)) return true;
  RayTally uncounted;
  bool met = false;
  std::uint64_t tests = 0;
  const auto matters = [&](std::uint32_t id) { return ++tests, id != excluded[0] && id != excluded[1]; };
  const std::uint64_t missed = along(
      way, uncounted, [&](std::uint32_t id) { return met = matters(id); },
      [&](std::uint32_t id) { return met = matters(id) && is_visible_hit(ask(way, id)); });
  tally_.start_tests += tests + missed;
  return met;
}

bool Visibility::passes_through(const Segment& way, std::uint32_t id) {
  ++tally_.start_tests;
  if (!is_finite(way)) return false;
  if (filters_ && world_.polygon_of[id] >= 0) {
    const FilteredPolygon& polygon = filtered_[static_cast<std::size_t>(world_.polygon_of[id])];
    if (const std::optional<bool> certain = polygon.filter_between(way)) return *certain;
  }
  return is_visible_hit(ask(way, id));
}

bool Visibility::sees(const Probe& probe, std::uint32_t id) const {
  return is_hit_in_picture(probe, std::visit([&](const auto& p) { return ask(p, id); }, probe));
}

std::vector<std::uint32_t> candidates(const World& world, const Probe& probe) {
  std::vector<std::uint32_t> ids;
  const auto add = [&](std::uint32_t id) {
    ids.push_back(id);
    return false;
  };
  if (const WideTree* tree = world.triangles.tree()) {
    const WideProbe boxes = std::visit([&](const auto& p) { return WideProbe(p, tree->frame()); }, probe);
    const PassOn judge{add, add};
    AnyQuery query(*tree, judge);
    WalkCounts uncounted;
    tree_target().visit_all(*tree, boxes, query, uncounted);
  } else {
    const BoxProbe boxes = std::visit([](const auto& p) { return BoxProbe(p); }, probe);
    const double limit = std::numeric_limits<double>::infinity();
    BoxedFaces::Waiting waiting;
    RayTally uncounted;
    world.triangles.visit(boxes, limit, waiting, uncounted, add);
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

}  // namespace tribunal
