#include "exact/certificate/small_scope.h"

#include <algorithm>
#include <array>
#include <bitset>

#include "exact/classes/class_table.h"
#include "exact/harness/parallel.h"
#include "exact/harness/progress.h"

namespace tribunal {
namespace {

constexpr std::size_t kept_wrong = 8;

using IntegerKernel = FormulaKernel<std::int64_t>;
using Classes = std::bitset<class_count + 1>;

/// FNV-1a, 64 bits.
struct Hash {
  std::uint64_t state = 0xcbf29ce484222325;

  void add(std::uint8_t byte) { state = (state ^ byte) * 0x100000001b3; }
  void add(std::uint64_t word) {
    for (int shift = 0; shift < 64; shift += 8) add(static_cast<std::uint8_t>(word >> shift));
  }
};

/// What one worker or block has found.
struct Part {
  Count count{};
  Classes classes{};
  Hash hash{};
  std::vector<Query> wrong{};

  void ask(const Method& method, const Segment& s, const Triangle& t, ClassId id) {
    const Answer answer = method.segment(s, t);
    const Judgement j = judge(method, {id, class_row(id).contact()}, answer);
    count.add(j);
    classes.set(id);
    hash.add(static_cast<std::uint8_t>(answer.status == Status::ok ? answer.hit : 2));
    if (j == Judgement::wrong && wrong.size() < kept_wrong) wrong.push_back({s, t});
  }
};

/// One of the 48 symmetries of the cube.
struct AxisMap {
  std::array<int, 3> axis;
  int negatives;

  Point3 operator()(const Point3& p) const {
    Point3 r;
    for (int i = 0; i < 3; ++i) {
      const double x = p[axis[static_cast<std::size_t>(i)]];
      r[i] = (negatives >> i & 1) != 0 ? -x : x;
    }
    return r;
  }
  Segment operator()(const Segment& s) const { return {(*this)(s.p), (*this)(s.q)}; }
  Triangle operator()(const Triangle& t) const { return {(*this)(t.a), (*this)(t.b), (*this)(t.c)}; }
};

std::vector<AxisMap> axis_maps() {
  std::vector<AxisMap> maps;
  std::array<int, 3> axis{0, 1, 2};
  do {
    for (int negatives = 0; negatives < 8; ++negatives) maps.push_back({axis, negatives});
  } while (std::ranges::next_permutation(axis).found);
  return maps;
}

std::array<Triangle, 6> orders_of(const Triangle& t) {
  return {{{t.a, t.b, t.c}, {t.a, t.c, t.b}, {t.b, t.a, t.c}, {t.b, t.c, t.a}, {t.c, t.a, t.b}, {t.c, t.b, t.a}}};
}

std::vector<Point3> lattice(int side) {
  std::vector<Point3> points;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < side; ++z) points.emplace_back(x, y, z);
    }
  }
  return points;
}

/// All segments of the lattice against one triangle.
Part run_triangle(const Method& method, const Triangle& t, const std::vector<Point3>& points) {
  Part part;
  for (const Point3& p : points) {
    for (const Point3& q : points) {
      const Segment s{p, q};
      part.ask(method, s, t, class_of(chirotope(s, t, IntegerKernel{})));
    }
  }
  return part;
}

ScopeResult result_of(std::string name, std::uint64_t size, const Part& part) {
  return {.name = std::move(name),
          .size = size,
          .answers_hash = part.hash.state,
          .count = part.count,
          .classes = static_cast<int>(part.classes.count()),
          .complete = part.count.asked == size,
          .wrong = part.wrong};
}

}  // namespace

ScopeResult pocket_run(const Method& method) {
  const std::vector<AxisMap> maps = axis_maps();
  Part part;
  for (const ClassRow& row : class_table()) {
    const Segment s = row.representative_segment();
    for (const Triangle& t : orders_of(row.representative_triangle())) {
      for (const Segment& directed : {s, Segment{s.q, s.p}}) {
        for (const AxisMap& map : maps) part.ask(method, map(directed), map(t), row.id);
      }
    }
  }
  return result_of("163 classes x 12 orders x 48 axis maps", class_count * 12 * 48, part);
}

ScopeResult lattice_run(const Method& method, int side, unsigned threads) {
  const std::vector<Point3> points = lattice(side);
  const std::size_t n = points.size(), triangles = n * n * n;
  const std::string name = "all ordered tuples of {0.." + std::to_string(side - 1) + "}^3";
  std::vector<Part> parts(triangles);
  Progress progress(name, "cases", triangles * n * n);
  run_blocks(triangles, threads, [&](std::size_t i, unsigned) {
    parts[i] = run_triangle(method, {points[i / n / n], points[i / n % n], points[i % n]}, points);
    progress.add(n * n, parts[i].count.wrong);
  });

  Part total;
  for (const Part& part : parts) {
    total.count += part.count;
    total.classes |= part.classes;
    total.hash.add(part.hash.state);
    for (const Query& q : part.wrong) {
      if (total.wrong.size() < kept_wrong) total.wrong.push_back(q);
    }
  }
  return result_of(name, triangles * n * n, total);
}

}  // namespace tribunal
