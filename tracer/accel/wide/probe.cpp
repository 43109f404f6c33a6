#include "tracer/accel/wide/probe.h"

#include <bit>
#include <cmath>

namespace tribunal {
namespace {

/// The three axes at once, in as many registers as that takes.
using Double4 = double __attribute__((vector_size(32)));
using Bits4 = std::int64_t __attribute__((vector_size(32)));
using Float4 = float __attribute__((vector_size(16)));

constexpr std::int64_t sign_bit = INT64_MIN;
constexpr std::uint64_t exponent_bits = 0x7ff0000000000000;

double largest(const Point3& p) { return std::max(std::max(std::fabs(p.x), std::fabs(p.y)), std::fabs(p.z)); }

/// 2^e for a normal x with 2^e ≤ |x| < 2^(e+1); 0 for a subnormal one.
double power_below(double x) { return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & exponent_bits); }

/// 1 / 2^e, both normal.
double inverse_of(double power) {
  return std::bit_cast<double>((std::uint64_t{2046} << 52) - std::bit_cast<std::uint64_t>(power));
}

/// Whether both 2^e and its inverse are normal.
bool is_ordinary(double power) { return power >= WideProbe::least_scale && power <= 1 / WideProbe::least_scale; }

/// Whether the difference of two points may have overflowed; it is then computed from the halved points.
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
  scale = is_ordinary(power) ? frame.unit * power / first * growth : 0;
  if (!(start <= farthest_start) || !is_ordinary(scale)) {
    meet_everything();
    return;
  }
  const double widening = (frame.reach + start) * 0x1p-20 + 0x1p-100, inverse = inverse_of(power);
  const Double4 from{s.x, s.y, s.z, 0}, delta = Double4{brought.x, brought.y, brought.z, 1} * inverse;
  const Bits4 sign = reinterpret_cast<Bits4>(delta) & sign_bit;
  const Double4 magnitude = reinterpret_cast<Double4>(reinterpret_cast<Bits4>(delta) & ~sign_bit);
  const Double4 positive = 1 / (magnitude < smallest_component ? Double4{} + smallest_component : magnitude);
  const Float4 r = __builtin_convertvector(reinterpret_cast<Double4>(reinterpret_cast<Bits4>(positive) | sign), Float4);
  const Double4 c = from * __builtin_convertvector(r, Double4), e = widening * (positive * (1 + 0x1p-23));
  const Float4 near_c = __builtin_convertvector(c + e, Float4), far_c = __builtin_convertvector(c - e, Float4);
  for (std::uint32_t i = 0; i < 3; ++i) {
    axes[i] = axis(i, r[i], near_c[i], far_c[i], sign[i] != 0);
  }
}

void WideProbe::meet_everything() {
  scale = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < 3; ++i) axes[i] = axis(i, 0x1p-50F, 0x1p20F, -0x1p20F, false);
}

}  // namespace tribunal
