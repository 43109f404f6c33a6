// Rays and triangles at every scale that a format has, with answers that scaling cannot change.
//
// A scene is made of small integers, on which integer arithmetic says what is hit and what is hit first. Then each axis
// is multiplied by a power of two, and each direction by one of its own; all exactly. So the answers stay, whatever
// the scales, and no code that is on trial takes part in them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/format.h"
#include "core/signed_volume.h"
#include "exact/cases/families/draw.h"
#include "exact/kernels/integers.h"
#include "exact/oracles/caratheodory.h"

namespace tribunal::testing {

struct ScaledScene {
  std::vector<Triangle> triangles;
  std::vector<Ray> rays;
  std::vector<std::uint8_t> hit;                      ///< ray r hits triangle t: element r·triangles.size() + t
  std::vector<std::optional<std::uint32_t>> closest;  ///< for each ray: least t, then least id, none in its plane

  bool hits(std::size_t ray, std::size_t triangle) const { return hit[ray * triangles.size() + triangle] != 0; }
};

namespace scaled_detail {

/// Exponents by which an integer of up to 20 bits may be multiplied.
struct ExponentRange {
  int least, most;
};

constexpr ExponentRange exponents_of(Format format) {
  return format == Format::binary32 ? ExponentRange{-149, 107} : ExponentRange{-1074, 1003};
}

/// Draws the scales of the axes: in half of all scenes of ordinary size, some of them stretched; in the others
/// anywhere in the range of the format.
inline Point3 draw_scale(Draw& draw, Format format) {
  const auto [least, most] = exponents_of(format);
  const bool ordinary = draw.below(2) == 0, stretched = draw.below(2) == 0;
  Point3 exponents(static_cast<double>(ordinary ? draw.between(-40, 40) : draw.between(least, most)));
  if (!stretched) return exponents;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t e =
        ordinary ? static_cast<std::int64_t>(exponents[axis]) + draw.between(-9, 9) : draw.between(least, most);
    exponents[axis] = static_cast<double>(e);
  }
  return exponents;
}

inline Point3 scaled(const Point3& p, const Point3& exponents, int more) {
  Point3 q;
  for (int axis = 0; axis < 3; ++axis) q[axis] = std::ldexp(p[axis], static_cast<int>(exponents[axis]) + more);
  return q;
}

inline Point3 draw_point(Draw& draw, int bits) {
  const std::int64_t most = std::int64_t{1} << bits;
  Point3 p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = static_cast<double>(draw.between(-most, most));
  return p;
}

/// Draws a direction towards a point of the triangle, often on an edge or at a vertex; or past the triangle; or in
/// any direction; or zero.
inline Direction draw_direction(Draw& draw, int bits, const Point3& o, const Triangle& t) {
  const std::uint64_t kind = draw.below(16);
  if (kind == 0) return {Point3(0)};
  if (kind == 1) return {draw_point(draw, bits)};
  double weights[3];
  for (double& w : weights) w = static_cast<double>(draw.below(3));
  const double sum = weights[0] + weights[1] + weights[2];
  Point3 d = weights[0] * t.a + weights[1] * t.b + weights[2] * t.c - sum * o;
  if (kind < 6) d += draw_point(draw, 0);
  return {kind == 2 ? -d : d};
}

inline bool meets(const Ray& ray, const Triangle& t) {
  return with_exact_number(ray, t,
                           []<class N>(const Ray& r, const Triangle& u) { return meets_by_caratheodory<N>(r, u); });
}

/// The ray crosses the plane at num/den, den > 0; den = 0 where it is parallel.
struct Fraction {
  Wide num, den;
};

inline Fraction parameter(const Ray& r, const Triangle& t) {
  const Wide num = signed_volume<Wide>(t.a, t.b, t.c, r.o), den = -signed_volume<Wide>(t.a, t.b, t.c, r.d);
  return den < 0 ? Fraction{-num, -den} : Fraction{num, den};
}

inline std::optional<std::uint32_t> closest(const ScaledScene& scene, std::size_t ray) {
  std::optional<std::uint32_t> best;
  Fraction least{};
  for (std::uint32_t i = 0; i < scene.triangles.size(); ++i) {
    const Fraction t = parameter(scene.rays[ray], scene.triangles[i]);
    if (!scene.hits(ray, i) || t.den == 0) continue;
    if (best && t.num * least.den >= least.num * t.den) continue;
    best = i;
    least = t;
  }
  return best;
}

}  // namespace scaled_detail

/// Draws scene k of this format.
inline ScaledScene scaled_scene(Format format, std::uint64_t k, std::size_t rays = 24, std::size_t triangles = 6) {
  using namespace scaled_detail;
  Draw draw(979, format == Format::binary32 ? 1 : 2, k);
  constexpr int sizes[] = {2, 4, 8, 16};
  const int bits = sizes[draw.below(4)];
  ScaledScene scene;
  for (std::size_t i = 0; i < triangles; ++i) {
    const Point3 a = draw_point(draw, bits);
    const Point3 b = draw_point(draw, bits);
    const Point3 c = draw_point(draw, bits);
    scene.triangles.push_back({a, b, c});
  }
  for (std::size_t i = 0; i < rays; ++i) {
    const Triangle& aim = scene.triangles[draw.below(triangles)];
    const Point3 o = draw.below(16) == 0 ? aim.b : draw_point(draw, bits);
    scene.rays.push_back({o, draw_direction(draw, bits, o, aim)});
  }
  for (const Ray& r : scene.rays) {
    for (const Triangle& t : scene.triangles) scene.hit.push_back(meets(r, t));
  }
  for (std::size_t i = 0; i < rays; ++i) scene.closest.push_back(closest(scene, i));

  const Point3 scale = draw_scale(draw, format);
  const auto [least, most] = exponents_of(format);
  const auto [low, high] = std::minmax({scale.x, scale.y, scale.z});
  for (Triangle& t : scene.triangles) {
    for (Point3* v : {&t.a, &t.b, &t.c}) *v = scaled(*v, scale, 0);
  }
  for (Ray& r : scene.rays) {
    const int length = static_cast<int>(draw.between(least - static_cast<int>(low), most - static_cast<int>(high)));
    r = {scaled(r.o, scale, 0), {scaled(r.d.v, scale, length)}};
  }
  return scene;
}

/// The control words of all rounding modes, each with neither, either and both of flush to zero and denormals are zero.
inline constexpr unsigned environments[] = {0x0000, 0x2000, 0x4000, 0x6000, 0x8040, 0xa040, 0xc040, 0xe040,
                                            0x0040, 0x2040, 0x4040, 0x6040, 0x8000, 0xa000, 0xc000, 0xe000};

/// Another floating-point environment, for one scope.
class InEnvironment {
 public:
  explicit InEnvironment(unsigned bits) : own_(__builtin_ia32_stmxcsr()) {
    __builtin_ia32_ldmxcsr((own_ & ~0xe040U) | bits);
  }
  ~InEnvironment() { __builtin_ia32_ldmxcsr(own_); }
  InEnvironment(const InEnvironment&) = delete;
  InEnvironment& operator=(const InEnvironment&) = delete;

 private:
  unsigned own_;
};

}  // namespace tribunal::testing
