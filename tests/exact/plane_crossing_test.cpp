// The bounds of the polygon filter: proved by Gappa, derived again from the source lines by an error-tracking number
// type, and tried in a small floating-point format.
#include "exact/filtered/plane_crossing.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "exact/filtered/filter.h"
#include "tests/exact/proofs.h"

namespace tribunal {

namespace {

/// What is left for underflow, which crossing_range.g shows to be far less.
constexpr double room = rounding / 8;

TEST(PlaneCrossing, GappaProvesTheBounds) {
  const auto proved = proved_by("plane_crossing.g");
  const double height = proved.at("height - HEIGHT"), point = proved.at("point - POINT"),
               reached = proved.at("reached - REACHED"), side = proved.at("side - SIDE");
  const double rounded = 1 + 8 * rounding;  // the bounds themselves are computed
  EXPECT_LT((height + room) * rounded, crossing_bounds.height);
  EXPECT_NEAR(height / rounding, 5.75, 1e-3);
  // `ahead` is the rounded difference of `reached` and `point`: what they are off by, and a unit of 3/4 and of 3/2.
  EXPECT_LT((reached + 0.7502 * rounding + room) * rounded, crossing_bounds.vertex);
  EXPECT_LT((point + 1.5002 * rounding + room) * rounded, crossing_bounds.vertex);
  EXPECT_LT((side + room) * rounded, crossing_bounds.edge);
  EXPECT_NEAR(side / rounding, 4 * 18 + 24, 1e-2);
}

/// Checks the facts that the Gappa script assumes.
TEST(PlaneCrossing, TheScriptsHypothesesArePlaneFacts) {
  EXPECT_LT(normal_scale * proved_by("area.g").at("area - exact") * (1 + 2 * rounding), 2.2206e-16);
  EXPECT_LT(proved_by("plane_crossing.g").at("height - HEIGHT"), 1.277e-15);
  EXPECT_EQ(crossing_bounds.vertex, 18 * rounding);
}

TEST(PlaneCrossing, GappaProvesTheRange) {
  const auto proved = proved_by("crossing_range.g");
  for (const char* relative : {"r_normal", "r_height", "r_arm", "r_vertex"}) {
    EXPECT_LT(proved.at(relative), rounding * 0x1p-100) << relative;
  }
  for (const char* absolute : {"e_height", "e_ahead", "e_side"}) EXPECT_LT(proved.at(absolute), crossing_bounds.tiny);
  for (const char* largest : {"m_height", "m_side"}) EXPECT_LT(proved.at(largest), 0x1.fp1023) << largest;
  EXPECT_EQ(crossing_bounds.tiny, 0x1p-800);
  EXPECT_EQ(crossing_bounds.huge, 0x1p850);
}

/// Ends whose largest coordinates are w and z, each difference rounded once.
Vec3<Twin<Tracked>> tracked_ends(double w, double z) {
  const Twin<Tracked> both{{w, w * rounding}, {z, z * rounding}};
  return {both, both, both};
}

Vec3<Twin<Tracked>> tracked_normal() {
  const Tracked n(2 * normal_scale, 8 * rounding * normal_scale);
  return beside(Vec3<Tracked>{n, n, n}, Vec3<Tracked>{n, n, n});
}

template <class P>
PlaneCrossing<Tracked> tracked_crossing(double w, double z) {
  const Vec3<Twin<Tracked>> ends = tracked_ends(w, z);
  return plane_crossing<P>(dot(tracked_normal(), ends), Vec2<Twin<Tracked>>{ends.x, ends.y});
}

/// What the shipped formulas are off by, in units, over what the bounds are multiplied by.
struct Units {
  double vertex, edge;
};

template <class P>
Units units(double w, double z, double extent) {
  const PlaneCrossing<Tracked> x = tracked_crossing<P>(w, z);
  const Tracked f(extent, extent * rounding);
  const double range = crossing_range<P>(Twin<double>{w, z}, extent);
  return {x.ahead_v(f).error / range / rounding, edge_side(x, {f, f}, {f, f}).error / range / extent / rounding};
}

TEST(PlaneCrossing, TheTrackedErrorsStayWithinTheBounds) {
  const Twin<Tracked> h = dot(tracked_normal(), tracked_ends(1, 1));
  EXPECT_NEAR(h.first.error / rounding, 5.75, 1e-9);
  double worst_vertex = 0, worst_edge = 0;
  for (int a = -40; a <= 40; a += 4) {
    for (int b = -40; b <= 40; b += 4) {
      for (const Units& u :
           {units<Segment>(std::ldexp(1, a), std::ldexp(1, b), 1), units<Ray>(std::ldexp(1, a), std::ldexp(1, b), 1)}) {
        worst_vertex = std::max(worst_vertex, u.vertex);
        worst_edge = std::max(worst_edge, u.edge);
      }
    }
  }
  EXPECT_NEAR(worst_vertex, 17.5, 1e-6);
  EXPECT_NEAR(worst_edge, 94, 1e-6);
  EXPECT_LT(worst_vertex * rounding, crossing_bounds.vertex);
  EXPECT_LT(worst_edge * rounding, crossing_bounds.edge);
}

/// Bits of significand of the small format; coordinates have as many.
constexpr int bits = 10;
using Small = Toy<bits>;

/// A plane by three points, a probe from p to q, and an edge from f to g as it is projected.
template <class N>
struct Figure {
  Vec3<N> o, b, c, p, q, f, g;

  template <class M>
  Figure<M> in() const {
    const auto as = [](const Vec3<N>& v) { return Vec3<M>{M(v.x), M(v.y), M(v.z)}; };
    return {as(o), as(b), as(c), as(p), as(q), as(f), as(g)};
  }
};

/// What the filter computes of it, in N.
template <class N>
struct Computed {
  Vec3<Twin<N>> ends;
  Twin<N> heights;
  PlaneCrossing<N> crossing;
  Vec2<N> f, g;

