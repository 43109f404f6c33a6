#include "exact/certificate/small_scope.h"

#include <algorithm>
#include <array>

#include "exact/base/failure.h"
#include "exact/base/parallel.h"
#include "exact/base/progress.h"
#include "exact/cases/families/axis_maps.h"
#include "exact/certificate/scope_part.h"
#include "exact/classes/class_table.h"
#include "exact/oracles/caratheodory.h"

namespace tribunal {
namespace {

using Integer = std::int32_t;  ///< coordinates up to 4: every volume fits by far
using IntegerKernel = FormulaKernel<Integer>;
using ClassCounts = std::array<std::uint64_t, all_class_count + 1>;

constexpr const char* class_and_caratheodory = "class by 32-bit orientations, Caratheodory over 32-bit integers";

using Part = ScopePart;

Answer answer_to(const Method& method, const Segment& s, const Triangle& t) { return method.segment(s, t); }
Answer answer_to(const Method& method, const Ray& r, const Triangle& t) { return method.ray(r, t); }

/// The order of the vertices and the direction of the probe matter to methods that cull, and to no class.
template <class P>
Truth seen_from(const Method& method, const P& probe, const Triangle& t, const Truth& truth) {
  return method.contract.culling == Culling::none ? truth : truth_in_class(truth.class_id, {probe, t});
}

template <class P>
void ask(Part& part, const Method& method, const P& probe, const Triangle& t, const Truth& truth) {
  part.add(method, seen_from(method, probe, t, truth), answer_to(method, probe, t), [&] { return Query{probe, t}; });
}

std::array<Triangle, 6> orders_of(const Triangle& t) {
  return {{{t.a, t.b, t.c}, {t.a, t.c, t.b}, {t.b, t.a, t.c}, {t.b, t.c, t.a}, {t.c, t.a, t.b}, {t.c, t.b, t.a}}};
}

/// Points in lexicographic order.
using Points = std::vector<Point3>;

/// {least..most}³
Points cube(int least, int most) {
  Points points;
  for (int x = least; x <= most; ++x) {
    for (int y = least; y <= most; ++y) {
      for (int z = least; z <= most; ++z) points.emplace_back(x, y, z);
    }
  }
  return points;
}

Points lattice(int side) { return cube(0, side - 1); }

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
template <class P>
Truth lattice_truth(const P& probe, const Triangle& t) {
  const ClassId id = class_of(probe, t, IntegerKernel{});
  const Truth truth = truth_of_class(id);
  if (meets_by_caratheodory<Integer>(probe, t) != truth.hit()) exact_truth({probe, t});  // names both witnesses
  return truth;
}

/// The part of a run over unordered tuples, and how many of these each class has.
struct LatticePart {
  Part part{};
  ClassCounts tuples{};
};

/// Asks all segments between the points against one triangle, each in all orders.
void run_triangle(const Method& method, const Points& points, const Triple& triple, LatticePart& out) {
  const std::vector<Triangle> orders = distinct_orders(points, triple);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i; j < points.size(); ++j) {
      const Truth truth = lattice_truth(Segment{points[i], points[j]}, orders[0]);
      ++out.tuples[truth.class_id];
      for (const Triangle& t : orders) {
        ask(out.part, method, Segment{points[i], points[j]}, t, truth);
        if (i != j) ask(out.part, method, Segment{points[j], points[i]}, t, truth);
      }
    }
  }
}

/// The class table has the numbers of unordered tuples of these two lattices, which another program has counted.
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

/// The origins and directions of ray_lattice_run, full or not, for triangles of {0, 1, 2}³.
struct RayLattice {
  Points origins, directions;
};

RayLattice ray_lattice(bool full) { return {full ? cube(-1, 2) : cube(-1, 1), full ? cube(-2, 2) : cube(-1, 1)}; }

}  // namespace

SetDescription pocket_set() { return {"163 classes x 12 orders x 48 axis maps", class_count * 12 * 48}; }

SetDescription ray_pocket_set() {
  return {"165 ray classes x 6 orders x 48 axis maps x 3 lengths", ray_class_count * 6 * 48 * 3, true};
}

SetDescription lattice_set(int side) {
  return {"all ordered tuples of {0.." + std::to_string(side - 1) + "}^3", fifth_power(lattice(side).size())};
}

