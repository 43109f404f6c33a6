// The tree's questions besides the closest hit, each one walk and one query.
#include <stdexcept>

#include "exact/filtered/stages/default_rounding.h"
#include "tracer/accel/certified.h"
#include "tracer/accel/lanes_at_work.h"
#include "tracer/accel/triangle_tree.h"
#include "tracer/accel/wide/queries.h"

namespace tribunal {
namespace {

WideProbe with_limit(const WideTree& tree, const Ray& ray, CandidateQuery&) { return WideProbe(ray, tree.frame()); }

WideProbe with_limit(const WideTree& tree, const Segment& way, CandidateQuery& query) {
  const WideProbe probe(way, tree.frame());
  query.limit = probe.limit_at(1);
  return probe;
}

void walk(const WideTree& tree, const Ray& ray, CandidateQuery& query) {
  WalkCounts uncounted;
  tree_target().filter_ray(tree, with_limit(tree, ray, query), ray, query, uncounted);
}

void walk(const WideTree& tree, const Segment& way, CandidateQuery& query) {
  WalkCounts uncounted;
  tree_target().filter_segment(tree, with_limit(tree, way, query), way, query, uncounted);
}

template <class P>
bool any_alone(const WideTree& tree, const P& probe) {
  if (!is_finite(probe)) return false;
  Certified<P> judge{tree, probe};
  AnyQuery query(tree, judge);
  walk(tree, probe, query);
  return query.met();
}

std::vector<Nearest> all_alone(const WideTree& tree, const Ray& ray) {
  std::vector<Nearest> hits;
  if (!is_finite(ray)) return hits;
  CertifiedRay judge(tree, ray);
  AllQuery query(tree, judge);
  walk(tree, ray, query);
  for (const BoundedHit& hit : query.in_order()) hits.push_back(judge.handed_out(hit));
  return hits;
}

/// A ray without direction is a point, which crosses nothing: it gets the direction x, along which its perturbation
/// begins.
Ray with_direction(const Ray& ray) { return ray.d.v == Point3(0) ? Ray{ray.o, {{1, 0, 0}}} : ray; }

Parity parity_alone(const WideTree& tree, const Ray& ray) {
  if (!is_finite(ray)) return {};
  const Ray directed = with_direction(ray);
  CrossingQuery query(tree, directed);
  walk(tree, directed, query);
  if (query.on_surface()) return {true, 0, 0};
  return {false, query.count(), query.winding()};
}

/// The direction of the ray that decides whether a point is inside. Any would do; this one is parallel to no axis,
/// diagonal or plane of a lattice, so that the filter rarely fails, and about as long as the tree is large.
Direction askew(const WideTree& tree) { return {Point3(0.59384619, 0.46157913, 0.65904237) / tree.frame().unit}; }

Side side_alone(const WideTree& tree, const Point3& p) {
  const Parity c = parity_alone(tree, {p, askew(tree)});
  if (c.on_surface) return Side::boundary;
  return c.crossings % 2 == 1 ? Side::inside : Side::outside;
}

/// answers[i] = ask(questions[i]).
template <class Question, class Answer, class Ask>
void one_by_one(std::span<const Question> questions, std::span<Answer> answers, const Ask& ask) {
  if (questions.size() != answers.size()) throw std::invalid_argument("as many answers as questions are needed");
  const DefaultRounding in_this_scope;
  for (std::size_t i = 0; i < questions.size(); ++i) answers[i] = ask(questions[i]);
}

/// Answers eight segments at a time; where the packet is not certain of a lane, its segment walks on its own.
LanesAtWork any_together(const WideTree& tree, std::span<const Segment> some, std::uint8_t* met) {
  ProbePacket packet;
  for (std::size_t lane = 0; lane < some.size(); ++lane) packet.set(lane, some[lane].p, some[lane].q);
  PacketAnswer a;
  packet_target().any_hits({tree, {}, {}}, packet, a);
  for (std::size_t lane = 0; lane < some.size(); ++lane) {
    const bool known = (a.known >> lane & 1) != 0, hit = (a.hit >> lane & 1) != 0;
    met[lane] = known ? hit : any_alone(tree, some[lane]);
  }
  return LanesAtWork(a);
}

constexpr std::size_t first_alone = 56;  ///< segments after a packet of such as are not alike

}  // namespace

bool TriangleTree::any(const Ray& ray) const {
  const DefaultRounding in_this_scope;
  return any_alone(*tree_, ray);
}

bool TriangleTree::any(const Segment& way) const {
  const DefaultRounding in_this_scope;
  return any_alone(*tree_, way);
}

void TriangleTree::any(std::span<const Ray> rays, std::span<std::uint8_t> met) const {
  one_by_one(rays, met, [&](const Ray& r) { return any_alone(*tree_, r); });
}

void TriangleTree::any(std::span<const Segment> ways, std::span<std::uint8_t> met) const {
  if (ways.size() != met.size()) throw std::invalid_argument("as many answers as questions are needed");
  const DefaultRounding in_this_scope;
  LanesAtWork of_late;
  for (std::size_t from = 0, alone = first_alone; from < ways.size();) {
    const std::span<const Segment> some = ways.subspan(from, std::min(packet_size, ways.size() - from));
    of_late += any_together(*tree_, some, met.data() + from);
    from += some.size();
    const bool alike = of_late.share() > LanesAtWork::alike;
    const std::size_t end = alike ? from : std::min(from + alone, ways.size());
    for (; from < end; ++from) met[from] = any_alone(*tree_, ways[from]);
    alone = alike ? first_alone : 4 * alone;
    of_late.forget_some();
  }
}

std::vector<Nearest> TriangleTree::all(const Ray& ray) const {
  const DefaultRounding in_this_scope;
  return all_alone(*tree_, ray);
}

void TriangleTree::all(std::span<const Ray> rays, std::span<std::vector<Nearest>> hits) const {
  one_by_one(rays, hits, [&](const Ray& r) { return all_alone(*tree_, r); });
}

Parity TriangleTree::parity(const Ray& ray) const {
  const DefaultRounding in_this_scope;
  return parity_alone(*tree_, ray);
}

void TriangleTree::parity(std::span<const Ray> rays, std::span<Parity> counts) const {
  one_by_one(rays, counts, [&](const Ray& r) { return parity_alone(*tree_, r); });
}

Side TriangleTree::inside(const Point3& p) const {
  const DefaultRounding in_this_scope;
  return side_alone(*tree_, p);
}

void TriangleTree::inside(std::span<const Point3> points, std::span<Side> sides) const {
  one_by_one(points, sides, [&](const Point3& p) { return side_alone(*tree_, p); });
}

}  // namespace tribunal