  Computed(const Figure<N>& v, const N& scale)
      : ends(beside(v.p - v.o, v.q - v.o)),
        heights(dot(normal(v, scale), ends)),
        crossing(plane_crossing<Segment>(heights, Vec2<Twin<N>>{ends.x, ends.y})),
        f(flat(v.f - v.o)),
        g(flat(v.g - v.o)) {}

  N ahead() const { return crossing.ahead_v(f.v); }
  N side() const { return edge_side(crossing, f, g); }

  static Vec2<N> flat(const Vec3<N>& v) { return {v.x, v.y}; }
  static Vec3<Twin<N>> normal(const Figure<N>& v, const N& scale) {
    const Vec3<N> n = cross(v.b - v.o, v.c - v.o);
    const Vec3<N> scaled{n.x * scale, n.y * scale, n.z * scale};
    return beside(scaled, scaled);
  }
};

/// Draws figures with random integers, with the edge near the crossing and far from it.
class Figures {
 public:
  Figure<double> next() {
    Figure<double> v{point(), point(), point(), point(), point(), {}, {}};
    const Computed<double> c(v, 1);
    const double x = v.o.x + c.crossing.point.u / c.crossing.den, y = v.o.y + c.crossing.point.v / c.crossing.den;
    const double along_u = coordinate(), along_v = coordinate(), off = std::ldexp(coordinate(), -(++drawn_ % bits));
    v.f = {std::round(x + along_u / 2 + off), std::round(y + along_v / 2), 0};
    v.g = {std::round(x - along_u / 2 + off), std::round(y - along_v / 2), 0};
    return std::abs(x) < full / 2 && std::abs(y) < full / 2 ? v : next();
  }

 private:
  static constexpr double full = 1 << bits;

  double coordinate() {
    state_ = state_ * 6364136223846793005U + 1442695040888963407U;
    const auto magnitude = static_cast<double>(state_ >> 40 & ((1 << bits) - 1));
    return (state_ >> 33 & 1) != 0 ? magnitude : -magnitude;
  }
  Vec3<double> point() {
    const double x = coordinate(), y = coordinate();
    return {x, y, coordinate()};
  }

  std::uint64_t state_ = 5;
  int drawn_ = 0;
};

double reach(const Vec3<Small>& v) { return std::max({std::abs(v.x.x), std::abs(v.y.x), std::abs(v.z.x)}); }

/// The scale of the normal, computed as in the preparation of a polygon.
double scale_of(const Figure<Small>& v) {
  const Vec3<Small> b = v.b - v.o, c = v.c - v.o;
  const double x = std::max(std::abs(b.x.x), std::abs(c.x.x)), y = std::max(std::abs(b.y.x), std::abs(c.y.x)),
               z = std::max(std::abs(b.z.x), std::abs(c.z.x));
  return std::ldexp(normal_scale, -1 - std::ilogb(std::max({x * y, y * z, z * x})));
}

struct Judged {
  Outcome heights, vertices, edges;
};

/// Certain signs of heights, of vertices and of edges, with bounds too small by a divisor.
Judged judge_figures(double divisor, int count) {
  // A unit of the small format, and a quarter for the terms of higher order.
  const auto in_units = [=](double bound) { return bound / rounding * std::ldexp(1.25, -bits) / divisor; };
  Figures draw;
  Judged judged;
  const auto add = [](Outcome& o, const Small& x, double bound, long double exact) {
    o.add(sign_beyond(x.x, bound), exact);
  };
  for (int k = 0; k < count; ++k) {
    const Figure<double> v = draw.next();
    const Figure<Small> toy = v.in<Small>();
    const double scale = scale_of(toy);
    const Computed<Small> small(toy, Small(scale));
    const Computed<long double> exact(v.in<long double>(), scale);
    const double w = reach(toy.p - toy.o), z = reach(toy.q - toy.o),
                 extent = std::max(reach(toy.f - toy.o), reach(toy.g - toy.o)),
                 range = crossing_range<Segment>(Twin<double>{w, z}, extent);
    add(judged.heights, first(small.heights), in_units(crossing_bounds.height) * w, first(exact.heights));
    add(judged.heights, second(small.heights), in_units(crossing_bounds.height) * z, second(exact.heights));
    if (sign_of(first(exact.heights)) * sign_of(second(exact.heights)) != Sign::negative) continue;
    add(judged.vertices, small.ahead(), in_units(crossing_bounds.vertex) * range, exact.ahead());
    add(judged.edges, small.side(), in_units(crossing_bounds.edge) * range * extent, exact.side());
  }
  return judged;
}

TEST(PlaneCrossing, NoCertainSignIsWrongInASmallFormat) {
  const Judged j = judge_figures(1, 1'000'000);
  for (const Outcome& o : {j.heights, j.vertices, j.edges}) {
    EXPECT_EQ(o.wrong, 0U);
    EXPECT_GT(o.certain, 100U);
    EXPECT_GT(o.undecided, 1000U);
  }
}

/// The bounds are for the worst case, and far from what integers at random come to: only the proofs say how tight.
TEST(PlaneCrossing, BoundsTooSmallGiveWrongSigns) {
  EXPECT_GT(judge_figures(128, 1'000'000).heights.wrong, 0U);
  EXPECT_GT(judge_figures(512, 1'000'000).vertices.wrong, 0U);
  EXPECT_GT(judge_figures(1024, 1'000'000).edges.wrong, 0U);
}

}  // namespace
}  // namespace tribunal