SetDescription ray_lattice_set(bool full) {
  const RayLattice l = ray_lattice(full);
  return {std::string("all rays from ") + (full ? "{-1..2}^3 along {-2..2}^3" : "{-1..1}^3 along {-1..1}^3") +
              " and all triangles of {0..2}^3",
          27 * 27 * 27 * l.origins.size() * l.directions.size(), true};
}

SetDescription line_set() {
  return {"all ordered tuples of five points of a line, along 13 directions", 13 * fifth_power(5)};
}

ScopeResult pocket_run(const Method& method) {
  Part part;
  for (const ClassRow& row : class_table()) {
    const Segment s = row.representative_segment();
    const Truth truth = truth_of_class(row.id);
    for (const Triangle& t : orders_of(row.representative_triangle())) {
      for (const Segment& directed : {s, Segment{s.q, s.p}}) {
        for (const AxisMap& map : axis_maps()) ask(part, method, map(directed), map(t), truth);
      }
    }
  }
  return part.result(pocket_set(), "class table");
}

ScopeResult ray_pocket_run(const Method& method) {
  Part part;
  for (const ClassRow& row : ray_class_table()) {
    const Truth truth = truth_of_class(row.id);
    for (const Triangle& t : orders_of(row.representative_triangle())) {
      for (const AxisMap& map : axis_maps()) {
        const Ray r = map(row.representative_ray());
        for (const double length : {0x1p-100, 1.0, 0x1p100}) {
          ask(part, method, Ray{r.o, {length * r.d.v}}, map(t), truth);
        }
      }
    }
  }
  return part.result(ray_pocket_set(), "class table");
}

ScopeResult ray_lattice_run(const Method& method, bool full, unsigned threads) {
  const SetDescription set = ray_lattice_set(full);
  const Points points = lattice(3);
  const RayLattice rays = ray_lattice(full);
  const std::vector<Triple> triangles = triples(points.size());
  std::vector<Part> parts(triangles.size());
  Progress progress(set.name, "cases", set.size);
  run_blocks(triangles.size(), threads, [&](std::size_t i, unsigned) {
    const std::vector<Triangle> orders = distinct_orders(points, triangles[i]);
    for (const Point3& o : rays.origins) {
      for (const Point3& d : rays.directions) {
        const Ray ray{o, {d}};
        const Truth truth = lattice_truth(ray, orders[0]);
        for (const Triangle& t : orders) ask(parts[i], method, ray, t, truth);
      }
    }
    progress.add(parts[i].count.asked, parts[i].count.wrong);
  });
  Part total;
  for (const Part& part : parts) total.merge(part);
  return total.result(set, class_and_caratheodory);
}

ScopeResult lattice_run(const Method& method, int side, unsigned threads) {
  const Points points = lattice(side);
  const std::vector<Triple> triangles = triples(points.size());
  const SetDescription set = lattice_set(side);
  std::vector<Part> parts(triangles.size());
  std::vector<ClassCounts> tuples(threads);
  Progress progress(set.name, "cases", set.size);
  run_blocks(triangles.size(), threads, [&](std::size_t i, unsigned worker) {
    LatticePart block;
    run_triangle(method, points, triangles[i], block);
    for (std::size_t id = 0; id <= all_class_count; ++id) tuples[worker][id] += block.tuples[id];
    parts[i] = std::move(block.part);
    progress.add(parts[i].count.asked, parts[i].count.wrong);
  });

  Part total;
  for (const Part& part : parts) total.merge(part);
  for (unsigned w = 1; w < threads; ++w) {
    for (std::size_t id = 0; id <= all_class_count; ++id) tuples[0][id] += tuples[w][id];
  }
  if (total.count.asked == set.size) require_counts_of_table(tuples[0], side);
  return total.result(set, class_and_caratheodory);
}

ScopeResult line_run(const Method& method) {
  LatticePart all;
  for (const Point3& d : lattice(3)) {
    const Point3 direction = d - Point3(1, 1, 1);
    if (detail::lexicographic(Point3(0, 0, 0), direction, IntegerKernel{}) != Sign::positive) continue;
    Points points;
    for (int i = 0; i < 5; ++i) points.push_back(direction * static_cast<double>(i));
    for (const Triple& t : triples(points.size())) run_triangle(method, points, t, all);
  }
  return all.part.result(line_set(), class_and_caratheodory);
}

}  // namespace tribunal
