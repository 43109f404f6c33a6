// The box test against exact arithmetic: it never loses a probe that meets the closed box.
#include "tracer/accel/wide/box.h"

#include <gmpxx.h>

#include <array>
#include <vector>

#include "tests/tracer/support.h"

namespace tribunal {
namespace {

using testing::Random;

/// The exact interval of parameters at which a probe is in the box; empty if first > last.
struct ExactSpan {
  mpq_class first = 0, last;
  bool bounded = false, empty = false;

  void cut(const mpq_class& in, const mpq_class& out) {
    if (in > first) first = in;
    if (!bounded || out < last) last = out;
    bounded = true;
  }
  bool meets() const { return !empty && (!bounded || first <= last); }
};

ExactSpan exact_span(const Point3& o, const std::array<mpq_class, 3>& d, bool segment, const Box& b) {
  ExactSpan s;
  if (segment) s.cut(0, 1);
  for (int i = 0; i < 3; ++i) {
    const mpq_class from(o[i]), lo(b.lo[i]), hi(b.hi[i]);
    if (d[static_cast<std::size_t>(i)] == 0) {
      s.empty |= from < lo || from > hi;
      continue;
    }
    mpq_class in = (lo - from) / d[static_cast<std::size_t>(i)], out = (hi - from) / d[static_cast<std::size_t>(i)];
    if (in > out) std::swap(in, out);
    s.cut(in, out);
  }
  return s;
}

ExactSpan exact_span(const Ray& r, const Box& b) {
  return exact_span(r.o, {mpq_class(r.d.v.x), mpq_class(r.d.v.y), mpq_class(r.d.v.z)}, false, b);
}

ExactSpan exact_span(const Segment& s, const Box& b) {
  const auto d = [&](int i) { return mpq_class(mpq_class(s.q[i]) - mpq_class(s.p[i])); };
  return exact_span(s.p, {d(0), d(1), d(2)}, true, b);
}

/// Coordinates on which slab tests break: zeros of both signs, ends of the range, subnormals, neighbours, big offsets.
const std::vector<double> nasty = {0.0,
                                   -0.0,
                                   1.0,
                                   -1.0,
                                   0x1p-1074,
                                   -0x1p-1074,
                                   0x1p-1073,
                                   0x1p-1022,
                                   -0x1p-1022,
                                   1.0 / 3,
                                   above(1.0),
                                   below(1.0),
                                   0x1p40,
                                   above(0x1p40),
                                   -0x1p40,
                                   0x1p1023,
                                   -0x1p1023,
                                   std::numeric_limits<double>::max(),
                                   -std::numeric_limits<double>::max(),
                                   0.1,
                                   0x1p-600,
                                   0x1p600,
                                   7,
                                   -5.5};

double nasty_number(Random& random) { return nasty[random.below(nasty.size())]; }

Point3 nasty_point(Random& random) {
  const double x = nasty_number(random);
  const double y = nasty_number(random);
  const double z = nasty_number(random);
  return {x, y, z};
}

Box nasty_box(Random& random) {
  Box b;
  b.add(nasty_point(random));
  b.add(nasty_point(random));
  return b;
}

template <class P>
void expect_covers(const P& probe, const Box& box, int& met, int& kept) {
  const Span span = BoxProbe(probe).span(box);
  const ExactSpan exact = exact_span(probe, box);
  ASSERT_FALSE(std::isnan(span.first) || std::isnan(span.last));
  kept += !span.empty();
  if (!exact.meets()) return;
  ++met;
  ASSERT_FALSE(span.empty()) << "lost: o = " << source(probe).x << "," << source(probe).y << "," << source(probe).z;
  ASSERT_LE(mpq_class(span.first), exact.first);
  if (exact.bounded && std::isfinite(span.last)) {
    ASSERT_GE(mpq_class(span.last), exact.last);
  }
}

TEST(BoxProbe, NeverLosesANastyRayThatMeetsTheBox) {
  Random random(1);
  int met = 0, kept = 0;
  for (int i = 0; i < 200000; ++i) {
    const Point3 o = nasty_point(random);
    const Ray ray{o, {nasty_point(random)}};
    ASSERT_NO_FATAL_FAILURE(expect_covers(ray, nasty_box(random), met, kept));
  }
  EXPECT_GT(met, 10000);
  EXPECT_LT(kept, 100000) << "the test keeps almost everything";
}

TEST(BoxProbe, NeverLosesANastySegmentThatMeetsTheBox) {
  Random random(2);
  int met = 0, kept = 0;
  for (int i = 0; i < 200000; ++i) {
    const Point3 p = nasty_point(random);
    const Segment segment{p, nasty_point(random)};
    ASSERT_NO_FATAL_FAILURE(expect_covers(segment, nasty_box(random), met, kept));
  }
  EXPECT_GT(met, 10000);
  EXPECT_LT(kept, 100000) << "the test keeps almost everything";
}

/// The textbook slab test, which multiplies by 1/d. For a ray in a face of the box, 0·∞ is a NaN, which compares
/// false, and the ray is lost.
bool textbook_slabs_meet(const Ray& r, const Box& b) {
  double first = 0, last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const double inverse = 1 / r.d.v[i];
    double in = (b.lo[i] - r.o[i]) * inverse, out = (b.hi[i] - r.o[i]) * inverse;
    if (inverse < 0) std::swap(in, out);
    if (!(in <= last && first <= out)) return false;
    first = std::max(first, in);
    last = std::min(last, out);
  }
  return first <= last;
}

/// A planted bug: the corpus above would not let it pass.
TEST(BoxProbe, TheCorpusCatchesATextbookSlabTest) {
  Random random(1);
  int lost = 0;
  for (int i = 0; i < 2000; ++i) {
    const Point3 o = nasty_point(random);
    const Ray ray{o, {nasty_point(random)}};
    const Box box = nasty_box(random);
    lost += exact_span(ray, box).meets() && !textbook_slabs_meet(ray, box);
  }
  EXPECT_GT(lost, 0);
}

/// One axis of a ray that reaches `corner` at t exactly, though neither t·d nor the difference corner − o is a binary64
/// number: t·d has up to 77 bits, and o takes the lowest 24 away.
struct AimedAxis {
  double o, d, corner;
};

AimedAxis aim(Random& random, std::int64_t t) {
  const std::int64_t d = static_cast<std::int64_t>(random.below(1 << 23)) + (1 << 23);
  const __int128 way = static_cast<__int128>(t) * d;
  const std::int64_t o = -static_cast<std::int64_t>(way % (1 << 24));
  const double mirror = random.below(2) == 0 ? 1 : -1;
  return {mirror * static_cast<double>(o), mirror * static_cast<double>(d), mirror * static_cast<double>(way + o)};
}

/// Rays that touch the box in exactly one corner, where they leave one slab as they enter the others: a test that
/// rounds to nearest loses many.
TEST(BoxProbe, KeepsRaysThroughCorners) {
  Random random(3);
  int met = 0, kept = 0;
  for (int i = 0; i < 100000; ++i) {
    const std::int64_t t = static_cast<std::int64_t>(random.next() >> 12 | std::uint64_t{1} << 52);
    const AimedAxis axes[] = {aim(random, t), aim(random, t), aim(random, t)};
    const double scale = std::ldexp(1.0, random.within(-1000, 800));
    Ray ray;
    Box box;
    Point3 corner, opposite;
    for (int k = 0; k < 3; ++k) {
      const AimedAxis& a = axes[k];
      ray.o[k] = scale * a.o;
      ray.d.v[k] = scale * a.d;
      corner[k] = scale * a.corner;
      opposite[k] = corner[k] + (k == 0 ? -0.25 : 0.25) * ray.d.v[k];  // behind in x, ahead in y and z
    }
    box.add(corner);
    box.add(opposite);
    ASSERT_NO_FATAL_FAILURE(expect_covers(ray, box, met, kept));
  }
  EXPECT_EQ(met, 100000);
}

TEST(BoxProbe, IsTightOnOrdinaryMisses) {
  Random random(4);
  int wrong = 0;
  for (int i = 0; i < 100000; ++i) {
    const Point3 o = random.point(4);
    const Ray ray{o, {random.point(1)}};
    Box box;
    box.add(random.point(2));
    box.add(random.point(2));
    wrong += !BoxProbe(ray).span(box).empty() != exact_span(ray, box).meets();
  }
  EXPECT_EQ(wrong, 0) << "a margin of a few units roundoff shows on none of these";
}

TEST(Neighbours, StepOverEverything) {
  for (const double x : nasty) {
    EXPECT_EQ(above(x), std::nextafter(x, std::numeric_limits<double>::infinity()));
    EXPECT_EQ(below(x), std::nextafter(x, -std::numeric_limits<double>::infinity()));
  }
  EXPECT_EQ(below(std::numeric_limits<double>::infinity()), std::numeric_limits<double>::max());
}

}  // namespace
}  // namespace tribunal
