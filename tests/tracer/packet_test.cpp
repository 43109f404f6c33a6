// Queries answered in packets of eight, compared with the same queries answered one by one on every face.
#include <functional>

#include "exact/cases/family_table.h"
#include "exact/filtered/batch.h"
#include "exact/filtered/filtered.h"
#include "tests/tracer/nasty_scenes.h"
#include "tests/tracer/tree_support.h"
#include "tracer/scene/read_scene.h"
#include "tracer/shading/visibility.h"

namespace tribunal {

namespace {

using testing::aimed;
using testing::method;
using testing::nasty_scene;
using testing::Random;
using testing::Worlds;

class Packets : public testing::OnEveryTarget {};

INSTANTIATE_TEST_SUITE_P(Targets, Packets, ::testing::ValuesIn(batch_targets()), testing::target_name);

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A ray at a weak point of the scene; now and then one with direction zero, with a NaN, or out of the range of
/// binary32.
Ray any_ray(Random& random, const BoxedFaces& faces) {
  Ray ray = aimed(random, faces);
  switch (random.below(16)) {
    case 0:
      return {ray.o, {{0, -0.0, 0}}};
    case 1:
      return {ray.o, {{infinity, 0, 1}}};
    case 2:
      return {{0, std::nan(""), 0}, ray.d};
    case 3:
      return {ray.o + Point3(0x1p70, 0, 0), ray.d};
    case 4:
      return {ray.o, {0x1p-1000 * ray.d.v}};
    default:
      return ray;
  }
}

/// Calls with spans of all lengths, so that the last packet is not always full.
template <class Question>
void in_spans(Random& random, std::vector<Question>& questions, const std::function<void(std::span<Question>)>& ask) {
  for (std::size_t from = 0; from < questions.size();) {
    const std::size_t count = std::min(1 + random.below(40), questions.size() - from);
    ask(std::span(questions).subspan(from, count));
    from += count;
  }
}

/// Answers on the lanes against those of another exact method that asks every face.
void compare(const Scene& scene, std::uint64_t seed, int count) {
  const Worlds w(scene);
  RayTally tally, uncounted;
  Visibility brute(w.none, method("sf-epeck"), uncounted), lanes(w.bvh, method("sf-filtered"), tally);
  Random random(seed);
  const auto any_face = [&] { return static_cast<std::uint32_t>(random.below(w.none.triangles.size())); };
  std::vector<RayQuestion> rays;
  std::vector<SegmentQuestion> ways, starts;
  for (int i = 0; i < count; ++i) {
    const Ray ray = any_ray(random, w.none.triangles);
    const Segment way{ray.o, ray.o + 2.0 * ray.d.v};
    rays.push_back({ray});
    ways.push_back({way});
    starts.push_back({way, {any_face(), any_face()}});
  }
  in_spans<RayQuestion>(random, rays, [&](auto some) { lanes.first_hits(some); });
  in_spans<SegmentQuestion>(random, ways, [&](auto some) { lanes.blocked(some); });
  in_spans<SegmentQuestion>(random, starts, [&](auto some) { lanes.met(some); });
  for (std::size_t i = 0; i < rays.size(); ++i) {
    ASSERT_EQ(rays[i].face, brute.first_hit(rays[i].ray)) << "seed " << seed << " ray " << i;
    ASSERT_EQ(ways[i].met, brute.is_blocked(ways[i].way)) << "seed " << seed << " way " << i;
    ASSERT_EQ(starts[i].met, brute.meets_any(starts[i].way, starts[i].excluded)) << "seed " << seed << " start " << i;
  }
}

TEST_P(Packets, SeeWhatBruteForceSees) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) compare(nasty_scene(seed), seed + 500, 400);
}

TEST_P(Packets, SeePolygonsAsBruteForceDoes) {
  for (const char* name : {"paper-2a", "paper-2d", "paper-2g"}) {
    compare(read_scene("data/scenes/" + std::string(name) + ".json"), 31, 800);
  }
}

/// The answer of the vector lanes alone.
PacketAnswer first_hits(const World& world, const std::vector<PolygonFigures>& figures, const std::vector<Ray>& rays,
                        std::size_t from) {
  ProbePacket packet;
  for (std::size_t lane = 0; lane < packet_size; ++lane) {
    packet.set(lane, rays[from + lane].o, rays[from + lane].d.v, no_face, no_face);
  }
  PacketAnswer answer;
  packet_target().first_hits({*world.triangles.tree(), world.polygon_of, figures}, packet, answer);
  return answer;
}

