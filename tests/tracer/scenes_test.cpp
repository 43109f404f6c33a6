// The scenes of data/scenes: what each must show, and exact methods' pictures by hash.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "exact/base/sha256.h"
#include "tests/tracer/support.h"
#include "tracer/render/render.h"
#include "tracer/scene/read_scene.h"
#include "tracer/shading/camera_rays.h"

namespace tribunal {
namespace {

using testing::method;

Scene shipped(const std::string& name) { return read_scene("data/scenes/" + name + ".json"); }

std::vector<std::string> all_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator("data/scenes")) {
    if (entry.path().extension() == ".json") names.push_back(entry.path().stem());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// The scene at a quarter of its picture's size, or an eighth with a large mesh; odd sizes stay odd, so that the
/// centre stays under a pixel.
Scene reduced(const std::string& name) {
  Scene scene = shipped(name);
  const auto is_large = [](const Solid& s) { return s.mesh.triangles.size() > 1000; };
  const int divisor = std::any_of(scene.solids.begin(), scene.solids.end(), is_large) ? 8 : 4;
  for (int* side : {&scene.camera.width, &scene.camera.height}) {
    const bool odd = *side % 2 == 1;
    *side /= divisor;
    if (odd) *side |= 1;
  }
  return scene;
}

std::string hash_of(const Image& image) {
  std::string bytes;
  for (const Pixel& p : image.pixels) bytes.append(p.begin(), p.end());
  return sha256(bytes).substr(0, 32);
}

Rendering drawn(const Scene& scene, const char* name, Accel accel, unsigned threads) {
  return render(make_world(scene, Format::binary64, accel), method(name), {scene.depth, threads});
}

/// The rows of data/scenes/expected.tsv: scene → "width height hash".
std::map<std::string, std::string> expected_rows() {
  std::ifstream in("data/scenes/expected.tsv");
  std::map<std::string, std::string> rows;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("#")) rows[line.substr(0, line.find('\t'))] = line;
  }
  return rows;
}

class Scenes : public ::testing::TestWithParam<std::string> {};

struct Way {
  const char* method;
  Accel accel;
  unsigned threads;
};

/// The ways to draw a scene: every acceleration with 1, 2 and 7 threads, by sf-filtered and, if TRIBUNAL_LONG is set
/// in the environment (ten minutes), by sf-rational too.
std::vector<Way> ways() {
  std::vector<Way> all;
  for (const char* name : {"sf-filtered", "sf-rational"}) {
    if (name == std::string("sf-rational") && std::getenv("TRIBUNAL_LONG") == nullptr) continue;
    for (const Accel accel : {Accel::bvh, Accel::boxes, Accel::none}) {
      for (const unsigned threads : {1u, 2u, 7u}) all.push_back({name, accel, threads});
    }
  }
  return all;
}

/// The hashes were taken from pictures that were looked at; where libm differs from Debian 12's a colour may round
/// otherwise.
TEST_P(Scenes, AreDrawnAlikeByExactMethods) {
  const Scene scene = reduced(GetParam());
  const Rendering expected = drawn(scene, "sf-rational", Accel::bvh, 2);
  EXPECT_EQ(expected.tally.starts_unproved, 0u);
  for (const Way& way : ways()) {
    SCOPED_TRACE(std::string(way.method) + ", " + std::string(name_of(way.accel)) + ", " + std::to_string(way.threads) +
                 " threads");
    const Rendering r = drawn(scene, way.method, way.accel, way.threads);
    EXPECT_TRUE(r.image == expected.image);
    EXPECT_EQ(r.decisions, expected.decisions);
  }
  std::ostringstream row;
  row << GetParam() << '\t' << expected.image.width << '\t' << expected.image.height << '\t' << hash_of(expected.image);
  EXPECT_EQ(expected_rows()[GetParam()], row.str()) << "data/scenes/expected.tsv";
}

/// Without this a folder without scenes would be a test of none.
TEST(ShippedScenes, AreThoseWithAPictureExpected) {
  std::vector<std::string> expected;
  for (const auto& [name, row] : expected_rows()) expected.push_back(name);
  EXPECT_EQ(all_scenes(), expected);
  EXPECT_FALSE(expected.empty());
}

