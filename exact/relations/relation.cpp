#include "exact/relations/relation.h"

#include "exact/relations/rows.h"

namespace tribunal {
namespace {

constexpr Relation relations[] = {
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
};

void ask(const Method& method, const Instance& instance, std::uint64_t g, RelationCount& count) {
  if (const std::optional<bool> holds = instance.holds(method)) count.add(*holds, g, instance.queries);
}

void ask_all(const FuzzPlan& plan, const Query& query, Format format, std::uint64_t g,
             std::vector<RelationCount>& counts) {
  for (std::size_t r = 0; r < std::size(relations); ++r) {
    Draw draw(static_cast<std::uint32_t>(1000 + r), plan.seed, g);
    const std::optional<Instance> instance = relations[r].of(query, format, draw);
    if (!instance) continue;
    for (std::size_t m = 0; m < plan.methods.size(); ++m) {
      if (takes(plan.methods[m], format)) ask(plan.methods[m], *instance, g, counts[m * std::size(relations) + r]);
    }
  }
}

/// The ray from p in the direction of q − p, as that rounds: so each relation sees rays of the classes of segments too.
std::optional<Query> as_ray(const Query& query, Format format) {
  const auto* s = std::get_if<Segment>(&query.probe);
  if (s == nullptr) return {};
  const Point3 d = in_format(s->q - s->p, format);
  return is_finite(d) ? Query{Ray{s->p, {d}}, query.triangle} : std::optional<Query>{};
}

/// The draw of a relation is a function of the case and the relation, so every method sees the same queries.
void run_case(const FuzzPlan& plan, std::uint64_t g, std::vector<RelationCount>& counts) {
  const Stream& stream = plan.streams[g % plan.streams.size()];
  const Trial trial = stream.family->make(stream.format, plan.seed, g / plan.streams.size());
  ask_all(plan, trial.query, stream.format, g, counts);
  if (const auto ray = as_ray(trial.query, stream.format)) ask_all(plan, *ray, stream.format, g, counts);
}

}  // namespace

std::span<const Relation> all_relations() { return relations; }

std::vector<RelationCount> check_relations(const FuzzPlan& plan) {
  return count_relations(plan, std::size(relations),
                         [&](std::uint64_t g, std::vector<RelationCount>& counts) { run_case(plan, g, counts); });
}

}  // namespace tribunal
