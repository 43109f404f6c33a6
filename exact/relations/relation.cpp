#include "exact/relations/relation.h"

#include <algorithm>

#include "exact/base/parallel.h"
#include "exact/base/progress.h"
#include "exact/relations/polygon_rows.h"
#include "exact/relations/rows.h"

namespace tribunal {
namespace {

constexpr Relation of_triangles[] = {
    {"vertex-order", "the order of the vertices does not matter", keeps_answer<vertex_order>},
    {"reversal", "the direction of the segment does not matter", keeps_answer<reversal>},
    {"axis-map", "the 48 signed axis permutations change nothing", keeps_answer<axis_map>},
    {"scale", "a power of two on all axes changes nothing", keeps_answer<uniform_scale>},
    {"axis-scale", "a power of two on each axis changes nothing", keeps_answer<axis_scale>},
    {"translation", "an exact translation changes nothing", keeps_answer<translation>},
    {"shear", "an exact integer shear changes nothing", keeps_answer<shear>},
    {"zero-signs", "+0 and -0 are the same number", keeps_answer<zero_signs>},
    {"direction", "a positive multiple of a ray's direction changes nothing", keeps_answer<direction_scale>},
    {"widening", "binary32 operands, written and read as binary64, are the same", keeps_answer<read_as_binary64>},
    {"exchange", "segment (p,q) against (a,b,b) is segment (a,b) against (p,q,q)", segment_as_triangle},
    {"point-exchange", "segment (p,q) against (a,a,a) is segment (a,a) against (p,q,q)", point_as_triangle},
    {"end", "what an end of the segment hits, the segment hits", end_as_segment},
    {"edge", "what hits an edge hits the triangle", edge_as_triangle},
    {"longer", "a longer segment keeps a hit", keeps_hit<longer_segment>},
    {"ray", "the ray through a segment keeps a hit", keeps_hit<ray_of_segment>},
    {"larger", "a larger triangle keeps a hit", keeps_hit<larger_triangle>},
    {"probe-parts", "a segment or ray hits iff one of its two parts does", probe_in_two},
    {"parts", "a triangle is hit iff one of its two parts is", triangle_in_two},
    {"point", "a hit has a point on both operands, of the contact reported", hit_has_point},
    {"plane", "a miss has a plane that separates the operands", miss_has_plane},
    {"bounds-parts", "a ray within bounds hits iff it does within one of their two parts", bounds_in_two},
};

constexpr Relation of_polygons[] = {
    {"start-vertex", "where the rings of a planar polygon start does not matter", keeps_all_if_planar<start_vertex>},
    {"ring-direction", "nor which way they run", keeps_all_if_planar<ring_direction>},
    {"ring-order", "nor which of them is the outer one", keeps_all_if_planar<ring_order>},
    {"repeated-vertex", "a vertex may be repeated", keeps_all<repeated_vertex>},
    {"flat-vertex", "the exact middle of an edge may be a vertex", keeps_hit_and_plane<flat_vertex>},
    {"segment-reversal", "the direction of the segment does not matter", keeps_all<reversed_segment>},
    {"signed-axes", "the 48 signed axis permutations change nothing", keeps_all<signed_axes>},
    {"powers-of-two", "a power of two on each axis changes nothing", keeps_all<powers_of_two>},
};

/// Numbers of the random streams that the relations draw from, one each.
constexpr RandomStreams streams_of_relations(Operands operands) {
  return operands == Operands::triangles ? streams_owned_by("triangle relations")
                                         : streams_owned_by("polygon relations");
}
static_assert(std::size(of_triangles) <= streams_of_relations(Operands::triangles).count);
static_assert(std::size(of_polygons) <= streams_of_relations(Operands::polygons).count);

/// A query of a case, and its exact answer where a method's promise depends on it.
class Asked {
 public:
  Asked(const Query& query, Format format) : query_(query), format_(format) {}

  const Query& query() const { return query_; }
  Format format() const { return format_; }

  /// Whether the method promises an answer to the query. Relations about triangles decide themselves which contracts
  /// they apply to.
  bool is_owed_by(const Method& method) {
    if (!takes(method, format_)) return false;
    if (query_.operands() == Operands::triangles || promises_all_polygons(method.contract)) return true;
    if (!reads_as_sets(method.contract)) return false;
    if (!truth_) truth_ = exact_truth(query_);
    return due(method.contract, *truth_) != Due::nothing;
  }

 private:
  const Query& query_;
  Format format_;
  std::optional<Truth> truth_{};
};

void ask(const Method& method, const Instance& instance, std::uint64_t g, RelationCount& count) {
  if (const std::optional<bool> holds = instance.holds(method)) count.add(*holds, g, instance.queries);
}

/// Checks all relations on a query. The random numbers of a relation are a function of the case and the relation, so
/// every method sees the same queries.
void ask_all(const FuzzPlan& plan, Asked asked, std::uint64_t g, std::vector<RelationCount>& counts) {
  const Operands operands = plan.operands();
  const std::span<const Relation> relations = relations_of(operands);
  for (std::size_t r = 0; r < relations.size(); ++r) {
    Draw draw(static_cast<std::uint32_t>(streams_of_relations(operands).first + r), plan.seed, g);
    const std::optional<Instance> instance = relations[r].of(asked.query(), asked.format(), draw);
    if (!instance) continue;
    for (std::size_t m = 0; m < plan.methods.size(); ++m) {
      if (asked.is_owed_by(plan.methods[m])) ask(plan.methods[m], *instance, g, counts[m * relations.size() + r]);
    }
  }
}

/// The ray from p in the direction of q − p, rounded: so each relation sees rays like the segments of all classes too.
std::optional<Query> as_ray(const Query& query, Format format) {
  const auto* s = std::get_if<Segment>(&query.probe);
  if (s == nullptr || query.operands() != Operands::triangles) return {};
  const Point3 d = in_format(s->q - s->p, format);
  return is_finite(d) ? Query{Ray{s->p, {d}}, query.target} : std::optional<Query>{};
}

void run_case(const FuzzPlan& plan, std::uint64_t g, std::vector<RelationCount>& counts) {
  const Stream& stream = plan.streams[g % plan.streams.size()];
  const Trial trial = stream.family->make(stream.format, plan.seed, g / plan.streams.size());
  ask_all(plan, {trial.query, stream.format}, g, counts);
  if (const auto ray = as_ray(trial.query, stream.format)) ask_all(plan, {*ray, stream.format}, g, counts);
}

}  // namespace

std::span<const Relation> relations_of(Operands operands) {
  if (operands == Operands::triangles) return of_triangles;
  return of_polygons;
}

std::vector<RelationCount> check_relations(const FuzzPlan& plan) {
  const std::uint64_t block_size = block_size_of(plan.operands()) / 4;
  std::vector<RelationCount> counts;
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    for (std::size_t r = 0; r < relations_of(plan.operands()).size(); ++r)
      counts.push_back({.method = m, .relation = r});
  }
  std::vector<std::vector<RelationCount>> workers(plan.threads, counts);
  Progress progress("relations", "cases", plan.cases);
  run_blocks((plan.cases + block_size - 1) / block_size, plan.threads, [&](std::size_t block, unsigned w) {
    const std::uint64_t end = std::min(plan.cases, (block + 1) * block_size);
    for (std::uint64_t g = block * block_size; g < end; ++g) run_case(plan, g, workers[w]);
    progress.add(end - block * block_size);
  });
  for (const std::vector<RelationCount>& worker : workers) {
    for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += worker[i];
  }
  return counts;
}

}  // namespace tribunal