INSTANTIATE_TEST_SUITE_P(Shipped, Scenes, ::testing::ValuesIn(all_scenes()), [](const auto& scene) {
  std::string name = scene.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

std::size_t bright_pixels(const Image& image) {
  return static_cast<std::size_t>(std::count_if(image.pixels.begin(), image.pixels.end(), [](const Pixel& p) {
    return p != Pixel{0, 0, 0};
  }));
}

TEST(DarkBox, StaysBlackForExactMethodsOnly) {
  const Scene scene = shipped("dark-box");
  EXPECT_EQ(bright_pixels(drawn(scene, "sf-filtered", Accel::bvh, 2).image), 0u);
  EXPECT_GT(bright_pixels(drawn(scene, "sf-double", Accel::bvh, 2).image), 100u) << "the scene has no teeth";
}

/// The mesh grown to 2¹², so that at 2⁵⁰ its vertices round to a grid of 2⁻²; a closed surface stays closed.
Scene inside_mesh_at(double offset) {
  Scene scene = reduced("inside-mesh");
  const Point3 shift(offset, -offset, offset);
  for (Point3& v : scene.solids[0].mesh.vertices) v = 4096.0 * v + shift;
  for (Point3* p : {&scene.camera.eye, &scene.camera.look_at, &scene.lights[0].position}) *p = 4096.0 * *p + shift;
  return scene;
}

TEST(InsideMesh, NoRayEscapesAtAnyOffset) {
  for (const double offset : {0.0, 0x1p20, 0x1p40, 0x1p50}) {
    const RayTally t = drawn(inside_mesh_at(offset), "sf-filtered", Accel::bvh, 2).tally;
    EXPECT_EQ(t.ray_hits[0], t.rays[0]) << "offset " << offset;
    EXPECT_EQ(t.ray_hits[2], t.rays[2]) << "offset " << offset;
    EXPECT_GT(t.rays[2], 800u);
    EXPECT_EQ(t.starts_unproved, 0u) << "offset " << offset;
  }
  const RayTally naive = drawn(inside_mesh_at(0x1p40), "sf-double", Accel::bvh, 2).tally;
  EXPECT_LT(naive.ray_hits[0] + naive.ray_hits[2], naive.rays[0] + naive.rays[2]) << "the scene has no teeth";
}

/// Seen from the eye, the fan covers a disc of radius 63.9 around its hub: which sliver each ray there meets.
std::vector<std::optional<std::uint32_t>> slivers_seen(const char* name) {
  const Scene scene = shipped("slivers");
  const World world = make_world(scene, Format::binary32, Accel::bvh);
  const CameraRays camera(scene.camera);
  RayTally tally;
  Visibility eye(world, method(name), tally);
  std::vector<std::optional<std::uint32_t>> seen;
  for (int i = 0; i < scene.camera.width * scene.camera.height; ++i) {
    const Ray ray = camera.through(i % scene.camera.width, i / scene.camera.width);
    const double x = ray.d.v.x * 8192, y = ray.d.v.y * 8192;
    if (x * x + y * y < 63.9 * 63.9) seen.push_back(eye.first_hit(ray));
  }
  return seen;
}

TEST(Slivers, LeaveNoHole) {
  const auto seen = slivers_seen("sf-filtered");
  EXPECT_GT(seen.size(), 49000u);
  EXPECT_EQ(std::count(seen.begin(), seen.end(), std::nullopt), 0);
  EXPECT_NE(slivers_seen("mt-float"), seen) << "the scene has no teeth";
}

TEST(EdgeOn, HidesTheSheetInWhosePlaneTheEyeIs) {
  const Scene scene = shipped("edge-on");
  const World world = make_world(scene, Format::binary64, Accel::bvh);
  const CameraRays camera(scene.camera);
  RayTally tally;
  Visibility eye(world, method("sf-filtered"), tally);
  std::map<std::string, int> seen;
  for (int i = 0; i < scene.camera.width * scene.camera.height; ++i) {
    const auto id = eye.first_hit(camera.through(i % scene.camera.width, i / scene.camera.width));
    if (id) ++seen[scene.solids[world.solid_of[*id]].name];
  }
  EXPECT_EQ(seen["sheet 0"], 0);
  EXPECT_GT(seen["sheet -2"], 1000);
  EXPECT_GT(seen["sheet 6"], 1000);
  // The near face spans 4/40 of a view that is 255/512 wide over 255 pixels: from the pixel in x = 0 on, 52 by 52.
  EXPECT_EQ(seen["cube"], 52 * 52);
}

TEST(FacingMirrors, ReflectUntilTheDepth) {
  Scene scene = reduced("facing-mirrors");
  std::uint64_t reflections = 0;
  for (const int depth : {2, 6, 12}) {
    scene.depth = depth;
    const std::uint64_t now = drawn(scene, "sf-filtered", Accel::bvh, 2).tally.rays[2];
    EXPECT_GT(now, reflections);
    reflections = now;
  }
}

}  // namespace
}  // namespace tribunal