/// In general position the lanes must answer all by themselves, from near and from far; from far that takes the
/// filter by terms.
TEST_P(Packets, GeneralPositionIsTheLanes) {
  for (const double distance : {4.0, 4096.0}) {
    const Scene scene = read_scene("data/scenes/elephant.json");
    const World world = make_world(scene, Format::binary64, Accel::bvh);
    std::vector<FilteredPolygon> polygons;
    std::vector<PolygonFigures> figures;
    for (const PolygonData& p : world.polygons) polygons.emplace_back(p);
    for (const FilteredPolygon& p : polygons) figures.push_back(p.figures());
    Random random(3);
    std::vector<Ray> rays;
    for (int i = 0; i < 4000; ++i) {
      const Triangle t = world.triangles[static_cast<std::uint32_t>(random.below(world.triangles.size()))];
      const Point3 o = distance * random.point(1);
      rays.push_back({o, {t.a + 0.3 * (t.b - t.a) + 0.3 * (t.c - t.a) - o}});
    }
    std::size_t known = 0, hit = 0;
    for (std::size_t from = 0; from < rays.size(); from += packet_size) {
      const PacketAnswer a = first_hits(world, figures, rays, from);
      known += static_cast<std::size_t>(std::popcount(a.known));
      hit += static_cast<std::size_t>(std::popcount(a.known & a.hit));
    }
    EXPECT_GT(known, 3950u) << "from " << distance;
    EXPECT_GT(hit, 3900u) << "from " << distance;
  }
}

/// Two faces at the same place, or so close that bounds in double cannot order them: no lane may be known.
TEST_P(Packets, DoNotOrderWhatIsTooClose) {
  Scene scene;
  Solid s;
  const double up = 0x1p-50;
  s.mesh.vertices = {{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}, {-4, -4, up}, {4, -4, up}, {0, 4, up}};
  s.mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  scene.solids = {s};
  const World world = make_world(scene, Format::binary64, Accel::bvh);
  std::vector<Ray> rays(packet_size, Ray{{0.1, 0.2, 9}, {{0.01, 0.02, -3}}});
  EXPECT_EQ(first_hits(world, {}, rays, 0).known, 0u);
  RayTally tally;
  std::vector<RayQuestion> questions(packet_size, RayQuestion{rays[0]});
  Visibility(world, method("sf-filtered"), tally).first_hits(questions);
  for (const RayQuestion& q : questions) EXPECT_EQ(q.face, 1u);
}

/// A ring around the z axis in a tilted plane, with radii between 3 and 4, and with a hole.
PolygonData gear(Random& random, std::size_t teeth) {
  std::vector<Point3> outside, hole;
  const Point3 u(1, 0.25, 0.5), v(-0.25, 1, -0.125);
  for (std::size_t i = 0; i < teeth; ++i) {
    const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(teeth);
    const double out = 3 + random.unit(), in = 1 + random.unit();
    const auto at = [&](double r) {
      return std::round(4096 * r * std::cos(angle)) * u + std::round(4096 * r * std::sin(angle)) * v;
    };
    outside.push_back(at(out));
    hole.push_back(at(in));
  }
  return PolygonData{}.add(outside).add(hole);
}

/// Polygons with holes and more than 64 vertices, in general position: the lanes must answer all, and rightly.
TEST_P(Packets, JudgePolygonsOfManyVertices) {
  const Method& exact = method("sf-rational");
  Random random(47);
  std::size_t known = 0, hit = 0, asked = 0;
  for (const std::size_t teeth : {20, 40, 63, 64, 65, 100, 200}) {
    const PolygonData polygon = gear(random, teeth);
    const WideTree tree(1, [&](std::uint32_t) { return Primitive{box_of(Polygon(polygon)), {}}; });
    const FilteredPolygon filtered(polygon);
    const std::vector<PolygonFigures> figures{filtered.figures()};
    const std::vector<std::int32_t> polygon_of{0};
    for (int k = 0; k < 60; ++k) {
      ProbePacket packet;
      std::vector<Ray> rays;
      for (std::size_t lane = 0; lane < packet_size; ++lane) {
        const Point3 o = 16384.0 * random.point(1) + Point3(0, 0, 40000);
        rays.push_back({o, {20480.0 * random.point(1) - o}});
        packet.set(lane, rays[lane].o, rays[lane].d.v);
      }
      PacketAnswer a;
      packet_target().first_hits({tree, polygon_of, figures}, packet, a);
      asked += packet_size;
      known += static_cast<std::size_t>(std::popcount(a.known));
      for (std::size_t lane = 0; lane < packet_size; ++lane) {
        if ((a.known >> lane & 1) == 0) continue;
        const bool expected = exact.ask(Query{rays[lane], polygon}).hit;
        hit += expected;
        ASSERT_EQ((a.hit >> lane & 1) != 0, expected) << teeth << " teeth";
      }
    }
  }
  EXPECT_GT(known, asked - asked / 100);
  EXPECT_GT(hit, asked / 20);
}

