// Scenes for trees, and every question about them held against a test of every triangle.
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/segura_feito.h"
#include "tests/mutation/kill.h"
#include "tracer/accel/triangle_tree.h"

namespace tribunal::killing {

inline const FormulaKernel<std::int64_t> integers;
inline const FormulaKernel<mpq_class> fractions;

/// Where a scene of integers lies: coordinates are offset + scale·n.
struct Image {
  double scale, offset;

  Point3 operator()(const Point3& p) const { return scale * p + Point3(offset, -offset, 2 * offset); }
  Triangle operator()(const Triangle& t) const { return {(*this)(t.a), (*this)(t.b), (*this)(t.c)}; }
  Ray operator()(const Ray& r) const { return {(*this)(r.o), {scale * r.d.v}}; }
  Segment operator()(const Segment& s) const { return {(*this)(s.p), (*this)(s.q)}; }
};
inline constexpr Image here{1, 0};

template <class P, class K>
bool sees(const P& probe, const Triangle& t, const K& k) {
  const Answer a = segura_feito(probe, t, k);
  return a.hit && a.contact != Contact::coplanar;
}

/// The triangles that a ray sees, in order.
template <class K>
std::vector<std::uint32_t> seen(const Ray& r, const std::vector<Triangle>& triangles, const K& k) {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (sees(r, triangles[i], k)) ids.push_back(i);
  }
  std::stable_sort(ids.begin(), ids.end(), [&](std::uint32_t a, std::uint32_t b) {
    return k.compare_hits(r, triangles[a], triangles[b]) == Sign::negative;
  });
  return ids;
}

template <class K>
bool sees_any(const Segment& s, const std::vector<Triangle>& triangles, const K& k) {
  return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) { return sees(s, t, k); });
}

/// A scene with the rays to ask it, as integers or as they are.
struct Scene {
  std::vector<Triangle> triangles{};
  std::vector<Ray> rays{};
  std::vector<Segment> ways{};
};

inline void require_parameter(const Ray& r, const Triangle& t, double given) {
  const HitParameter<mpq_class> p = hit_parameter<mpq_class>(r, t);
  const mpq_class exact = p.num / p.den, error = abs(exact - mpq_class(given));
  require(error <= abs(exact) / (1 << 20) || (error < mpq_class(5e-324)), "the parameter");
}

template <class Answer, class Question, class Ask>
std::vector<Answer> together(const std::vector<Question>& questions, const Ask& ask) {
  std::vector<Answer> answers(questions.size());
  ask(std::span<const Question>(questions), std::span<Answer>(answers));
  return answers;
}

/// Every question, one by one and in batches, against every triangle.
template <class K>
void check_scene(const Scene& scene, const Image& image, const K& k) {
  std::vector<Triangle> placed;
  for (const Triangle& t : scene.triangles) placed.push_back(image(t));
  std::vector<Ray> rays;
  for (const Ray& r : scene.rays) rays.push_back(image(r));
  std::vector<Segment> ways;
  for (const Segment& s : scene.ways) ways.push_back(image(s));
  const TriangleTree tree(placed);
  using Hit = std::optional<Nearest>;
  const auto batch = together<Hit>(rays, [&](auto q, auto a) { tree.closest(q, a); });
  const auto met = together<std::uint8_t>(rays, [&](auto q, auto a) { tree.any(q, a); });
  const auto all = together<std::vector<Nearest>>(rays, [&](auto q, auto a) { tree.all(q, a); });
  const auto parities = together<Parity>(rays, [&](auto q, auto a) { tree.parity(q, a); });
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const std::vector<std::uint32_t> due = seen(scene.rays[i], scene.triangles, k);
    const Hit alone = tree.closest(rays[i]);
    require(alone.has_value() == !due.empty() && batch[i].has_value() == alone.has_value(), "whether a ray hits");
    require((met[i] != 0) == !due.empty() && met[i] <= 1 && tree.any(rays[i]) == !due.empty(), "any hit of a ray");
    if (alone) {
      require(alone->id == due[0] && batch[i]->id == due[0], "the closest hit");
      require_parameter(rays[i], placed[due[0]], alone->t);
      require_parameter(rays[i], placed[due[0]], batch[i]->t);
    }
    require(all[i].size() == due.size(), "all hits");
    for (std::size_t n = 0; n < due.size(); ++n) {
      require(all[i][n].id == due[n], "all hits, in order");
      if (n < 4) require_parameter(rays[i], placed[due[n]], all[i][n].t);
    }
    require(parities[i] == tree.parity(rays[i]), "parity in batches");
  }
  const auto ways_met = together<std::uint8_t>(ways, [&](auto q, auto a) { tree.any(q, a); });
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const bool due = sees_any(scene.ways[i], scene.triangles, k);
    require(tree.any(ways[i]) == due && (ways_met[i] != 0) == due, "any hit of a segment");
  }
}

