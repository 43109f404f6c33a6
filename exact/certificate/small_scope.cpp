#include "exact/certificate/small_scope.h"

#include <algorithm>
#include <array>

#include "exact/certificate/scope_part.h"
#include "exact/classes/class_table.h"
#include "exact/families/axis_maps.h"
#include "exact/harness/parallel.h"
#include "exact/harness/progress.h"
#include "exact/io/failure.h"
#include "exact/oracles/caratheodory.h"

namespace tribunal {
namespace {

using Integer = std::int32_t;  ///< coordinates up to 4: every volume fits by far
using IntegerKernel = FormulaKernel<Integer>;
using ClassCounts = std::array<std::uint64_t, class_count + 1>;

constexpr const char* class_and_caratheodory = "class by 32-bit orientations, Caratheodory over 32-bit integers";

using Part = ScopePart<OnTriangles>;

void ask(Part& part, const Method& method, const Segment& s, const Triangle& t, const Truth& truth) {
  part.add(method, truth, method.segment(s, t), [&] { return Query{s, t}; });
}

std::array<Triangle, 6> orders_of(const Triangle& t) {
  return {{{t.a, t.b, t.c}, {t.a, t.c, t.b}, {t.b, t.a, t.c}, {t.b, t.c, t.a}, {t.c, t.a, t.b}, {t.c, t.b, t.a}}};
}

/// Points in lexicographic order, and what is shared by all tuples of them.
using Points = std::vector<Point3>;

Points lattice(int side) {
  Points points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) points.emplace_back(x, y, z);
    }
  }
  return points;
}

/// Indices i ≤ j ≤ k into the points.
using Triple = std::array<std::size_t, 3>;

std::vector<Triple> triples(std::size_t n) {
  std::vector<Triple> list;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i; j < n; ++j) {
      for (std::size_t k = j; k < n; ++k) list.push_back({i, j, k});
    }
  }
  return list;
}

/// The distinct orders of a triangle with i ≤ j ≤ k: 6, 3 or 1.
std::vector<Triangle> distinct_orders(const Points& points, Triple t) {
  std::vector<Triangle> orders;
  do {
    orders.push_back({points[t[0]], points[t[1]], points[t[2]]});
  } while (std::next_permutation(t.begin(), t.end()));
  return orders;
}

/// The exact answer by two formulations.
Truth lattice_truth(const Segment& s, const Triangle& t) {
  const ClassId id = class_of(chirotope(s, t, IntegerKernel{}));
  const Truth truth{id, class_row(id).contact()};
  if (meets_by_caratheodory<Integer>(s, t) != truth.hit()) exact_truth({s, t});  // names both witnesses
  return truth;
}

/// What an unordered run adds: how many unordered tuples each class has.
struct LatticePart {
  Part part{};
  ClassCounts tuples{};
};

/// All segments of the points against one triangle, in all orders.
void run_triangle(const Method& method, const Points& points, const Triple& triple, LatticePart& out) {
  const std::vector<Triangle> orders = distinct_orders(points, triple);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i; j < points.size(); ++j) {
      const Truth truth = lattice_truth({points[i], points[j]}, orders[0]);
      ++out.tuples[truth.class_id];
      for (const Triangle& t : orders) {
        ask(out.part, method, {points[i], points[j]}, t, truth);
        if (i != j) ask(out.part, method, {points[j], points[i]}, t, truth);
      }
    }
  }
}

/// The class table has counted the unordered tuples of these two lattices, by a program of its own.
void require_counts_of_table(const ClassCounts& tuples, int side) {
  if (side != 3 && side != 4) return;
  for (const ClassRow& row : class_table()) {
    const std::uint64_t due = side == 3 ? row.count_3 : row.count_4;
    if (tuples[row.id] != due) {
      throw Failure(Exit::oracles_contradict, "oracles contradict each other: the class table has " +
                                                  std::to_string(due) + " tuples of " + class_name(row.id) +
                                                  ", the lattice " + std::to_string(tuples[row.id]));
    }
  }
}

std::uint64_t fifth_power(std::uint64_t n) { return n * n * n * n * n; }

}  // namespace

ScopeResult pocket_run(const Method& method) {
  Part part;
  for (const ClassRow& row : class_table()) {
    const Segment s = row.representative_segment();
    const Truth truth{row.id, row.contact()};
    for (const Triangle& t : orders_of(row.representative_triangle())) {
      for (const Segment& directed : {s, Segment{s.q, s.p}}) {
        for (const AxisMap& map : axis_maps()) ask(part, method, map(directed), map(t), truth);
      }
    }
  }
  return part.result("163 classes x 12 orders x 48 axis maps", "class table", class_count * 12 * 48);
}

ScopeResult lattice_run(const Method& method, int side, unsigned threads) {
  const Points points = lattice(side);
  const std::vector<Triple> triangles = triples(points.size());
  const std::string name = "all ordered tuples of {0.." + std::to_string(side - 1) + "}^3";
  const std::uint64_t size = fifth_power(points.size());
  std::vector<Part> parts(triangles.size());
  std::vector<ClassCounts> tuples(threads);
  Progress progress(name, "cases", size);
  run_blocks(triangles.size(), threads, [&](std::size_t i, unsigned worker) {
    LatticePart block;
    run_triangle(method, points, triangles[i], block);
    for (std::size_t id = 0; id <= class_count; ++id) tuples[worker][id] += block.tuples[id];
    parts[i] = std::move(block.part);
    progress.add(parts[i].count.asked, parts[i].count.wrong);
  });

  Part total;
  for (const Part& part : parts) total.merge(part);
  for (unsigned w = 1; w < threads; ++w) {
    for (std::size_t id = 0; id <= class_count; ++id) tuples[0][id] += tuples[w][id];
  }
  if (total.count.asked == size) require_counts_of_table(tuples[0], side);
  return total.result(name, class_and_caratheodory, size);
}

ScopeResult line_run(const Method& method) {
  LatticePart all;
  std::uint64_t size = 0;
  for (const Point3& d : lattice(3)) {
    const Point3 direction = d - Point3(1, 1, 1);
    if (lexicographic(Point3(0, 0, 0), direction, IntegerKernel{}) != Sign::positive) continue;
    Points points;
    for (int i = 0; i < 5; ++i) points.push_back(direction * static_cast<double>(i));
    for (const Triple& t : triples(points.size())) run_triangle(method, points, t, all);
    size += fifth_power(points.size());
  }
  return all.part.result("all ordered tuples of five points of a line, along 13 directions", class_and_caratheodory,
                         size);
}

}  // namespace tribunal
