#include "tracer/accel/wide/probe.h"

#include <bit>
#include <cmath>

namespace tribunal {
namespace {

constexpr double smallest_component = 0x1p-60, farthest_start = 0x1p30;
constexpr std::uint64_t exponent_bits = 0x7ff0000000000000;

double largest(const Point3& p) { return std::max(std::max(std::fabs(p.x), std::fabs(p.y)), std::fabs(p.z)); }

/// 2^e for a normal x with 2^e ≤ |x| < 2^(e+1); 0 for a subnormal one.
double power_below(double x) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & exponent_bits); }

/// Whether both 2^e and its inverse are normal.
bool is_ordinary(double power) { return power >= 0x1p-1000 && power <= 0x1p1000; }

/// Differences that overflow are made of halves.
bool overflows(const Point3& d) { return !(largest(d) <= 0x1p1000); }

}  // namespace

WideProbe::WideProbe(const Segment& s, const Frame& frame)
    : WideProbe(s.p, overflows(s.q - s.p) ? 0x1p-30 * s.q - 0x1p-30 * s.p : s.q - s.p,
                overflows(s.q - s.p) ? 0x1p30 : 1, frame) {}

WideProbe::WideProbe(const Point3& o, const Point3& d, double growth, const Frame& frame) {
  // A direction far from 1 is brought there first; what its small components lose is nothing, as the proof says.
  const double size = largest(d);
  const double first = size < 0x1p-900 ? 0x1p120 : size > 0x1p900 ? 0x1p-120 : 1;
  const Point3 brought = first * d;
  const double power = power_below(largest(brought));
  const Point3 s = frame.unit * (o - frame.centre);
  const double start = largest(s);
  scale_ = is_ordinary(power) ? frame.unit * power / first * growth : 0;
  if (!(start <= farthest_start) || !is_ordinary(scale_)) {
    meet_everything();
    return;
  }
  const double widening = (frame.reach + start) * 0x1p-20 + 0x1p-100;
  const double least = smallest_component * power, steepest = 1 / smallest_component;
  for (int i = 0; i < 3; ++i) {
    // 1/δ as (1/d)·power: the division need not wait for the largest component.
    const double inverse = 1 / std::fabs(brought[i]) * power;
    const double bounded = std::fabs(brought[i]) > least ? inverse : steepest;
    const float r = static_cast<float>(std::copysign(bounded, brought[i]));
    const double c = s[i] * static_cast<double>(r), e = widening * std::fabs(static_cast<double>(r));
    const std::uint32_t axis = static_cast<std::uint32_t>(i), backward = std::signbit(brought[i]) ? 3 : 0;
    axes[axis] = {r, static_cast<float>(c + e), static_cast<float>(c - e), axis + backward, axis + 3 - backward};
  }
}

void WideProbe::meet_everything() {
  scale_ = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < 3; ++i) axes[i] = {0x1p-50F, 0x1p20F, -0x1p20F, i, i + 3};
}

}  // namespace tribunal
