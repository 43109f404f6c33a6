// The small scope of polygons (exact/polygon/small_scope.h), run whole with a method.
#include "exact/certificate/scope_part.h"
#include "exact/harness/parallel.h"
#include "exact/harness/progress.h"
#include "exact/io/failure.h"
#include "exact/polygon/small_scope.h"

namespace tribunal {
namespace {

using small_scope_detail::Cells;
using small_scope_detail::Scope;
using Part = ScopePart<OnPolygons>;

constexpr const char* two_inclusions = "point in rings over 64-bit integers by generic rays and by half-open crossings";

/// All rings of these sizes, in order.
std::vector<Cells> rings_of(int fewest, int most, Start start) {
  std::vector<Cells> rings;
  for (int n = fewest; n <= most; ++n) {
    small_scope_detail::for_each_ring(n, start, [&](const Cells& ring) { rings.push_back(ring); });
  }
  return rings;
}

/// All cases of one polygon.
void ask_polygon(const Method& method, const std::vector<Cells>& rings, std::uint64_t number, Scope& scope,
                 Part& part) {
  const PolygonData& polygon = scope.place(rings);
  const PreparedPolygon prepared = method.polygon(polygon);
  scope.visit_cases(rings, number, [&](const Segment& s, Contact due, bool boundary) {
    part.add(method, {due, true, boundary}, prepared.segment(s), [&] { return PolygonQuery{s, polygon}; });
  });
}

void require_agreement(const Scope& scope, const Cells& ring) {
  if (scope.report.contradictions == 0) return;
  std::string text;
  for (const int cell : ring) text += " " + std::to_string(cell);
  throw Failure(Exit::oracles_contradict, "oracles contradict each other: the two inclusions on the grid, ring" + text);
}

/// `visit(ring, ask)` calls `ask` with the rings of each polygon that it makes of a ring. Rings are dealt out in
/// blocks.
template <class Visit>
PolygonScopeResult run(const Method& method, const std::string& name, const std::vector<Cells>& rings, int refinement,
                       std::uint64_t polygons_per_ring, unsigned threads, const Visit& visit) {
  constexpr std::size_t block_size = 64;
  std::vector<Scope> scopes(threads, Scope(refinement));
  const auto cases = static_cast<std::uint64_t>(scopes[0].points() + small_scope_detail::plane_segments);
  const std::uint64_t size = rings.size() * polygons_per_ring * cases;
  std::vector<Part> parts((rings.size() + block_size - 1) / block_size);
  Progress progress(name, "cases", size);
  run_blocks(parts.size(), threads, [&](std::size_t block, unsigned worker) {
    const std::size_t end = std::min(rings.size(), (block + 1) * block_size);
    for (std::size_t i = block * block_size; i < end; ++i) {
      std::uint64_t number = i * polygons_per_ring;
      visit(rings[i], [&](const std::vector<Cells>& polygon) {
        ask_polygon(method, polygon, number++, scopes[worker], parts[block]);
      });
      require_agreement(scopes[worker], rings[i]);
    }
    progress.add(parts[block].count.asked, parts[block].count.wrong);
  });
  Part total;
  for (const Part& part : parts) total.merge(part);
  return total.result(name, two_inclusions, size);
}

constexpr auto alone = [](const Cells& ring, const auto& ask) { ask({ring}); };

}  // namespace

PolygonScopeResult rings_run(const Method& method, int most_vertices, unsigned threads) {
  const std::string name = "all rings of 3 to " + std::to_string(most_vertices) + " vertices on a 3x3 grid";
  return run(method, name, rings_of(3, most_vertices, Start::lowest), 1, 1, threads, alone);
}

PolygonScopeResult pocket_of_rings_run(const Method& method) { return rings_run(method, 4, 1); }

PolygonScopeResult holes_run(const Method& method, unsigned threads) {
  constexpr std::uint64_t holes = 84;
  const auto with_holes = [](const Cells& ring, const auto& ask) {
    for_each_hole([&](const Cells& hole) { ask({ring, hole}); });
  };
  return run(method, "all quadrilaterals with a triangular hole on a 3x3 grid", rings_of(4, 4, Start::lowest), 1, holes,
             threads, with_holes);
}

PolygonScopeResult centred_rings_run(const Method& method, unsigned threads) {
  return run(method, "all rings of 3 to 5 vertices from the centre of a 3x3 grid", rings_of(3, 5, Start::centre), 3, 1,
             threads, alone);
}

}  // namespace tribunal
