// The part of kill_tree.cpp that is about packets: what their lanes are certain of must be true, and of easy faces they
// must be certain.
#include <bit>
#include <cmath>
#include <vector>

#include "core/segura_feito.h"
#include "core/segura_feito_polygon.h"
#include "exact/filtered/filtered_polygon.h"
#include "tests/mutation/kill.h"
#include "tracer/accel/lanes_at_work.h"
#include "tracer/accel/wide/box.h"
#include "tracer/accel/wide/packet.h"

using namespace tribunal;
using namespace tribunal::killing;

namespace {

const FormulaKernel<std::int64_t> integers;

/// Triangles and squares parallel to planes of the axes, at different heights.
struct Faces {
  std::vector<Triangle> triangles{};  ///< of face i: itself, or one that spans the square's plane
  std::vector<std::int32_t> polygon_of{};
  std::vector<PolygonData> squares{};
};

Faces drawn_faces(Draw& draw, int count) {
  Faces f;
  for (int i = 0; i < count; ++i) {
    const bool is_square = i % 4 == 3;
    const Triangle t = draw.triangle(9);
    if (!is_square) {
      f.triangles.push_back(t);
      f.polygon_of.push_back(-1);
      continue;
    }
    const int axis = draw.below(3), u = (axis + 1) % 3, v = (axis + 2) % 3, side = draw.within(1, 6);
    const Point3 a = draw.point(9);
    Point3 b = a, c = a, d = a;
    b[u] += side, c[u] += side, c[v] += side, d[v] += side;
    f.polygon_of.push_back(static_cast<std::int32_t>(f.squares.size()));
    f.squares.push_back(PolygonData{}.add(std::vector<Point3>{a, b, c, d}));
    f.triangles.push_back({a, b, c});
  }
  return f;
}

template <class P>
Answer exact_answer(const Faces& f, std::size_t id, const P& probe) {
  if (f.polygon_of[id] < 0) return segura_feito(probe, f.triangles[id], integers);
  const Polygon polygon = f.squares[static_cast<std::size_t>(f.polygon_of[id])];
  return segura_feito(probe, cover(polygon, integers), integers);
}

template <class P>
bool sees(const Faces& f, std::size_t id, const P& probe) {
  const Answer a = exact_answer(f, id, probe);
  return a.hit && a.contact != Contact::coplanar;
}

double parameter(const Faces& f, std::size_t id, const Ray& r) {
  const HitParameter<double> p = hit_parameter<double>(r, f.triangles[id]);
  return p.num / p.den;
}

bool is_on(unsigned bits, std::size_t lane) { return (bits >> lane & 1) != 0; }

struct Tree {
  explicit Tree(const Faces& f) {
    for (const PolygonData& p : f.squares) polygons.emplace_back(p);
    for (const FilteredPolygon& p : polygons) figures.push_back(p.figures());
    tree = WideTree(static_cast<std::uint32_t>(f.triangles.size()), [&](std::uint32_t i) {
      if (f.polygon_of[i] < 0) return Primitive{box_of(f.triangles[i]), f.triangles[i]};
      return Primitive{box_of(Polygon(f.squares[static_cast<std::size_t>(f.polygon_of[i])])), {}};
    });
  }
  std::vector<FilteredPolygon> polygons{};
  std::vector<PolygonFigures> figures{};
  WideTree tree{};
};

/// One lane's answer about a ray, of which two faces are excluded.
void require_first(const Faces& f, const Ray& r, std::uint32_t one, std::uint32_t other, const PacketAnswer& a,
                   std::size_t lane) {
  if (!is_on(a.known, lane)) return;
  std::size_t first = f.triangles.size();
  for (std::size_t id = 0; id < f.triangles.size(); ++id) {
    if (id == one || id == other || !sees(f, id, r)) continue;
    if (first == f.triangles.size() || integers.compare_hits(r, f.triangles[id], f.triangles[first]) == Sign::negative)
      first = id;
  }
  const bool due = first < f.triangles.size();
  require(is_on(a.hit, lane) == due, "a lane's hit");
  if (!due) return;
  require(a.id[lane] == static_cast<double>(first), "a lane's face");
  if (!is_on(a.close, lane)) return;
  const double t = parameter(f, first, r);
  require(std::fabs(a.t[lane] - t) <= 0x1p-20 * t, "a lane's parameter");
}

void require_any(const Faces& f, const Segment& s, std::uint32_t one, std::uint32_t other, const PacketAnswer& a,
                 std::size_t lane) {
  if (!is_on(a.known, lane)) return;
  bool due = false;
  for (std::size_t id = 0; id < f.triangles.size(); ++id) due |= id != one && id != other && sees(f, id, s);
  require(is_on(a.hit, lane) == due, "a lane's segment");
}

struct Totals {
  unsigned known = 0, hit = 0, close = 0;
  void add(const PacketAnswer& a) {
    require((a.close & ~a.hit) == 0, "close hits");
    known += static_cast<unsigned>(std::popcount(a.known));
    hit += static_cast<unsigned>(std::popcount(a.known & a.hit));
    close += static_cast<unsigned>(std::popcount(a.known & a.close));
  }
};

void check_random(Draw& draw, int faces, Totals& rays, Totals& ways) {
  const Faces f = drawn_faces(draw, faces);
  const Tree t(f);
  const PacketFaces asked{t.tree, f.polygon_of, t.figures};
  for (int n = 0; n < 30; ++n) {
    ProbePacket of_rays, of_segments;
    Ray r[packet_size];
    std::uint32_t one[packet_size], other[packet_size];
    const std::size_t lanes = n % 5 == 0 ? 3 : packet_size;
    const Point3 from = draw.point(40);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      r[lane] = {n % 2 == 0 ? from : draw.point(40), {}};
      r[lane].d.v = draw.point(12) - (n % 3 == 0 ? r[lane].o : Point3(0));
      one[lane] = n % 4 == 0 ? static_cast<std::uint32_t>(draw.below(faces)) : ~0U;
      other[lane] = n % 4 == 1 ? static_cast<std::uint32_t>(draw.below(faces)) : ~0U;
      of_rays.set(lane, r[lane].o, r[lane].d.v, one[lane], other[lane]);
      of_segments.set(lane, r[lane].o, r[lane].o + r[lane].d.v, one[lane], other[lane]);
    }
    PacketAnswer first, any;
    packet_target().first_hits(asked, of_rays, first);
    packet_target().any_hits(asked, of_segments, any);
    require(first.known >> lanes == 0 && any.known >> lanes == 0, "lanes without a probe");
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      require_first(f, r[lane], one[lane], other[lane], first, lane);
      require_any(f, {r[lane].o, r[lane].o + r[lane].d.v}, one[lane], other[lane], any, lane);
    }
    rays.add(first);
    ways.add(any);
    require(first.boxes <= packet_size * first.boxes_visited, "lanes at work");
    double certain = 0;
    for (const double tests : first.tests) certain += tests;
    require(certain == static_cast<double>(first.triangle_tests + first.polygon_tests), "tests by lane");
    require(first.triangle_hits <= first.triangle_tests && first.polygon_hits <= first.polygon_tests, "hits of tests");
  }
}

