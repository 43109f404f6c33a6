// Faces as fans, polygons and triangles, held against the even-odd region of their rings, in integers.
#include "exact/mesh/triangulate.h"

#include <gtest/gtest.h>

#include "tests/exact/mesh/lattice_faces.h"

namespace tribunal {
namespace {

TEST(MeshOf, MakesAFanOnlyWhereItIsTheFace) {
  Draw draw(9, 1, 0);
  int fans = 0, polygons = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Face face = draw_face(draw, 0);
    PolygonSoup soup{face.points, face.indices[0], {}};
    soup.end_face();
    const Mesh mesh = mesh_of(std::move(soup));
    (mesh.polygons.empty() ? fans : polygons) += 1;
    if (mesh.polygons.empty()) expect_tiles(face, mesh.triangles);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(fans, 3000);
  EXPECT_GT(polygons, 3000);
}

/// It went once around, and again; both times to the left, and seen from the first vertex within half a turn.
TEST(MeshOf, ARingThatStartsAgainThroughItsFirstVertexIsNoFan) {
  const std::array<Point3, 2> plane = {Point3(1, 0, 0), Point3(0, 1, 0)};
  for (const Outline& ring : {Outline{{4, 8}, {12, 8}, {12, 4}, {0, 8}, {8, 8}, {12, 4}},
                              Outline{{0, 0}, {4, 0}, {0, 4}, {0, 0}, {4, 0}, {0, 4}},
                              Outline{{0, 0}, {0, 0}, {4, 0}, {0, 4}, {0, 0}, {4, 0}, {0, 4}}}) {
    Face face;
    face.add(ring, plane);
    PolygonSoup soup{face.points, face.indices[0], {}};
    soup.end_face();
    EXPECT_EQ(mesh_of(std::move(soup)).polygons.size(), 1U) << face.words();
    EXPECT_FALSE(triangulate(face.indices, face.points)) << face.words();
  }
}

TEST(MeshOf, ARepeatedFirstVertexHarmsNoFan) {
  PolygonSoup soup{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {0, 0, 1, 2, 3, 0}, {}};
  soup.end_face();
  EXPECT_TRUE(mesh_of(std::move(soup)).polygons.empty());
}

TEST(Triangulate, TilesTheFaceOrRefusesIt) {
  Draw draw(9, 2, 0);
  int tiled = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Face face = draw_face(draw, i % 4 == 0 ? 1 : 0);
    const auto triangles = triangulate(face.indices, face.points);
    tiled += triangles.has_value();
    if (triangles) expect_tiles(face, *triangles);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(tiled, 3000);
}

/// A square that touches itself at the tip of a spike, and one with a hole that touches it.
TEST(Triangulate, RingsThatTouchAreTiledWhereTheyCanBe) {
  const std::array<Point3, 2> plane = {Point3(1, 0, 0), Point3(0, 1, 0)};
  Face notched;
  notched.add({{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}}, plane);
  Face holed;
  holed.add({{0, 0}, {8, 0}, {8, 8}, {0, 8}}, plane);
  holed.add({{0, 0}, {4, 2}, {2, 4}}, plane);
  for (const Face& face : {notched, holed}) {
    const auto triangles = triangulate(face.indices, face.points);
    ASSERT_TRUE(triangles) << face.words();
    expect_tiles(face, *triangles);
  }
}

}  // namespace
}  // namespace tribunal
