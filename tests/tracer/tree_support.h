// Triangles and rays that are difficult for trees, and their hits by exact arithmetic.
#pragma once

#include <optional>
#include <string>

#include "exact/filtered/batch.h"
#include "tests/tracer/support.h"
#include "tracer/accel/triangle_tree.h"
#include "tracer/shading/visibility.h"

namespace tribunal::testing {

/// Runs a test once for each instruction set of this machine.
class OnEveryTarget : public ::testing::TestWithParam<std::string_view> {
 protected:
  void SetUp() override { force_batch_target(GetParam()); }
  void TearDown() override { force_batch_target({}); }
};

inline std::string target_name(const ::testing::TestParamInfo<std::string_view>& i) {
  return std::string(i.param == "AVX-512" ? "AVX512" : i.param);
}

/// Lattice triangles (shared planes, corners and edges, some without area) and slivers.
inline std::vector<Triangle> soup(Random& random, const Point3& offset, double scale, int count) {
  std::vector<Triangle> triangles;
  const auto lattice = [&] {
    const int x = random.within(0, 4), y = random.within(0, 4), z = random.within(0, 4);
    return offset + scale * Point3(x, y, z);
  };
  for (int i = 0; i < count; ++i) {
    const Point3 a = lattice();
    const Point3 b = lattice();
    const Point3 c = i % 4 == 0 ? 0.5 * (a + b) + (scale * 0x1p-30) * random.point(1) : lattice();
    triangles.push_back({a, b, c});
    if (i % 8 == 0) triangles.push_back({b, a, c});  // a tie wherever it is hit
  }
  return triangles;
}

/// A ray at a vertex, a midpoint of an edge or a point of a face, in the plane of a face or along an axis, from afar
/// or from inside.
inline Ray aimed(Random& random, const std::vector<Triangle>& triangles, double scale) {
  const Triangle& t = triangles[random.below(triangles.size())];
  const Triangle& u = triangles[random.below(triangles.size())];
  const Point3 targets[] = {t.a, 0.5 * (t.a + t.b), t.a + 0.25 * (t.b - t.a) + 0.25 * (t.c - t.a), t.c};
  const Point3 target = targets[random.below(4)];
  const Point3 elsewhere = target + scale * random.point(8);
  Point3 axis(random.below(2) == 0 ? -0.0 : 0.0);
  axis[static_cast<int>(random.below(3))] = random.below(2) == 0 ? scale : -scale;
  switch (random.below(5)) {
    case 0:
      return {target - 8.0 * axis, {axis}};
    case 1:
      return {u.b, {target - u.b}};
    case 2:
      return {elsewhere, {target - elsewhere}};
    case 3:
      return {t.b, {t.a - t.b}};
    default:
      return {target, {scale * random.point(1)}};
  }
}

/// The closest hit by a test of every triangle over rationals.
inline std::optional<std::uint32_t> brute_force(const std::vector<Triangle>& triangles, const Ray& ray) {
  const Method& m = method("sf-rational");
  std::optional<std::uint32_t> best;
  if (!is_finite(ray)) return best;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (!is_visible_hit(m.ray(ray, triangles[i]))) continue;
    if (!best || m.compare_hits(ray, triangles[i], triangles[*best]) == Sign::negative) best = i;
  }
  return best;
}

}  // namespace tribunal::testing
