// A ray or segment made ready for boxes in binary32, eight at a time, without ever losing a box that it meets.
//
// In the tree's frame (tree.h) a probe is X(τ) = s + τ·δ, τ ≥ 0, where s = (o − centre)·unit, δ is the direction times
// the power of two that makes its largest component 1 ≤ |δⱼ| < 2, and t = τ / scale, `scale` a power of two. Let M be
// the frame's reach and S = max |sᵢ|. All boxes lie in [−M, M]³, so wherever the probe is in one, τ ≤ M + S.
//
// Claim. For a plane X of a box on axis i we compute, in binary32, near(X) = X·r − c⁺ and far(X) = X·r − c⁻. If the
// probe is in the box at τ, then near(entered plane) ≤ τ ≤ far(left plane) on each axis. So the largest of three nears
// and 0 is at most the smallest of three fars and any bound on τ: a box that is exactly met is never lost.
//
// Proof, by counting errors as distances in space, in units of (M + S)·2⁻²³, which is what one operation in
// binary32 may spoil in any rounding mode. Let δᵢ > 0; the other sign is the mirror image.
//  · |δᵢ| is raised to 2⁻⁶⁰ where it is less, or zero of either sign. That moves the probe by at most
//    τ·2⁻⁶⁰ ≤ (M + S)·2⁻⁶⁰: nothing.
//  · s is computed in binary64: off by S·2⁻⁵¹, or by a subnormal; a segment's δ, from a rounded difference, by 2⁻⁵²
//    relative, which moves the probe by (M + S)·2⁻⁵⁰: nothing.
//  · r is 1/δᵢ rounded to binary32. X·r for X/δᵢ and s·r for s/δᵢ: |X|/δᵢ + |s|/δᵢ times 2⁻²³, 1 unit of space over δᵢ.
//  · c± = s·r ± |r|·E is rounded to binary32: 1 unit, and what E adds, which is nothing.
//  · X·r − c is rounded once if fused, twice if not: 2 units, for |X|, |s| ≤ M, S.
// Together 4 units and a little, 2⁻²¹·(M + S); E = 2⁻²⁰·(M + S) + 2⁻¹⁰⁰ is nearly twice that. Nothing overflows:
// 2⁻¹ < |r| ≤ 2⁶⁰ and M, S ≤ 2³⁰, so all results stay below 2⁹²; no zero meets an infinity, there being none.
// What underflows or is flushed is off by 2⁻¹²⁶, below 2⁻¹⁰⁰·|r|.
//
// A probe that the frame cannot hold (S above 2³⁰, or the scale out of range) gets r and c such that it meets every
// box. It then tests every triangle, which is slow and right.
//
// Price: boxes grow by E, a millionth of the distance from the probe's start to the far side of the scene; and they are
// rounded outward to binary32, 2⁻²⁴ of the scene. A scene a million times larger than its triangles gets blunt boxes.
// Compare Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013, who widens the far side by ulps of its t, for boxes and
// rays that are exact in their format; with subtraction before multiplication, errors are relative to t and need no
// frame.
#pragma once

#include <array>

#include "tracer/accel/wide/tree.h"

namespace tribunal {

/// The constants of one probe.
struct WideProbe {
  struct Axis {
    float r, near_c, far_c;
    std::uint32_t near_plane, far_plane;  ///< where these start among the coordinates of WideNode::plane
  };

  WideProbe() = default;
  WideProbe(const Ray& ray, const Frame& frame) : WideProbe(ray.o, ray.d.v, 1, frame) {}
  WideProbe(const Segment& s, const Frame& frame);

  /// A bound on τ that is at least scale·t, for a bound on t.
  float limit_at(double t) const {
    const double x = t * scale;
    return x < 0x1p60 ? static_cast<float>(x * (1 + 0x1p-20) + 0x1p-100) : far_away;
  }

  static constexpr float far_away = 0x1p100F;  ///< no box of the tree is entered at a greater τ

  static constexpr double smallest_component = 0x1p-60, farthest_start = 0x1p30, least_scale = 0x1p-1000;

  static Axis axis(std::uint32_t i, float r, float near_c, float far_c, bool backward) {
    const auto plane = [&](bool upper) { return static_cast<std::uint32_t>((i + (upper ? 3 : 0)) * node_width); };
    return {r, near_c, far_c, plane(backward), plane(!backward)};
  }

  std::array<Axis, 3> axes;
  double scale;  ///< τ = scale·t

 private:
  /// For the probe x = o + t·(growth·d), where d may be off by one rounding.
  WideProbe(const Point3& o, const Point3& d, double growth, const Frame& frame);
  void meet_everything();
};

}  // namespace tribunal
