// Starts of secondary rays: what is proved of them, checked by brute force with the reference method.
#include "tracer/shading/departure.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "exact/kernels/rational_kernel.h"
#include "tests/tracer/support.h"
#include "tracer/scene/read_scene.h"
#include "tracer/shading/camera_rays.h"

namespace tribunal {

namespace {

using testing::method;
using testing::Random;

/// The faces that a closed segment meets, one by one, by the reference method.
std::vector<std::uint32_t> met(const World& world, const Segment& way) {
  std::vector<std::uint32_t> ids;
  for (std::uint32_t id = 0; id < world.triangles.size(); ++id) {
    const PolygonData* polygon = world.polygon(id);
    const Answer a = polygon ? method("sf-rational").ask(Query{way, *polygon})
                             : method("sf-rational").segment(way, world.triangles[id]);
    if (is_visible_hit(a)) ids.push_back(id);
  }
  return ids;
}

Contact contact_of(const World& world, const Ray& ray, std::uint32_t id) {
  const PolygonData* polygon = world.polygon(id);
  return polygon ? method("sf-rational").ask(Query{ray, *polygon}).contact
                 : method("sf-rational").ray(ray, world.triangles[id]).contact;
}

struct Starts {
  int asked = 0;
  RayTally tally{};
};

/// Checks the starts on both sides of a ray's hit against their definition.
void check(const World& world, const Ray& ray, Visibility& eye, Departures& departures, Starts& starts) {
  const auto id = eye.first_hit(ray);
  if (!id) return;
  const Triangle& t = world.triangles[*id];
  const HitParameter<double> h = hit_parameter<double>(ray, t);
  Point3 normal = normalised(glm::cross(t.b - t.a, t.c - t.a));
  if (glm::dot(normal, ray.d.v) > 0) normal = -normal;
  const HitPoint at{ray.o, *id, ray.o + (h.num / h.den) * ray.d.v, normal};
  const RationalKernel k;
  const std::uint64_t unproved = starts.tally.starts_unproved;
  const Departure start = departures.near_side(at);
  const Point3 near = start.point, far = departures.far_side(at, start).point;
  if (starts.tally.starts_unproved != unproved) {
    EXPECT_NE(contact_of(world, ray, *id), Contact::interior) << "only where an edge is grazed";
    EXPECT_EQ(far, near);
    return;
  }
  ++starts.asked;
  const Sign side = k.orient3d(t.a, t.b, t.c, ray.o);
  EXPECT_EQ(k.orient3d(t.a, t.b, t.c, near), side);
  EXPECT_EQ(k.orient3d(t.a, t.b, t.c, far), -side);
  EXPECT_TRUE(met(world, {ray.o, near}).empty());
  EXPECT_EQ(met(world, {near, far}), std::vector<std::uint32_t>{*id});
}

/// Rays aimed at vertices, at edges and at points of faces, with scenes so far from the origin that a constant step
/// is lost to rounding.
TEST(Departures, AreProvedAtVerticesEdgesAndFaces) {
  for (const double offset : {0.0, 0x1p20, 0x1p40, 0x1p50}) {
    Scene scene = read_scene("data/scenes/paper-2a.json");
    for (Solid& s : scene.solids) {
      for (Point3& v : s.mesh.vertices) v = 64.0 * v + Point3(offset, -offset, offset);
    }
    const World world = make_world(scene, Format::binary64, Accel::bvh);
    ASSERT_GT(world.polygons.size(), 30u);
    Starts starts;
    Visibility eye(world, method("sf-filtered"), starts.tally);
    KnownFaces faces(world);
    Departures departures(world, method("sf-filtered"), eye, faces, starts.tally);
    Random random(3);
    for (int i = 0; i < 150; ++i) {
      const Triangle& t = world.triangles[static_cast<std::uint32_t>(random.below(world.triangles.size()))];
      const Point3 targets[] = {t.a, 0.5 * (t.a + t.b), t.a + 0.25 * (t.b - t.a) + 0.25 * (t.c - t.a)};
      const Point3 target = targets[random.below(3)];
      const Point3 o = target + random.point(4096);
      check(world, {o, {target - o}}, eye, departures, starts);
    }
    EXPECT_GT(starts.asked, 100) << "offset " << offset;
    EXPECT_LT(starts.tally.starts_unproved, 30u) << "offset " << offset;
  }
}

/// An eye on a face has no side; two faces that coincide cannot be crossed one at a time.
TEST(Departures, SayWhereNothingCanBeProved) {
  Scene scene;
  Solid s;
  s.mesh.vertices = {{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}};
  s.mesh.triangles = {{0, 1, 2}, {0, 1, 2}};
  scene.solids = {s};
  const World world = make_world(scene, Format::binary64, Accel::bvh);
  RayTally tally;
  Visibility eye(world, method("sf-filtered"), tally);
  KnownFaces faces(world);
  Departures departures(world, method("sf-filtered"), eye, faces, tally);
  const HitPoint on_face{{0, 0, 0}, 0, {0, 0, 0}, {0, 0, 1}};
  departures.near_side(on_face);
  EXPECT_EQ(tally.starts_unproved, 1u);
  const HitPoint twice{{0, 0, 1}, 0, {0, 0, 0}, {0, 0, 1}};
  departures.far_side(twice, departures.near_side(twice));
  EXPECT_EQ(tally.starts_unproved, 2u);
}

/// Inexact methods step by the scene's bias, and nothing is tested for it.
TEST(Departures, AreCustomaryForInexactMethods) {
  Scene scene = read_scene("data/scenes/dark-box.json");
  const World world = make_world(scene, Format::binary64, Accel::bvh);
  RayTally tally;
  Visibility eye(world, method("sf-double"), tally);
  KnownFaces faces(world);
  Departures departures(world, method("sf-double"), eye, faces, tally);
  const HitPoint at{{0, 0, 0}, 0, {0, 0, -1}, {0, 0, 1}};
  EXPECT_EQ(departures.near_side(at).point, Point3(0, 0, -1 + world.step));
  EXPECT_EQ(departures.far_side(at, {}).point, Point3(0, 0, -1 - world.step));
  EXPECT_EQ(tally.start_tests, 0u);
}

}  // namespace
}  // namespace tribunal