/// Away from boundaries, a stack of floors under eight rays: the lanes answer all by themselves.
void check_easy() {
  Faces f;
  for (int i = 0; i < 40; ++i) {
    const double z = -1 - (i * 7) % 40;
    f.triangles.push_back({{-90, -90, z}, {90, -90, z}, {0, 90, z}});
    f.polygon_of.push_back(-1);
  }
  const Tree t(f);
  ProbePacket packet, ways;
  for (std::size_t lane = 0; lane < packet_size; ++lane) {
    const Point3 o(static_cast<double>(lane) - 4, 3, 0), d(0.125, 0.0625, -1);
    packet.set(lane, o, d);
    ways.set(lane, o, o + 0.5 * d + (lane % 2 == 0 ? d : Point3(0)));
  }
  PacketAnswer a, b;
  packet_target().first_hits({t.tree, f.polygon_of, {}}, packet, a);
  require(a.known == 0xff && a.hit == 0xff && a.close == 0xff, "all lanes know");
  for (std::size_t lane = 0; lane < packet_size; ++lane)
    require(a.id[lane] == 0 && std::fabs(a.t[lane] - 1) < 1e-9, "the top floor");
  require(a.triangle_tests < 8 * 40 && a.triangle_hits > 0 && a.polygon_tests == 0, "floors behind are not asked");
  packet_target().any_hits({t.tree, f.polygon_of, {}}, ways, b);
  require(b.known == 0xff && b.hit == 0x55, "every other way reaches the first floor");
  const LanesAtWork all(a), none;
  require(all.share() > 0.9 && all.share() <= 1 && none.share() == 0, "neighbours share their boxes");
  LanesAtWork sum = all;
  sum += all;
  require(sum.at_work == 2 * all.at_work && sum.taken == 2 * all.taken, "sums of lanes");
  sum = {};
  sum.at_work = 80, sum.taken = 160;
  sum.forget_some();
  require(sum.at_work == 70 && sum.taken == 140, "an eighth is forgotten");
}

/// Lanes that are not finite, out of the range of boxes, or of two equal faces know nothing.
void check_unknown() {
  Faces f;
  const Triangle t{{-9, -9, 0}, {9, -9, 0}, {0, 9, 0}};
  f.triangles = {t, t, {{20, -9, 0}, {38, -9, 0}, {29, 9, 0}}};
  f.polygon_of = {-1, -1, -1};
  const Tree tree(f);
  ProbePacket packet;
  packet.set(0, {0, 0, 5}, {0, 0, -1});
  packet.set(1, {not_a_number, 0, 5}, {0, 0, -1});
  packet.set(2, {29, 0, 5}, {0, 0, -1e-305});
  packet.set(3, {29, 0, 5}, {0, 0, -1});
  packet.set(4, {29, 0, 1e20}, {0, 0, -1});
  packet.set(5, {29, 0, 5}, {0, -infinity, -1});
  packet.set(6, {29, -9, 5}, {0, 0, -1});
  PacketAnswer a;
  packet_target().first_hits({tree.tree, f.polygon_of, {}}, packet, a);
  require(a.known == 0x8 && (a.known & a.hit) == 0x8, "only what is certain is known");
  PacketAnswer nothing;
  packet_target().first_hits({WideTree(), {}, {}}, packet, nothing);
  require((nothing.known & 0x9) == 0x9 && nothing.hit == 0, "no faces");
}

}  // namespace

void check_packets() {
  Draw draw;
  Totals rays, ways;
  for (const int faces : {1, 4, 12, 40, 200}) check_random(draw, faces, rays, ways);
  require(rays.known > 950 && rays.hit > 90 && rays.close > 90, "lanes know much of rays");
  require(ways.known > 950 && ways.hit > 60, "lanes know much of segments");
  check_easy();
  check_unknown();
}
