// What the programs share that kill mutants.
#pragma once

#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "core/operands.h"

namespace tribunal::killing {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Ends the program, which kills the mutant, unless this holds.
inline void require(bool holds, const char* what) {
  if (holds) return;
  std::printf("killed: %s\n", what);
  std::exit(1);
}

/// Numbers and operands at random, always the same ones.
class Draw {
 public:
  std::uint64_t bits() {
    state_ = state_ * 6364136223846793005 + 1442695040888963407;
    const std::uint64_t high = state_ >> 32;
    state_ = state_ * 6364136223846793005 + 1442695040888963407;
    return high << 32 | state_ >> 32;
  }
  int below(int n) { return static_cast<int>((bits() >> 20) % static_cast<std::uint64_t>(n)); }
  int within(int least, int greatest) { return least + below(greatest - least + 1); }

  Point3 point(int reach) {
    const int x = within(-reach, reach), y = within(-reach, reach), z = within(-reach, reach);
    return Point3(x, y, z);
  }
  Triangle triangle(int reach) {
    const Point3 a = point(reach), b = point(reach), c = point(reach);
    return {a, b, c};
  }

  /// A number of the kind: small integers; integers of 19, 40 and 60 bits; everyday numbers; exponents up to ±300, and
  /// of the whole range; subnormal numbers; powers of two of the whole range, and next to them.
  static constexpr int kinds = 9;
  double number(int kind) {
    if (below(8) == 0) return below(2) == 0 ? 0.0 : -0.0;
    const double sign = below(2) == 0 ? -1 : 1;
    const double significand = static_cast<double>(bits() >> 11) * 0x1p-53 + 0.5;
    switch (kind) {
      case 0:
        return within(-3, 3);
      case 1:
        return within(-(1 << 18), 1 << 18);
      case 2:
        return sign * static_cast<double>(bits() >> 24);
      case 3:
        return sign * static_cast<double>(bits() >> 11) * 128;
      case 4:
        return sign * std::ldexp(significand, within(-8, 8));
      case 5:
        return sign * std::ldexp(significand, within(-300, 300));
      case 6:
        return sign * std::ldexp(significand, within(-1074, 1023));
      case 7:
        return sign * std::bit_cast<double>(bits() >> within(12, 62));
      default: {
        const double power = std::ldexp(1.0, within(-1074, 1023));
        return sign * (below(3) == 0 ? std::nextafter(power, infinity) : power);
      }
    }
  }
  Point3 point_of(int kind) {
    const double x = number(kind), y = number(kind), z = number(kind);
    return Point3(x, y, z);
  }

 private:
  std::uint64_t state_ = 1;
};

/// Five points and a direction's parameter: often degenerate, or nearly so.
struct Five {
  Triangle t;
  Point3 p, q;

  bool finite() const { return is_finite(t) && is_finite(p) && is_finite(q); }
};

inline Five drawn(Draw& draw, int kind, int degeneracy) {
  Five f{};
  for (Point3* x : {&f.t.a, &f.t.b, &f.t.c, &f.p, &f.q}) *x = draw.point_of(kind);
  const auto mix = [&](const Point3& u, const Point3& v) { return 0.5 * u + 0.5 * v; };
  switch (degeneracy) {
    case 1:
      f.t.c = mix(f.t.a, f.t.b);
      break;
    case 2:
      f.q = mix(f.t.a, mix(f.t.b, f.t.c));
      break;
    case 3:
      f.p = mix(f.t.a, f.t.b);
      break;
    case 4:
      f.q = f.p;
      break;
    case 5:
      f.p = f.t.a;
      break;
    case 6:
      f.p.z = f.q.z = f.t.a.z = f.t.b.z = f.t.c.z;
      break;
    case 7:
      f.q = mix(f.t.a, mix(f.t.b, f.t.c)), f.q.x = std::nextafter(f.q.x, f.t.a.y);
      break;
    case 8:
      f.q = f.p + (f.t.b - f.t.a) + (f.t.c - f.t.a);
      break;
    case 9:
      f.t.b = f.t.a;
      break;
    default:
      break;
  }
  return f;
}
inline constexpr int degeneracies = 10;

}  // namespace tribunal::killing
