// Kills mutants of the polygon test: returns 0 iff the decisions of coverings are right on small integers, where int64
// is exact. What is right comes from the oracles of points and rings, which share no formula with the test, from
// Carathéodory's theorem, from drawings, and from what must not change an answer.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

#include "core/longest_axis.h"
#include "core/products.h"
#include "core/segura_feito_polygon.h"
#include "exact/oracles/polygon_oracles.h"
#include "tests/mutation/kill.h"

using namespace tribunal;
using killing::require;

namespace {

using N = std::int64_t;
const FormulaKernel<N> k;

using Points = std::vector<Point3>;

PolygonData polygon_of(const std::vector<Points>& rings) {
  PolygonData p;
  for (const Points& ring : rings) p.add(ring);
  return p;
}

/// The answer, which is the same with preparation and without.
template <class P>
Answer ask(const P& probe, const Polygon& polygon) {
  const Answer prepared = segura_feito(probe, cover(polygon, k), k);
  Answer on_the_fly = segura_feito(probe, polygon, k);
  require(on_the_fly.planar || !prepared.planar, "not planar without preparation alone");
  on_the_fly.planar = prepared.planar;
  require(on_the_fly == prepared, "prepared and on the fly");
  return prepared;
}

Vec3<N> direction_of(const Segment& s) { return lift<N>(s.q) - lift<N>(s.p); }
Vec3<N> direction_of(const Ray& r) { return lift<N>(r.d.v); }

template <class P>
bool meets_vertex(const P& probe, const Polygon& polygon) {
  for (const Point3& v : polygon.vertices) {
    if (meets_by_caratheodory<N>(probe, Triangle{v, v, v})) return true;
  }
  return false;
}

/// Whether the probe lies in the polygon's plane, or the polygon on a line.
template <class P>
bool is_coplanar(const P& probe, const Polygon& polygon) {
  const Vec3<N> n = polygon_oracle_detail::normal_of<N>(polygon);
  const Vec3<N> to_source = lift<N>(source(probe)) - lift<N>(polygon.vertices.front());
  return polygon_oracle_detail::inner(n, to_source) == 0 && polygon_oracle_detail::inner(n, direction_of(probe)) == 0;
}

Answer missed(bool planar) {
  Answer answer = miss();
  answer.planar = planar;
  return answer;
}

template <class P>
void expect(const P& probe, const Polygon& polygon) {
  const PolygonVerdicts v = ask_oracles<N>(probe, polygon);
  const bool crossed = v.surface_halves % 4 == 2 || v.surface_halves % 4 == -2;
  const bool hit = v.boundary || (v.planar ? v.by_generic_ray : crossed);
  const bool coplanar = v.planar && is_coplanar(probe, polygon);
  const Answer answer = ask(probe, polygon);
  require(answer.hit == hit, "hit against the oracles");
  require(answer.planar == v.planar, "planar against the normal");
  require(answer.facing == Facing::unsaid && answer.status == Status::ok, "a polygon has no front");
  if (!hit) {
    require(answer == missed(v.planar), "a miss says nothing else");
    return;
  }
  const Contact contact = coplanar     ? Contact::coplanar
                          : v.boundary ? (meets_vertex(probe, polygon) ? Contact::vertex : Contact::edge)
                                       : Contact::interior;
  require(answer.contact == contact, "contact against the oracles");
  if (coplanar || !v.planar) return;
  const Vec3<N> n = polygon_oracle_detail::normal_of<N>(polygon), o = lift<N>(polygon.vertices.front());
  const N from = polygon_oracle_detail::inner(n, lift<N>(source(probe)) - o);
  const N to = from + polygon_oracle_detail::inner(n, direction_of(probe));
  const bool ends = std::is_same_v<P, Segment> && to == 0;
  require(answer.at == (from == 0 ? At::source : ends ? At::target : At::between), "at against the heights");
}

Point3 grid_point(int i) { return Point3(i % 3, i / 3, 0); }

/// Three images of the plane z = 0, so that each axis is dropped, and slanting ones.
Point3 image(const Point3& p, int which) {
  switch (which % 5) {
    case 0:
      return p;
    case 1:
      return {p.z, p.x, p.y};
    case 2:
      return {p.y, p.z, p.x};
    case 3:
      return {p.x, p.y, p.z + p.x + 2 * p.y};
    default:
      return {-p.x + p.z, p.y, p.z - p.x - p.y};
  }
}

Polygon moved(PolygonData& into, const Polygon& from, int which) {
  into = {{from.vertices.begin(), from.vertices.end()}, {from.ends.begin(), from.ends.end()}};
  for (Point3& v : into.vertices) v = image(v, which);
  return into;
}

/// All probes of a small set against a polygon on 2·{0,1,2}² in z = 0, moved by an image.
void expect_probes(const Polygon& flat, int n, int stride) {
  PolygonData storage;
  const Polygon polygon = moved(storage, flat, n);
  for (int i = n % stride; i < 49; i += stride) {  // piercing points on the half grid and beyond
    const Point3 x(i % 7 - 1, i / 7 - 1, 0), above = x + Point3(0, 0, 1), below = x - Point3(0, 0, 1);
    const Point3 aslant = x + Point3(n % 3 - 1, n / 3 % 3 - 1, 1);
    const auto at = [&](const Point3& p) { return image(p, n); };
    const auto toward = [&](const Point3& d) { return Direction{image(d, n)}; };
    switch ((i + n) % 8) {
      case 0:
        expect(Segment{at(above), at(below)}, polygon);
        break;
      case 1:
        expect(Segment{at(x), at(above)}, polygon);
        break;
      case 2:
        expect(Segment{at(below), at(x)}, polygon);
        break;
      case 3:
        expect(Ray{at(aslant), toward(x - aslant)}, polygon);
        break;
      case 4:
        expect(Ray{at(x), toward(x - aslant)}, polygon);
        break;
      case 5:
        expect(Segment{at(above), at(aslant)}, polygon);
        break;
      case 6:
        expect(Ray{at(above), toward({0, 0, 1})}, polygon);
        break;
      default:
        expect(Segment{at(2.0 * aslant - x), at(2.0 * x - aslant)}, polygon);
    }
    const Point3 y((i * 5 + n) % 7 - 1, (i * 3 + n) % 7 - 1, 0);
    if (i % 2 == 0) {
      expect(Segment{at(x), at(y)}, polygon);
    } else {
      expect(Ray{at(x), toward(y - x)}, polygon);
    }
  }
}

/// Rings of three to five vertices on a 3 × 3 grid, crossing, flat and repeated ones among them.
void all_rings() {
  int n = 0;
  for (int size = 3; size <= 5; ++size) {
    int count = 1;
    for (int i = 0; i < size; ++i) count *= 9;
    for (int code = size == 5 ? 3 : 0; code < count; code += size == 5 ? 17 : size == 4 ? 3 : 1, ++n) {
      Points ring;
      for (int i = 0, rest = code; i < size; ++i, rest /= 9) ring.push_back(2.0 * grid_point(rest % 9));
      expect_probes(polygon_of({ring}), n, 7);
    }
  }
}

/// Two rings, one in the other, beside it, touching or crossing it, either way around; rings of no, one and two
/// vertices.
void holes() {
  const Points outer{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  for (int code = 0; code < 729; ++code) {
    const Points hole{2.0 * grid_point(code % 9), 2.0 * grid_point(code / 9 % 9), 2.0 * grid_point(code / 81)};
    expect_probes(polygon_of({outer, hole}), code, 5);
    expect_probes(polygon_of({hole, outer}), code + 1, 11);
    if (code % 9 == 0) {
      expect_probes(polygon_of({outer, {}, {hole[1]}, {hole[2], hole[1]}}), code, 5);
      expect_probes(polygon_of({{hole[1]}, outer, hole}), code, 5);
    }
  }
}

/// Quadrilaterals and pentagons that are not planar, or are by chance; at the half grid around them.
void folds() {
  unsigned random = 1;
  const auto draw = [&](int below) {
    random = random * 1664525 + 1013904223;
    return static_cast<int>((random >> 8) % static_cast<unsigned>(below));
  };
  const auto point = [&](double scale) {
    const int x = draw(4), y = draw(4), z = draw(3);
    return scale * Point3(x, y, z);
  };
  for (int n = 0; n < 6000; ++n) {
    Points ring;
    for (int i = 0; i < 4 + n % 3; ++i) ring.push_back(point(2));
    const PolygonData polygon = polygon_of({ring});
    const Point3 a = ring[static_cast<std::size_t>(draw(4))];
    const Point3 p = point(2), q = n % 4 == 0 ? a + a - p : point(2), between = point(1);
    for (const bool ray : {false, true}) {
      const Segment s{n % 5 == 0 ? between : p, q};
      if (ray) {
        expect(Ray{s.p, {s.q - s.p}}, polygon);
      } else {
        expect(s, polygon);
      }
    }
  }
}

/// Answers that are drawn, not computed.
void by_hand() {
  const PolygonData frame =
      polygon_of({{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}, {{4, 4, 0}, {6, 4, 0}, {6, 6, 0}, {4, 6, 0}}});
  const auto down = [&](double x, double y) { return ask(Segment{{x, y, 1}, {x, y, -1}}, frame); };
  require(down(2, 1) == hit_at(Contact::interior, At::between), "inside");
  require(down(5, 5) == miss(), "in the hole");
  require(down(5, 4) == hit_at(Contact::edge, At::between), "on the hole's edge");
  require(down(4, 4) == hit_at(Contact::vertex, At::between), "at the hole's corner");
  require(ask(Segment{{1, 1, 0}, {2, 1, 0}}, frame) == hit_at(Contact::coplanar), "in the plane");
  require(detail::Crossings{.halves = 2}.hit() && detail::Crossings{.boundary = true}.hit(), "crossings that hit");
  require(!detail::Crossings{.halves = 4}.hit() && !detail::Crossings{}.hit(), "crossings that do not");
  require(cover(frame, k).planar && !cover(frame, k).disjoint && !cover(frame, k).is_triangle(), "two rings");
  const PolygonData square = polygon_of({{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}});
  require(cover(square, k).disjoint && cover(square, k).plane->dropped == Axis::z, "a square is a fan");
  require(!cover(square, k).is_triangle(), "a square is no triangle");
  const PolygonData turned = polygon_of({{{0, 0, 0}, {0, 9, 0}, {9, 9, 0}, {9, 0, 0}}});
  require(cover(turned, k).disjoint, "a square that runs clockwise is a fan");
  const PolygonData dart = polygon_of({{{0, 0, 0}, {12, 6, 0}, {0, 12, 0}, {4, 6, 0}}});
  require(!cover(dart, k).disjoint, "the first vertex does not see all");
  const PolygonData from_notch = polygon_of({{{4, 6, 0}, {0, 0, 0}, {12, 6, 0}, {0, 12, 0}}});
  require(!cover(from_notch, k).disjoint, "seen whole, but over more than half a turn");
  const PolygonData flat_start = polygon_of({{{0, 0, 0}, {4, 0, 0}, {9, 0, 0}, {9, 9, 0}}});
  require(!cover(flat_start, k).disjoint, "a first triangle without area");
  const PolygonData two_turns = polygon_of({{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {9, 4, 0}}});
  require(!cover(two_turns, k).disjoint, "turns both ways");
  const PolygonData triangle = polygon_of({{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}}});
  require(cover(triangle, k).is_triangle() && cover(triangle, k).disjoint, "a triangle");
  const PolygonData two = polygon_of({{{0, 0, 0}, {9, 0, 0}}});
  require(!cover(two, k).disjoint && !cover(two, k).plane && cover(two, k).planar, "two vertices");
  const PolygonData tent = polygon_of({{{0, 0, 0}, {9, 0, 3}, {9, 9, 0}, {0, 9, 3}}});
  require(!cover(tent, k).planar && !cover(tent, k).plane && !cover(tent, k).disjoint, "a fold");
  require(segura_feito(Segment{}, PolygonData{}, k) == miss() && ask(Segment{}, PolygonData{}) == miss(), "nothing");
  require(ask(Segment{{6, 3, 9}, {6, 3, -9}}, tent).at == At::between, "one place");
  const PolygonData stair = polygon_of(
      {{{0, 0, 0}, {4, -4, 4}, {4, 4, 4}, {-8, 0, 0}, {4, -4, 8}, {4, 4, 8}, {-8, 0, 0}, {4, -4, 12}, {4, 4, 12}}});
  require(ask(Segment{{2, 0, 2}, {2, 0, 10}}, stair).at == At::unsaid, "several places are no one place");
  require(ask(Segment{{2, 0, 10}, {2, 0, 2}}, stair).at == At::unsaid, "several places, backwards");
  require(ask(Segment{{2, 0, 2}, {2, 0, 3}}, stair).at == At::source, "one place, the source");
  require(ask(Segment{{2, 0, 0}, {2, 0, 2}}, stair).at == At::target, "one place, the target");
  require(ask(Segment{{2, 0, 2}, {2, 0, 5}}, stair).contact == Contact::none, "two crossings");
}

/// The three signs of a passage in words.
void passages() {
  for (int code = 0; code < 27; ++code) {
    const int oa = code % 3 - 1, ab = code / 3 % 3 - 1, bo = code / 9 - 1;
    const detail::Passage p{sign_of(oa), sign_of(ab), sign_of(bo)};
    const bool left = oa > 0 || ab > 0 || bo > 0, right = oa < 0 || ab < 0 || bo < 0;
    require(p.edge_on() == (!left && !right), "seen edge-on");
    require(value(p.direction()) == (left && right ? 0 : left - right), "the direction of a passage");
    const bool at_o = oa == 0 && bo == 0, on_spoke = oa == 0 || bo == 0;
    const detail::Location due = ab == 0    ? on_spoke ? detail::Location::vertex : detail::Location::external_edge
                                 : at_o     ? detail::Location::vertex
                                 : on_spoke ? detail::Location::internal_edge
                                            : detail::Location::inside;
    require(p.location() == due, "the location of a passage");
  }
}

void finiteness_and_rings() {
  const double inf = std::numeric_limits<double>::infinity();
  PolygonData p = polygon_of({{{0, 0, 0}, {1, 0, 0}}, {}, {{2, 0, 0}}});
  const Polygon view = p;
  require(view.rings() == 3 && view.ring(0).size() == 2 && view.ring(1).empty() && view.ring(2).size() == 1, "rings");
  require(view.ring(2)[0].x == 2 && view.ring(0)[1].x == 1 && is_finite(view), "vertices of rings");
  for (std::size_t i = 0; i < 3; ++i) {
    PolygonData bad = p;
    bad.vertices[i].y = inf;
    require(!is_finite(bad), "a vertex at infinity");
  }
}

void vectors() {
  for (int code = 0; code < 343; ++code) {
    const Vec3<N> v{code % 7 - 3, code / 7 % 7 - 3, code / 49 - 3};
    const N x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
    const Axis longest = x >= y && x >= z ? Axis::x : y >= z ? Axis::y : Axis::z;
    require(longest_axis(v) == longest, "the longest axis");
    const Vec3<N> w{2, -3, 5}, c = cross(v, w);
    require(dot(v, c) == 0 && dot(w, c) == 0 && dot(v, w) == 2 * v.x - 3 * v.y + 5 * v.z, "products");
    require(c.x == 5 * v.y + 3 * v.z && c.y == 2 * v.z - 5 * v.x && c.z == -3 * v.x - 2 * v.y, "a cross product");
  }
}

}  // namespace

int main() {
  for (int halves = -24; halves <= 24; ++halves) {
    require(detail::is_odd(halves) == (halves % 2 == 0 && halves / 2 % 2 != 0), "an odd number of whole crossings");
  }
  vectors();
  passages();
  finiteness_and_rings();
  by_hand();
  holes();
  folds();
  all_rings();
  std::puts("survived");
}
