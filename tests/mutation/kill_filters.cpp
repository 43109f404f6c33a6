// Kills mutants of the filters: returns 0 iff they say what their formulas say, abstain exactly where their bounds say
// so, and are never wrong. The formulas are templates: in int64, where small integers are exact, a value and its bound
// are compared with ones worked out here by other formulas. In double they are held against the signs of integers.
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>

#include "core/segura_feito.h"
#include "exact/filtered/filter.h"
#include "exact/filtered/filtered.h"
#include "exact/filtered/term_filter.h"
#include "exact/filtered/within_filter.h"
#include "tests/mutation/kill.h"

using namespace tribunal;
using namespace tribunal::detail;
using namespace tribunal::killing;

namespace {

using N = std::int64_t;
using Constants = FilterConstants<N>;
using MaybeSign = std::optional<Sign>;
const FormulaKernel<N> k;

constexpr double inf = infinity, nan = not_a_number;

N abs_of(N x) { return x < 0 ? -x : x; }
N most(N a, N b) { return a < b ? b : a; }

/// The sign of a value that exceeds its bound.
MaybeSign beyond(N value, N bound) {
  if (abs_of(value) <= bound) return std::nullopt;
  return value < 0 ? Sign::negative : Sign::positive;
}

/// The determinant by Sarrus' rule, and its terms' magnitudes.
struct Sarrus {
  Sarrus(const Vec3<N>& u, const Vec3<N>& v, const Vec3<N>& w) {
    const N plus[] = {u.x * v.y * w.z, u.y * v.z * w.x, u.z * v.x * w.y};
    const N minus[] = {u.z * v.y * w.x, u.x * v.z * w.y, u.y * v.x * w.z};
    for (int i = 0; i < 3; ++i) value += plus[i] - minus[i], terms += abs_of(plus[i]) + abs_of(minus[i]);
  }
  N value = 0, terms = 0;
};

Vec3<N> lifted(const Point3& p) { return {static_cast<N>(p.x), static_cast<N>(p.y), static_cast<N>(p.z)}; }
Vec3<N> from(const Point3& a, const Point3& b) { return lifted(b) - lifted(a); }

/// The largest magnitude on each axis.
template <class... V>
Vec3<N> greatest(const V&... v) {
  Vec3<N> m{0, 0, 0};
  for (const Vec3<N>& u : {v...}) m = {most(m.x, abs_of(u.x)), most(m.y, abs_of(u.y)), most(m.z, abs_of(u.z))};
  return m;
}

bool all_below(const Vec3<N>& m, N huge) { return m.x < huge && m.y < huge && m.z < huge; }

void small_functions() {
  for (const double a : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
    for (const double b : {-2.0, -1.0, 0.0, 1.0, 2.0}) {
      require(larger(a, b) == (a > b ? a : b) && smaller(a, b) == (a < b ? a : b), "larger and smaller");
      require(larger_magnitude(a, b) == larger(a < 0 ? -a : a, b < 0 ? -b : b), "the larger magnitude");
    }
    const N n = static_cast<N>(a);
    require(magnitude(n) == abs_of(n) && magnitude(a) == static_cast<double>(abs_of(n)), "magnitude");
    require(unit_with_sign_of(n) == (n < 0 ? -1 : 1) && unit_with_sign_of(a) == (a < 0 ? -1 : 1), "unit");
  }
  require(unit_with_sign_of(-0.0) == -1 && !(larger(nan, 1.0) != 1) && !(smaller(nan, 1.0) != 1), "zero and NaN");
  require(sign_beyond(nan, 1.0) == std::nullopt && sign_beyond(1.0, nan) == std::nullopt, "NaN is not certain");
  for (N value = -3; value <= 3; ++value) {
    for (N bound = 0; bound <= 3; ++bound) require(sign_beyond(value, bound) == beyond(value, bound), "sign beyond");
  }
}

/// The constants are those that the proofs are about.
void constants() {
  const auto is = [](const FilterConstants<double>& c, double units, double tiny, double huge) {
    return c.k == units * 0x1p-52 && c.tiny == tiny && c.huge == huge;
  };
  require(is(volume_filter, 47, 0x1p-700, 0x1p150) && is(area_filter, 9, 0x1p-850, 0x1p150), "volume, area");
  require(is(order_filter, 1250, 0x1p-500, 0x1p100), "order");
  require(is(volume_terms_filter, 9, 0x1p-700, 0x1p150) && is(order_terms_filter, 21, 0x1p-500, 0x1p100), "terms");
  require(is(side_terms_filter, 11, 0x1p-500, 0x1p150), "side");
  require(is(pair_filter<Segment>, 170, 0x1p-700, 0x1p150) && pair_filter<Segment>.direction == 0, "segments");
  require(is(pair_filter<Ray>, 170, 0x1p-400, 0x1p150) && pair_filter<Ray>.direction == 0x1p-150, "rays");
}

/// X·Y·Z times k and tiny; K·(X·Y·Z)² of an order.
N bound_of(const Vec3<N>& m, const Constants& c) { return c.k * m.x * m.y * m.z + c.tiny; }

constexpr Constants loose[] = {{0, 0, 1000}, {1, 0, 1000}, {0, 7, 1000}, {1, 3, 9}, {0, 0, 6}};

void volumes(Draw& draw, const Constants& c) {
  const Triangle t = draw.triangle(5);
  const Point3 x = draw.point(5);
  const Vec3<N> u = from(t.a, t.b), v = from(t.a, t.c), w = from(t.a, x), d = lifted(x);
  const Sarrus point(u, v, w), direction(u, v, d);
  const Vec3<N> m = greatest(u, v, w), n = greatest(u, v, d);
  const MaybeSign sign = all_below(m, c.huge) ? beyond(point.value, bound_of(m, c)) : std::nullopt;
  require(filter_volume(u, v, w, c) == sign && filter_orient3d<N>(t.a, t.b, t.c, x, c) == sign, "volume");
  const MaybeSign toward = all_below(n, c.huge) ? beyond(direction.value, bound_of(n, c)) : std::nullopt;
  require(filter_orient3d<N>(t.a, t.b, t.c, Direction{x}, c) == toward, "volume of a direction");
  const MaybeSign by_terms = all_below(m, c.huge) ? beyond(point.value, c.k * point.terms + c.tiny) : std::nullopt;
  require(filter_terms(u, v, w, c) == by_terms && filter_orient3d_by_terms<N>(t.a, t.b, t.c, x, c) == by_terms,
          "terms");
  const Expansion<N> e = expanded(u, v, w), by_minors = expanded(minors_of(u, v), w);
  require(e.value == point.value && e.terms == point.terms, "expansion");
  require(by_minors.value == point.value && by_minors.terms == point.terms, "expansion by minors");
  for (N at = 0; at < 3; ++at) {
    const N value = point.value + at * direction.value, terms = point.terms + at * direction.terms;
    require(filter_side(expanded(u, v, w), expanded(u, v, d), at, c) == beyond(value, c.k * terms + c.tiny), "side");
  }
  for (const Axis dropped : all_axes) {
    const int i = (static_cast<int>(dropped) + 1) % 3, j = (i + 1) % 3;
    const auto of = [&](const Point3& f) { return std::pair(static_cast<N>(f[i]), static_cast<N>(f[j])); };
    const auto [fu, fv] = of(t.b - t.a);
    for (const bool is_point : {false, true}) {
      const auto [gu, gv] = of(is_point ? x - t.a : x);
      const N mu = most(abs_of(fu), abs_of(gu)), mv = most(abs_of(fv), abs_of(gv));
      const MaybeSign area =
          mu < c.huge && mv < c.huge ? beyond(fu * gv - fv * gu, c.k * mu * mv + c.tiny) : std::nullopt;
      require((is_point ? filter_orient2d<N>(dropped, t.a, t.b, x, c)
                        : filter_orient2d<N>(dropped, t.a, t.b, Direction{x}, c)) == area,
              "area");
    }
  }
}

void orders(Draw& draw, const Constants& order, const Constants& volume) {
  const Triangle s = draw.triangle(3), t = draw.triangle(3);
  const Point3 o = draw.point(3), d = draw.point(3);
  const Ray r{o, {d}};
  const auto gain = [&](const Triangle& x) { return Sarrus(from(x.a, x.b), from(x.a, x.c), lifted(d)); };
  const auto height = [&](const Triangle& x) { return Sarrus(from(x.a, x.b), from(x.a, x.c), from(x.a, o)); };
  const Sarrus fg = gain(s), gg = gain(t), fh = height(s), gh = height(t);
  const N difference = gh.value * fg.value - fh.value * gg.value;
  const Vec3<N> ms = greatest(from(s.a, s.b), from(s.a, s.c), from(s.a, o), lifted(d));
  const Vec3<N> mt = greatest(from(t.a, t.b), from(t.a, t.c), from(t.a, o), lifted(d)), m = greatest(ms, mt);
  const auto product = [](const MaybeSign& a, const MaybeSign& b, const MaybeSign& c) {
    return a && b && c ? MaybeSign(*a * *b * *c) : std::nullopt;
  };
  const N cube = m.x * m.y * m.z;
  const MaybeSign sign = product(beyond(difference, order.k * cube * cube + order.tiny),
                                 beyond(fg.value, bound_of(m, volume)), beyond(gg.value, bound_of(m, volume)));
  require(filter_compare_hits<N>(r, s, t, order, volume) == (all_below(m, order.huge) ? sign : std::nullopt), "order");
  const N terms = gh.terms * fg.terms + fh.terms * gg.terms;
  const MaybeSign by_terms =
      product(beyond(difference, order.k * terms + order.tiny), beyond(fg.value, volume.k * fg.terms + volume.tiny),
              beyond(gg.value, volume.k * gg.terms + volume.tiny));
  const bool in_range = all_below(ms, order.huge) && all_below(mt, order.huge);
  require(filter_compare_hits_by_terms<N>(r, s, t, order, volume) == (in_range ? by_terms : std::nullopt),
          "order by terms");
}

/// The five volumes of a pair, by Sarrus' rule.
struct Volumes {
  N source, target, toward, ab, bc, ca;
};

Volumes volumes_of(const Point3& p, const Vec3<N>& d, const Triangle& t, bool segment) {
  const Vec3<N> u = from(t.a, t.b), v = from(t.a, t.c), w = from(t.a, p);
  const auto edge = [&](const Point3& a, const Point3& b) { return Sarrus(from(p, a), from(p, b), d).value; };
  const N source = Sarrus(u, v, w).value, toward = Sarrus(u, v, d).value;
  return {source, segment ? source + toward : toward, toward, edge(t.a, t.b), edge(t.b, t.c), edge(t.c, t.a)};
}

template <class P>
void pair_of(const P& probe, const Triangle& t, const PairConstants<N>& c) {
  constexpr bool segment = std::is_same_v<P, Segment>;
  const Point3& p = source(probe);
  const Vec3<N> d = arm<N>(lifted(p), target(probe));
  const Volumes f = volumes_of(p, d, t, segment);
  const N sign = f.toward < 0 ? -1 : 1;
  N margin = std::numeric_limits<N>::max();
  for (const N volume : {-f.source, f.target, f.ab, f.bc, f.ca}) margin = std::min(margin, sign * volume);
  const Vec3<N> m = greatest(from(t.a, t.b), from(t.a, t.c), from(t.a, p), d);
  const N bound = bound_of(m, c), length = most(abs_of(d.x), most(abs_of(d.y), abs_of(d.z)));
  const bool safe = all_below(m, c.huge) && (segment || length >= c.direction);
  const auto certain = conclude<P>(arms_of<N>(probe, t), c);
  require(certain.safe == safe && certain.bound == bound, "the range and the bound of a pair");
  require(certain.hit == (safe && margin > bound) && certain.miss == (safe && margin < -3 * bound), "a pair's verdict");
  const auto& [sides, edges] = certain.volumes;
  require(sides.source == f.source && sides.target == f.target && sides.toward == f.toward, "sides of a pair");
  require(edges.ab == f.ab && edges.bc == f.bc && edges.ac == -f.ca, "edges of a pair");
  const auto in_double = conclude<P>(arms_of<double>(probe, t), PairConstants<double>{{0, 0, 1e9}, 0});
  require(in_double.volumes.sides.source == f.source && in_double.volumes.edges.bc == f.bc, "a pair in double");
  require(f.toward == 0 || (in_double.hit == (margin > 0) && in_double.miss == (margin < 0)),
          "a pair's verdict in double");
  const std::optional<bool> hit = filter_hits<N>(probe, t, c);
  require(hit == (safe && margin > bound        ? std::optional(true)
                  : safe && margin < -3 * bound ? std::optional(false)
                                                : std::nullopt),
          "filter_hits");
}

/// The test by terms says what its signs say: it stops at the first two that decide.
template <class P>
void by_terms(const P& probe, const Triangle& t, const Constants& c) {
  const Point3& p = source(probe);
  const Vec3<N> u = from(t.a, t.b), v = from(t.a, t.c), d = arm<N>(lifted(p), target(probe));
  const auto sign = [&](const Vec3<N>& x, const Vec3<N>& y, const Vec3<N>& z) -> MaybeSign {
    const Sarrus s(x, y, z);
    if (!all_below(greatest(x, y, z), c.huge)) return std::nullopt;
    return beyond(s.value, c.k * s.terms + c.tiny);
  };
  const MaybeSign below = sign(u, v, from(t.a, p)), above = sign(u, v, arm<N>(lifted(t.a), target(probe)));
  const MaybeSign edges[] = {sign(from(p, t.a), from(t.a, t.b), d), sign(from(p, t.b), from(t.b, t.c), d),
                             sign(from(p, t.c), from(t.c, t.a), d)};
  bool parted = false, all = below && above;
  for (const MaybeSign& e : edges) {
    all &= e.has_value();
    for (const MaybeSign& f : edges) parted |= e && f && *e != *f;
  }
  const bool one_side = below && above && *below == *above;
  const std::optional<bool> due = one_side || parted ? std::optional(false) : all ? std::optional(true) : std::nullopt;
  require(filter_hits_by_terms<N>(probe, t, c) == due, "a pair by terms");
}

void pairs(Draw& draw, const Constants& c) {
  const Triangle t = draw.triangle(4);
  const Point3 p = draw.point(4), q = draw.point(4);
  for (const N direction : {0, 2, 4}) {
    pair_of(Segment{p, q}, t, PairConstants<N>{c, direction});
    pair_of(Ray{p, {q}}, t, PairConstants<N>{c, direction});
  }
  by_terms(Segment{p, q}, t, c);
  by_terms(Ray{p, {q}}, t, c);
}

/// In double with the real constants: what is certain is right, and in general position all is certain.
template <class P>
void in_double(const P& probe, const Triangle& t) {
  const bool hit = segura_feito(probe, t, k).hit;
  const Volumes f =
      volumes_of(source(probe), arm<N>(lifted(source(probe)), target(probe)), t, std::is_same_v<P, Segment>);
  const bool general = f.source != 0 && f.target != 0 && f.ab != 0 && f.bc != 0 && f.ca != 0;
  const auto first = filter_hits(probe, t, pair_filter<P>);
  const auto second = filter_hits_by_terms<double>(probe, t, volume_terms_filter);
  require(!first || *first == hit, "certain and wrong");
  require(!second || *second == hit, "certain and wrong by terms");
  require(!general || (first && second), "not certain in general position");
}

void planes(Draw& draw) {
  const Triangle t = draw.triangle(6);
  const Point3 x = draw.point(6);
  const auto due = [](Sign s) { return s == Sign::zero ? MaybeSign() : MaybeSign(s); };
  require(PlaneFilter(t).side(x) == due(k.orient3d(t.a, t.b, t.c, x)), "the side of a plane");
  require(PlaneFilter(t).side(Direction{x}) == due(k.orient3d(t.a, t.b, t.c, Direction{x})), "toward a side");
  const Ray r{draw.point(6), {x}};
  const SidesAlongRay sides(r, t);
  for (const double at : {0.0, 1.0, 2.0}) {
    const MaybeSign sign = due(k.orient3d(t.a, t.b, t.c, RayPoint{r, at}));
    require(sides.at(at) == sign && sides.at_end(at) == sign, "the side of a point of a ray");
  }
  require(sides.at_end(inf) == due(k.orient3d(t.a, t.b, t.c, Direction{x})), "the side of a ray's end");
  // Doubled, so that halves are integers too.
  const Triangle big{2.0 * t.a, 2.0 * t.b, 2.0 * t.c};
  const Ray long_ray{2.0 * r.o, {2.0 * x}};
  for (const Bounds bounds : {Bounds{}, Bounds{0, 1}, Bounds{0.5, 1.5}, Bounds{1, 1}, Bounds{1}, Bounds{0.5, 3}}) {
    const bool hit = decide_within(r, bounds, [&](const auto& part) {
      using Part = std::remove_cvref_t<decltype(part)>;
      if constexpr (std::is_same_v<Part, Tail>) {
        return segura_feito(Ray{long_ray.o + part.tmin * long_ray.d.v, long_ray.d}, big, k).hit;
      } else {
        return segura_feito(Segment{long_ray.o + bounds.tmin * long_ray.d.v, long_ray.o + bounds.tmax * long_ray.d.v},
                            big, k)
            .hit;
      }
    });
    const auto certain = filter_hits_within(r, bounds, t);
    require(!certain || *certain == hit, "certain and wrong within bounds");
    const MaybeSign near = due(k.orient3d(big.a, big.b, big.c, long_ray.o + bounds.tmin * long_ray.d.v));
    const MaybeSign far = bounds.tmax == inf
                              ? due(k.orient3d(big.a, big.b, big.c, long_ray.d))
                              : due(k.orient3d(big.a, big.b, big.c, long_ray.o + bounds.tmax * long_ray.d.v));
    const Volumes f = volumes_of(r.o, lifted(x), t, false);
    const bool apart = f.ab != 0 && f.bc != 0 && f.ca != 0;
    require(!(near && far && apart) || certain.has_value(), "not certain within bounds");
    require(!(near && far && *near == *far) || certain.has_value(), "both ends on one side, and not certain");
  }
  const auto crosses = filter_line_crosses(r, t);
  const Volumes f = volumes_of(r.o, lifted(x), t, false);
  bool some[2] = {}, none = false;
  for (const N e : {f.ab, f.bc, f.ca}) some[0] |= e<0, some[1] |= e> 0, none |= e == 0;
  require(crosses == (some[0] && some[1] ? std::optional(false)
                      : none             ? std::nullopt
                                         : std::optional(true)),
          "the line");
}

/// A small triangle far away, where only the bound by terms is narrow enough.
void far_away() {
  const Point3 far(0x1p30);
  const Triangle t{far, far + Point3(4, 0, 0), far + Point3(0, 4, 0)};
  const Ray through{{0, 0, 0}, {far + Point3(1, 1, 0)}}, beside{{0, 0, 0}, {far + Point3(8, -8, 0)}};
  for (const Ray& r : {through, beside}) {
    const bool hit = r.d.v == through.d.v;
    require(!filter_hits(r, t, pair_filter<Ray>), "far away the first filter is not certain");
    require(filter_hits_by_terms<double>(r, t, volume_terms_filter) == hit, "far away, by terms");
    require(filter_hits_within(r, Bounds{0.5, 2}, t) == hit, "far away, within bounds");
    require(filter_hits_within(r, Bounds{0, 0.5}, t) == false, "far away, and before it");
  }
}

/// Bounds of a ray: what t may be, and coordinates out of range.
void ranges() {
  for (const double t : {0.0, -0.0, 0x1p-150, 1.0, 0x1p150}) require(is_in_side_range(t), "t in range");
  for (const double t : {0x1p-151, 0x1.8p150, 0x1p151, 0x1p-1074, inf, nan})
    require(!is_in_side_range(t), "t out of range");
  const Triangle t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  const Ray r{{1, 1, 2}, {{0, 0, -1}}};
  require(filter_hits_within(r, Bounds{0, 4}, t) == true && filter_hits_within(r, Bounds{3, 4}, t) == false, "plain");
  require(!filter_hits_within(r, Bounds{2, 4}, t) && !filter_hits_within(r, Bounds{0, 2}, t), "a bound at the plane");
  require(!filter_hits_within(r, Bounds{0x1p-160, 4}, t), "a bound too small to be certain");
  for (const double scale : {0x1p149, 0x1p150, 0x1p160}) {
    const bool in = scale < 0x1p148;
    const Triangle far{t.a, scale * t.b, t.c};
    require(in || !PlaneFilter(far).side(r.o), "an arm out of range");
    require(in || !SidesAlongRay(r, far).at(1) || scale == 0x1p149, "a side out of range");
    require(!SidesAlongRay(r, far).at_end(inf), "an end out of range");
    require(!PlaneFilter(t).side(Point3(1, 1, scale * 2)), "a point out of range");
  }
  require(PlaneFilter(t).side(Point3(1, 1, 0x1p149)) == Sign::positive, "a point just in range");
  require(SidesAlongRay(r, {t.a, {0x1p149, 0, 0}, t.c}).at_end(inf) == Sign::negative, "an end just in range");
  require(!filter_hits(Segment{{nan, 1, 1}, {1, 1, -1}}, t, pair_filter<Segment>), "NaN is certain of nothing");
  require(!filter_hits(Ray{{1, 1, 1}, {{0, 0, nan}}}, t, pair_filter<Ray>), "a NaN of the direction");
  require(!filter_hits(Ray{{1, 1, 0x1p-140}, {{0, 0, -0x1p-151}}}, t, pair_filter<Ray>), "a direction too short");
  require(filter_hits(Ray{{1, 1, 0x1p-140}, {{0, 0, -0x1p-150}}}, t, pair_filter<Ray>) == true,
          "a direction long enough");
  require(certain(true).hit && certain(true).contact == Contact::interior && certain(true).at == At::between &&
              certain(true).stage == Stage::filter && !certain(false).hit && certain(false).stage == Stage::filter,
          "what is certain");
}

/// Pairs of numbers, as generic pairs and in one register.
template <class M>
void twins() {
  for (int code = 0; code < 625; ++code) {
    const M a = M(code % 5 - 2), b = M(code / 5 % 5 - 2), c = M(code / 25 % 5 - 2), d = M(code / 125 - 2);
    const Twin<M> x{a, b}, y{c, d};
    const auto is = [](const Twin<M>& t, M p, M q) { return first(t) == p && second(t) == q; };
    require(is(x + y, a + c, b + d) && is(x - y, a - c, b - d) && is(x * y, a * c, b * d), "arithmetic of twins");
    require(is(swapped(x), b, a) && is(twice(a), a, a), "swapped and twice");
    const auto abs = [](M m) { return m < 0 ? M(-m) : m; };
    require(is(magnitude(x), abs(a), abs(b)), "magnitudes of twins");
    require(is(larger(x, y), std::max(a, c), std::max(b, d)) && is(smaller(x, y), std::min(a, c), std::min(b, d)),
            "extremes");
    require(is(larger_magnitude(x, y), std::max(abs(a), abs(c)), std::max(abs(b), abs(d))), "larger magnitudes");
    require(both_beyond(x, y) == (abs(a) > c && abs(b) > d), "both beyond");
    require(negative_bits(x) == static_cast<unsigned>((a < 0) + 2 * (b < 0)), "negative bits");
    require(same_sign(x) == ((a < 0) == (b < 0)), "the same sign");
    const Vec3<M> u{a, b, c}, v{d, c, b};
    const auto uv = beside(u, v), vu = swapped(uv);
    require(is(uv.x, a, d) && is(uv.y, b, c) && is(uv.z, c, b) && is(vu.x, d, a) && is(vu.y, c, b), "beside");
    require(is(vu.z, b, c), "beside, swapped");
  }
}

}  // namespace

int main() {
  small_functions();
  constants();
  twins<N>();
  twins<double>();
  ranges();
  far_away();
  Draw draw;
  for (int n = 0; n < 20000; ++n) {
    const Constants &c = loose[n % 5], &e = loose[n / 5 % 5];
    volumes(draw, c);
    orders(draw, c, e);
    pairs(draw, c);
    planes(draw);
    const Triangle t = draw.triangle(3);
    const Point3 p = draw.point(3), q = draw.point(3);
    in_double(Segment{p, q}, t);
    in_double(Ray{p, {q}}, t);
  }
  std::puts("survived");
}
