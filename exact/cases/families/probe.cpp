#include "exact/cases/families/probe.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "exact/cases/families/shapes.h"

namespace tribunal {
namespace {

constexpr int usual_scale = 12;

/// The exponents of the last and of the first significant bit.
int lowest_exponent(const Scaled& x) { return x.e + std::countr_zero(static_cast<std::uint64_t>(x.m)); }
int highest_exponent(const Scaled& x) {
  return x.e + static_cast<int>(std::bit_width(static_cast<std::uint64_t>(std::llabs(x.m)))) - 1;
}

bool is_zero(const std::array<Scaled, 3>& d) {
  return std::ranges::all_of(d, [](const Scaled& x) { return x.m == 0; });
}

double draw_zero(Draw& draw) { return draw.below(2) == 0 ? 0.0 : -0.0; }

Direction draw_nowhere(Draw& draw) {
  Direction d;
  for (int axis = 0; axis < 3; ++axis) d.v[axis] = draw_zero(draw);
  return d;
}

/// Some of the exponents: those near 0; or, one time in eight each, all of them, the least ones or the greatest ones.
ExponentRange draw_range(const ExponentRange& all, Format format, Draw& draw) {
  const int near_end = digits_of(format) + usual_scale;
  const ExponentRange usual{std::max(all.lo, -usual_scale), std::min(all.hi, usual_scale)};
  switch (draw.below(8)) {
    case 0:
      return all;
    case 1:
      return {all.lo, std::min(all.hi, all.lo + near_end)};
    case 2:
      return {std::max(all.lo, all.hi - near_end), all.hi};
    default:
      return usual.lo <= usual.hi ? usual : all;
  }
}

Point3 fitted(const Point3& p, Format format) { return in_format(p, format); }
Segment fitted(const Segment& s, Format format) { return {fitted(s.p, format), fitted(s.q, format)}; }
Ray fitted(const Ray& r, Format format) { return {fitted(r.o, format), {fitted(r.d.v, format)}}; }
Triangle fitted(const Triangle& t, Format format) {
  return {fitted(t.a, format), fitted(t.b, format), fitted(t.c, format)};
}

}  // namespace

/// Halves where the difference is too large for a double: such numbers lose no bit by halving.
Scaled difference(double from, double to, Format format) {
  const double whole = to - from;
  const bool overflows = !std::isfinite(whole);
  int e = 0;
  const double fraction = std::frexp(overflows ? to / 2 - from / 2 : whole, &e);
  const int digits = digits_of(format);
  return {std::llrint(times_power_of_two(fraction, digits)), e - digits + (overflows ? 1 : 0)};
}

ExponentRange exact_exponents(const std::array<Scaled, 3>& d, Format format) {
  int lowest = std::numeric_limits<int>::max(), highest = std::numeric_limits<int>::min();
  for (const Scaled& x : d) {
    if (x.m == 0) continue;
    lowest = std::min(lowest, lowest_exponent(x));
    highest = std::max(highest, highest_exponent(x));
  }
  return {least_exponent(format) - lowest, largest_exponent(format) - highest};
}

Direction scaled(const std::array<Scaled, 3>& d, int e) {
  const auto at = [&](std::size_t axis) { return times_power_of_two(static_cast<double>(d[axis].m), d[axis].e + e); };
  return {{at(0), at(1), at(2)}};
}

Direction draw_direction(const std::array<Scaled, 3>& d, Format format, Draw& draw) {
  if (is_zero(d)) return draw_nowhere(draw);
  const ExponentRange all = exact_exponents(d, format);
  if (all.lo > all.hi) throw std::logic_error("a direction wider than its format");
  const ExponentRange range = draw_range(all, format, draw);
  return scaled(d, static_cast<int>(draw.between(range.lo, range.hi)));
}

Probe draw_probe(bool is_ray, const Segment& s, Format format, Draw& draw) {
  Segment ends = fitted(s, format);
  if (draw.below(2) == 1) std::swap(ends.p, ends.q);
  if (!is_ray) return ends;
  if (draw.below(16) == 0) return Ray{ends.p, draw_nowhere(draw)};
  std::array<Scaled, 3> d;
  for (int axis = 0; axis < 3; ++axis) {
    d[static_cast<std::size_t>(axis)] = difference(ends.p[axis], ends.q[axis], format);
  }
  return Ray{ends.p, draw_direction(d, format, draw)};
}

Trial unclassified(Format format, std::size_t level, const Probe& probe, const Triangle& t, Draw& draw) {
  const Probe placed = std::visit([&](const auto& p) -> Probe { return fitted(p, format); }, probe);
  return {.query = {placed, in_random_order(fitted(t, format), draw)},
          .format = format,
          .class_id = 0,
          .level = static_cast<std::uint16_t>(level)};
}

Triangle in_random_order(Triangle t, Draw& draw) {
  const std::uint64_t turn = draw.below(6);
  if (turn % 2 == 1) std::swap(t.a, t.b);
  if (turn / 2 == 1) std::swap(t.a, t.c);
  if (turn / 2 == 2) std::swap(t.b, t.c);
  return t;
}

}  // namespace tribunal
