// Polygonal solids: read, hit as polygons, and the same picture when triangulated.
#include <map>

#include "exact/mesh/triangulate.h"
#include "tests/tracer/support.h"
#include "tracer/render/render.h"
#include "tracer/scene/read_scene.h"

namespace tribunal {
namespace {

using testing::method;
using testing::refusal_of;

const char* const piece_scenes[] = {"paper-2a", "paper-2c", "paper-2d", "paper-2e", "paper-2f", "paper-2g"};

Scene small(const std::string& name, int side) {
  Scene scene = read_scene("data/scenes/" + name + ".json");
  scene.camera.width = side;
  scene.camera.height = side;
  return scene;
}

/// How often each edge is run along one way more than the other, and how many edges have more than two faces.
std::pair<int, int> open_and_crowded_edges(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> edges;
  const auto add = [&](std::uint32_t a, std::uint32_t b) { ++(a < b ? edges[{a, b}].first : edges[{b, a}].second); };
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) add(t[i], t[(i + 1) % 3]);
  }
  for (const Rings& face : mesh.polygons) {
    for (const auto& ring : face) {
      for (std::size_t i = 0; i < ring.size(); ++i) add(ring[i], ring[(i + 1) % ring.size()]);
    }
  }
  std::pair<int, int> count{0, 0};
  for (const auto& [edge, ways] : edges) {
    count.first += ways.first != ways.second;
    count.second += ways.first + ways.second > 2;
  }
  return count;
}

TEST(Solids, AreClosedAndAsDescribed) {
  const Scene pair = small("paper-2a", 8);
  const auto size = [](const Solid& s) {
    return std::pair(s.mesh.vertices.size(), s.mesh.triangles.size() + s.mesh.polygons.size());
  };
  EXPECT_EQ(size(pair.solids[1]), std::pair(std::size_t{30}, std::size_t{18}));
  EXPECT_EQ(size(pair.solids[2]), std::pair(std::size_t{40}, std::size_t{28}));
  for (const char* name : piece_scenes) {
    const Scene scene = small(name, 8);
    for (std::size_t i = 1; i < scene.solids.size(); ++i) {
      EXPECT_EQ(open_and_crowded_edges(scene.solids[i].mesh).first, 0) << name << " " << scene.solids[i].name;
    }
  }
  EXPECT_EQ(open_and_crowded_edges(small("paper-2e", 8).solids[1].mesh).second, 1) << "one edge of four faces";
}

/// Every face is a polygon of the world, and each method sees the triangulated world as it sees the polygons.
TEST(Polygons, TriangulatedGiveTheSamePicture) {
  for (const char* name : piece_scenes) {
    const Scene scene = small(name, 48);
    const World polygons = make_world(scene, Format::binary64, Accel::bvh);
    EXPECT_FALSE(polygons.polygons.empty()) << name;
    const Rendering expected = render(polygons, method("sf-filtered"), {2, 2});
    EXPECT_GT(expected.tally.polygon_hits, 1000u) << name;
    const World triangles = make_world(scene, Format::binary64, Accel::bvh, Faces::triangulated);
    EXPECT_TRUE(triangles.polygons.empty());
    const Rendering other = render(triangles, method("sf-filtered"), {2, 2});
    EXPECT_TRUE(expected.image == other.image) << name;
    EXPECT_EQ(other.tally.polygon_tests, 0u);
  }
}

/// The classical polygon tests in double run too, on the same scene.
TEST(Polygons, AreTestedByEveryMethodThatTakesThem) {
  const Scene scene = small("paper-2c", 32);
  const World world = make_world(scene, Format::binary64, Accel::boxes);
  for (const char* name : {"sf-double", "sf-epick", "sf-epeck", "feito-double"}) {
    const Rendering r = render(world, method(name), {1, 1});
    EXPECT_GT(r.tally.polygon_hits, 500u) << name;
  }
}

TEST(Triangulate, TilesAHoledConcaveFace) {
  const std::vector<Point3> points = {{0, 0, 1}, {9, 0, 1}, {9, 9, 1}, {6, 9, 1}, {6, 4, 1},
                                      {3, 4, 1}, {3, 9, 1}, {0, 9, 1}, {4, 1, 1}, {5, 1, 1},
                                      {5, 3, 1}, {4, 3, 1}, {1, 6, 1}, {2, 7, 1}, {1, 8, 1}};
  const auto triangles = triangulate({{0, 1, 2, 3, 4, 5, 6, 7}, {8, 11, 10, 9}, {12, 13, 14}}, points);
  ASSERT_TRUE(triangles);
  EXPECT_EQ(triangles->size(), 15u + 2 * 2 - 2);
  double twice_area = 0;
  for (const auto& t : *triangles) {
    const Point3 u = points[t[1]] - points[t[0]], v = points[t[2]] - points[t[0]];
    EXPECT_GT(u.x * v.y - u.y * v.x, 0);
    twice_area += u.x * v.y - u.y * v.x;
  }
  EXPECT_EQ(twice_area, 2 * (81 - 15 - 2 - 1));
}

TEST(Solids, AreRefusedNamingThePlace) {
  const testing::TemporaryDirectory directory;
  const std::string head =
      R"({"camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "fov": 40, "width": 4, "height": 3}, )"
      R"("solids": [{"solid": "s.json"}]})";
  const auto refusal = [&](const std::string& solid) {
    directory.file("s.json", solid);
    return refusal_of([&] { parse_scene(head, directory.path("scene.json")); });
  };
  const std::string points = R"({"vertices": [[0,0,0],[1,0,0],[0,1,0]], )";
  EXPECT_NE(refusal("").find("s.json: is empty"), std::string::npos);
  EXPECT_NE(refusal(points + R"("faces": [[[0,1,2],[0,1]]]})").find("faces[0][1]: expected an array"),
            std::string::npos);
  EXPECT_NE(refusal(points + R"("faces": [[[0,1,3]]]})").find("faces[0][0][2]: expected a whole number from 0 to 2"),
            std::string::npos);
  EXPECT_NE(refusal(points + R"("fases": []})").find("did you mean \"faces\""), std::string::npos);
  EXPECT_NE(refusal(points + R"("faces": []})").find("at least one face"), std::string::npos);
}

}  // namespace
}  // namespace tribunal