/// Two planes that cross where the ray meets them, or a few roundings beside: if the lanes order the hits, the order
/// is right. From afar that takes the bounds by terms.
TEST_P(Packets, OrderOnlyWhatTheirBoundsTellApart) {
  Random random(53);
  std::size_t known = 0, asked = 0;
  for (int round = 0; round < 4000; ++round) {
    const double away = std::ldexp(1.0, random.within(0, 30)), gap = std::ldexp(random.unit(), random.within(-56, -12));
    const Point3 x = random.point(1), a = random.point(1), b = random.point(1), tilt = gap * random.point(1);
    const Triangle s{x - 3.0 * a - b, x + 3.0 * a - b, x + 3.0 * b};
    const Triangle t{s.a + tilt, s.b + gap * random.point(1), s.c - tilt};
    const Triangle both[] = {s, t};
    const WideTree tree(2, [&](std::uint32_t i) { return Primitive{box_of(both[i]), both[i]}; });
    ProbePacket packet;
    std::vector<Ray> rays;
    const Point3 eye = away * random.point(1);
    for (std::size_t lane = 0; lane < packet_size; ++lane) {
      rays.push_back({eye, {x + 0.1 * random.unit() * a - eye}});
      packet.set(lane, rays[lane].o, rays[lane].d.v);
    }
    PacketAnswer answer;
    packet_target().first_hits({tree, {}, {}}, packet, answer);
    asked += packet_size;
    for (std::size_t lane = 0; lane < packet_size; ++lane) {
      if ((answer.known & answer.hit) >> lane & 1) {
        ++known;
        const bool hits[] = {intersect(rays[lane], s).hit, intersect(rays[lane], t).hit};
        const auto id = static_cast<std::size_t>(answer.id[lane]);
        ASSERT_TRUE(hits[id]) << "round " << round;
        if (!hits[1 - id]) continue;
        ASSERT_EQ(compare_hits(rays[lane], both[id], both[1 - id]), Sign::negative) << "round " << round;
      }
    }
  }
  EXPECT_GT(known, asked / 20);
  EXPECT_LT(known, asked - asked / 20) << "some are too close";
}

/// One polygon and eight probes at it, of the families that exist to be difficult.
TEST_P(Packets, JudgePolygonsAsTheCoveringTest) {
  const Method& exact = method("sf-rational");
  std::size_t known = 0, certain = 0;
  for (const Family& family : families_of(Operands::polygons)) {
    for (std::uint64_t k = 0; k < 400; ++k) {
      const Trial trial = family.make(Format::binary64, 29, k);
      const PolygonData& polygon = trial.query.polygon();
      const WideTree tree(1, [&](std::uint32_t) { return Primitive{box_of(Polygon(polygon)), {}}; });
      const FilteredPolygon filtered(polygon);
      const std::vector<PolygonFigures> figures{filtered.figures()};
      const std::vector<std::int32_t> polygon_of{0};
      ProbePacket packet;
      const Segment* const s = std::get_if<Segment>(&trial.query.probe);
      const Ray* const r = std::get_if<Ray>(&trial.query.probe);
      for (std::size_t lane = 0; lane < packet_size; ++lane) {
        packet.set(lane, s ? s->p : r->o, s ? s->q : r->d.v, no_face, no_face);
      }
      PacketAnswer a;
      (s ? packet_target().any_hits : packet_target().first_hits)({tree, polygon_of, figures}, packet, a);
      // A probe without a direction has no reciprocals for boxes: it is asked by itself.
      const bool is_point = s ? s->p == s->q : r->d.v == Point3(0);
      certain += !is_point && (s ? filtered.filter_hits(*s) : filtered.filter_hits(*r)).has_value();
      known += a.known == (1U << packet_size) - 1;
      if (a.known == 0) continue;
      const bool hit = exact.ask(trial.query).hit;
      ASSERT_EQ(a.known & a.hit, hit ? a.known : 0) << family.name << " " << k;
    }
  }
  EXPECT_GT(certain, 200u);
  EXPECT_GE(known, certain - certain / 50) << "the lanes tell where the same filter tells of one probe";
}

}  // namespace
}  // namespace tribunal
