// The one place where the probe of a generated case becomes a segment or a ray.
#pragma once

#include <array>
#include <cstdint>

#include "exact/cases/families/draw.h"
#include "exact/cases/families/family.h"

namespace tribunal {

/// The rule of the families that aim at no class: even cases ask a segment, odd cases a ray, and each level of the
/// stress axis takes one of either before the next level's turn.
struct Turn {
  bool is_ray;
  std::size_t level;
};

constexpr Turn turn_of(std::uint64_t k, std::size_t levels) { return {k % 2 == 1, k / 2 % levels}; }

/// The number m·2^e, with no limit to e. |m| has no more bits than the format's significand.
struct Scaled {
  std::int64_t m;
  int e;
};

/// A coordinate of a direction, the difference `to` − `from` rounded to the format's significand, whatever its size.
Scaled difference(double from, double to, Format format);

/// The exponents e for which d·2^e is exact in the format.
struct ExponentRange {
  int lo, hi;
};

ExponentRange exact_exponents(const std::array<Scaled, 3>& d, Format format);

/// d·2^e, exact.
Direction scaled(const std::array<Scaled, 3>& d, int e);

/// d times a power of two, so that the direction has a size of its own. Five times in eight the power is within 2^±12;
/// once it is any for which the product is exact in the format; once each it is one of the least or of the greatest of
/// these, where products with a geometry of moderate size underflow or overflow.
Direction draw_direction(const std::array<Scaled, 3>& d, Format format, Draw& draw);

/// The segment, one way or the other; or the ray from one of its ends toward the other, with a direction of its own
/// size, which one time in sixteen is zero. The ends are rounded to the format first.
Probe draw_probe(bool is_ray, const Segment& s, Format format, Draw& draw);

/// A trial whose class only an oracle can say: operands rounded to the format, vertices in a random order.
Trial unclassified(Format format, std::size_t level, const Probe& probe, const Triangle& t, Draw& draw);

/// The vertices in a random order: keeps the class.
Triangle in_random_order(Triangle t, Draw& draw);

}  // namespace tribunal
