// The small scope of polygons (exact/certificate/polygon_scope.h), run whole with a method.
#include "exact/certificate/polygon_scope.h"

#include "exact/base/failure.h"
#include "exact/base/parallel.h"
#include "exact/base/progress.h"
#include "exact/certificate/scope_part.h"

namespace tribunal {
namespace {

using small_scope_detail::Cells;
using small_scope_detail::Scope;
using Part = ScopePart;

constexpr const char* two_inclusions = "point in rings over 64-bit integers by generic rays and by half-open crossings";

/// All rings of these sizes, in order.
std::vector<Cells> rings_of(int fewest, int most, Start start) {
  std::vector<Cells> rings;
  for (int n = fewest; n <= most; ++n) {
    small_scope_detail::for_each_ring(n, start, [&](const Cells& ring) { rings.push_back(ring); });
  }
  return rings;
}

/// Asks all cases of one polygon that have segments.
void ask_segments(const Method& method, const std::vector<Cells>& rings, std::uint64_t number, Scope& scope,
                  Part& part) {
  const PolygonData& polygon = scope.place(rings);
  const PreparedPolygon prepared = method.polygon(polygon);
  scope.visit_cases(rings, number, [&](const Segment& s, Contact due, bool boundary) {
    part.add(method, {.contact = due, .boundary = boundary}, prepared.segment(s), [&] { return Query{s, polygon}; });
  });
}

/// Asks the piercing segments of one polygon as rays from their source through their target, so with the same contact;
/// the directions, small integers, take turns at three lengths.
void ask_rays(const Method& method, const std::vector<Cells>& rings, std::uint64_t number, Scope& scope, Part& part) {
  constexpr double lengths[] = {1, 0x1p-100, 0x1p100};
  const PolygonData& polygon = scope.place(rings);
  const PreparedPolygon prepared = method.polygon(polygon);
  int asked = 0;
  scope.visit_cases(rings, number, [&](const Segment& s, Contact due, bool boundary) {
    if (asked == scope.points()) return;  // what follows lies in the plane
    const Ray ray{s.p, {lengths[asked++ / 3 % 3] * (s.q - s.p)}};
    part.add(method, {.contact = due, .boundary = boundary, .of_ray = true}, prepared.ray(ray), [&] {
      return Query{ray, polygon};
    });
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
ScopeResult run(const Method& method, const SetDescription& set, const std::vector<Cells>& rings, int refinement,
                std::uint64_t polygons_per_ring, unsigned threads, const Visit& visit) {
  constexpr std::size_t block_size = 64;
  std::vector<Scope> scopes(threads, Scope(refinement));
  std::vector<Part> parts((rings.size() + block_size - 1) / block_size);
  Progress progress(set.name, "cases", set.size);
  run_blocks(parts.size(), threads, [&](std::size_t block, unsigned worker) {
    const std::size_t end = std::min(rings.size(), (block + 1) * block_size);
    for (std::size_t i = block * block_size; i < end; ++i) {
      std::uint64_t number = i * polygons_per_ring;
      visit(rings[i], [&](const std::vector<Cells>& polygon) {
        (set.of_rays ? ask_rays : ask_segments)(method, polygon, number++, scopes[worker], parts[block]);
      });
      require_agreement(scopes[worker], rings[i]);
    }
    progress.add(parts[block].count.asked, parts[block].count.wrong);
  });
  Part total;
  for (const Part& part : parts) total.merge(part);
  return total.result(set, two_inclusions);
}

constexpr auto alone = [](const Cells& ring, const auto& ask) { ask({ring}); };

constexpr int centred_refinement = 3;
constexpr std::uint64_t triangular_holes = 84;

/// The number of cases of a polygon: points in and around the grid, and segments of the grid.
std::uint64_t cases_of_polygon(int refinement) {
  const auto side = static_cast<std::uint64_t>(small_scope_detail::Grid{refinement}.side());
  return side * side + small_scope_detail::plane_segments;
}

}  // namespace

SetDescription rings_set(int most_vertices) {
  return {"all rings of 3 to " + std::to_string(most_vertices) + " vertices on a 3x3 grid",
          rings_of(3, most_vertices, Start::lowest).size() * cases_of_polygon(1)};
}

SetDescription ray_rings_set(int most_vertices) {
  const auto rings = rings_of(3, most_vertices, Start::lowest).size();
  return {"all rings of 3 to " + std::to_string(most_vertices) + " vertices on a 3x3 grid, pierced by rays",
          rings * (cases_of_polygon(1) - small_scope_detail::plane_segments), true};
}

SetDescription holes_set(int vertices) {
  return {
      std::string("all ") + (vertices == 3 ? "triangles" : "quadrilaterals") + " with a triangular hole on a 3x3 grid",
      rings_of(vertices, vertices, Start::lowest).size() * triangular_holes * cases_of_polygon(1)};
}

SetDescription two_holes_set() {
  return {"the square of a 3x3 grid with two triangular holes",
          triangular_holes * triangular_holes * cases_of_polygon(1)};
}

SetDescription centred_rings_set() {
  return {"all rings of 3 to 5 vertices from the centre of a 3x3 grid",
          rings_of(3, 5, Start::centre).size() * cases_of_polygon(centred_refinement)};
}

ScopeResult rings_run(const Method& method, int most_vertices, unsigned threads) {
  return run(method, rings_set(most_vertices), rings_of(3, most_vertices, Start::lowest), 1, 1, threads, alone);
}

ScopeResult pocket_of_rings_run(const Method& method) { return rings_run(method, 4, 1); }

ScopeResult ray_rings_run(const Method& method, int most_vertices, unsigned threads) {
  return run(method, ray_rings_set(most_vertices), rings_of(3, most_vertices, Start::lowest), 1, 1, threads, alone);
}

ScopeResult holes_run(const Method& method, int vertices, unsigned threads) {
  const auto with_holes = [](const Cells& ring, const auto& ask) {
    for_each_hole([&](const Cells& hole) { ask({ring, hole}); });
  };
  return run(method, holes_set(vertices), rings_of(vertices, vertices, Start::lowest), 1, triangular_holes, threads,
             with_holes);
}

ScopeResult two_holes_run(const Method& method, unsigned threads) {
  std::vector<Cells> holes;
  for_each_hole([&](const Cells& hole) { holes.push_back(hole); });
  const auto in_square = [](const Cells& hole, const auto& ask) {
    for_each_hole([&](const Cells& other) { ask({{0, 2, 8, 6}, hole, other}); });
  };
  return run(method, two_holes_set(), holes, 1, triangular_holes, threads, in_square);
}

ScopeResult centred_rings_run(const Method& method, unsigned threads) {
  return run(method, centred_rings_set(), rings_of(3, 5, Start::centre), centred_refinement, 1, threads, alone);
}

}  // namespace tribunal