// --- scenes ---------------------------------------------------------------------------------------------------------

/// So that a quarter of a midpoint is an integer.
inline Point3 lattice(Draw& draw) { return draw.point(4) * 16.0; }

/// Lattice triangles: shared planes, corners and edges, some without area, some twice.
inline std::vector<Triangle> soup(Draw& draw, int count) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i) {
    const Point3 a = lattice(draw), b = lattice(draw);
    triangles.push_back({a, b, i % 9 == 0 ? 0.5 * (a + b) : lattice(draw)});
    if (i % 8 == 0) triangles.push_back({b, a, triangles.back().c});
  }
  return triangles;
}

/// At a vertex, a midpoint or a point of a face, along an axis, from a corner, within a plane, or anywhere.
inline Ray aimed(Draw& draw, const std::vector<Triangle>& triangles) {
  const auto any = [&]() -> const Triangle& {
    return triangles[static_cast<std::size_t>(draw.below(static_cast<int>(triangles.size())))];
  };
  const Triangle &t = any(), &u = any();
  const Point3 targets[] = {t.a, 0.5 * (t.a + t.b), 0.5 * t.a + 0.25 * t.b + 0.25 * t.c, t.c};
  const Point3 target = targets[draw.below(4)];
  Point3 axis(draw.below(2) == 0 ? -0.0 : 0.0);
  axis[draw.below(3)] = draw.below(2) == 0 ? 1 : -1;
  switch (draw.below(6)) {
    case 0:
      return {target - 160.0 * axis, {axis}};
    case 1:
      return {u.b, {target - u.b}};
    case 2: {
      const Point3 from = 4.0 * draw.point(30);
      return {from, {target - from}};
    }
    case 3:
      return {t.b, {t.a - t.b}};
    case 4:
      return {target, {draw.point(9)}};
    default:
      return {4.0 * draw.point(24), {draw.point(9)}};
  }
}

inline Scene drawn_scene(Draw& draw, int triangles, int rays) {
  Scene s{soup(draw, triangles)};
  for (int i = 0; i < rays; ++i) {
    // A run of rays that are alike, then some that are not.
    const Ray r = aimed(draw, s.triangles);
    for (int n = draw.below(2) == 0 ? 1 : 12; n > 0; --n) s.rays.push_back(r);
  }
  for (const Ray& r : s.rays) s.ways.push_back({r.o, r.o + r.d.v});
  return s;
}

/// Triangles almost without area, almost parallel, and at distances that differ in the last digits.
inline Scene slivers(Draw& draw) {
  Scene s;
  for (int i = 0; i < 20; ++i) {
    const Point3 a = draw.point_of(4), b = draw.point_of(4), c = draw.point_of(4);
    s.triangles.push_back({a, b, 0.5 * (a + b) + 0x1p-40 * c});
    s.triangles.push_back({a, b, c});
    s.triangles.push_back({a, b, c + 0x1p-50 * draw.point(3)});
    s.triangles.push_back({0x1p-20 * a, 0x1p-20 * b, 0x1p-20 * c});
  }
  for (int i = 0; i < 60; ++i) {
    const Triangle& t = s.triangles[static_cast<std::size_t>(draw.below(80))];
    const Point3 from = draw.below(3) == 0 ? 0x1p30 * draw.point_of(4) : draw.point_of(4);
    const Point3 target = draw.below(2) == 0 ? t.a : 0.25 * t.a + 0.25 * t.b + 0.5 * t.c;
    s.rays.push_back({from, {target - from}});
    s.ways.push_back({from, target});
  }
  return s;
}

}  // namespace tribunal::killing
