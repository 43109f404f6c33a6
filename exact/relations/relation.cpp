#include "exact/relations/relation.h"

#include <algorithm>

#include "exact/harness/parallel.h"
#include "exact/harness/progress.h"
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

struct Witness {
  std::uint64_t g = ~std::uint64_t{0};
  std::vector<Query> queries{};
};

struct Entry {
  std::uint64_t asked = 0, broken = 0;
  Witness first{};
};

void ask(const Method& method, const Instance& instance, std::uint64_t g, Entry& entry) {
  const std::optional<bool> holds = instance.holds(method);
  if (!holds) return;
  ++entry.asked;
  if (*holds) return;
  ++entry.broken;
  if (g < entry.first.g) entry.first = {g, instance.queries};
}

void ask_all(const FuzzPlan& plan, const Query& query, Format format, std::uint64_t g, std::vector<Entry>& entries) {
  for (std::size_t r = 0; r < std::size(relations); ++r) {
    Draw draw(static_cast<std::uint32_t>(1000 + r), plan.seed, g);
    const std::optional<Instance> instance = relations[r].of(query, format, draw);
    if (!instance) continue;
    for (std::size_t m = 0; m < plan.methods.size(); ++m) {
      if (takes(plan.methods[m], format)) ask(plan.methods[m], *instance, g, entries[m * std::size(relations) + r]);
    }
  }
}

/// The ray from p in the direction of q − p, as that rounds: rays have no families of their own.
std::optional<Query> as_ray(const Query& query, Format format) {
  const auto* s = std::get_if<Segment>(&query.probe);
  if (s == nullptr) return {};
  const Point3 d = in_format(s->q - s->p, format);
  return is_finite(d) ? Query{Ray{s->p, {d}}, query.triangle} : std::optional<Query>{};
}

/// The draw of a relation is a function of the case and the relation, so every method sees the same queries.
void run_case(const FuzzPlan& plan, std::uint64_t g, std::vector<Entry>& entries) {
  const Stream& stream = plan.streams[g % plan.streams.size()];
  const Trial trial = stream.family->make(stream.format, plan.seed, g / plan.streams.size());
  ask_all(plan, trial.query, stream.format, g, entries);
  if (const auto ray = as_ray(trial.query, stream.format)) ask_all(plan, *ray, stream.format, g, entries);
}

void merge(Entry& into, const Entry& from) {
  into.asked += from.asked;
  into.broken += from.broken;
  if (from.first.g < into.first.g) into.first = from.first;
}

}  // namespace

std::span<const Relation> all_relations() { return relations; }

std::vector<RelationCount> check_relations(const FuzzPlan& plan) {
  constexpr std::uint64_t block_size = 512;
  const std::size_t entries = plan.methods.size() * std::size(relations);
  std::vector<std::vector<Entry>> workers(plan.threads, std::vector<Entry>(entries));
  Progress progress("relations", "cases", plan.cases);
  run_blocks((plan.cases + block_size - 1) / block_size, plan.threads, [&](std::size_t block, unsigned w) {
    const std::uint64_t end = std::min(plan.cases, (block + 1) * block_size);
    for (std::uint64_t g = block * block_size; g < end; ++g) run_case(plan, g, workers[w]);
    progress.add(end - block * block_size);
  });
  std::vector<RelationCount> counts;
  for (std::size_t i = 0; i < entries; ++i) {
    Entry total;
    for (const auto& worker : workers) merge(total, worker[i]);
    RelationCount c{i / std::size(relations), i % std::size(relations), total.asked, total.broken};
    if (total.broken > 0) c.witness = total.first.queries;
    counts.push_back(c);
  }
  return counts;
}

}  // namespace tribunal
