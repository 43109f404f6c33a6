#include "exact/mesh/topology.h"

#include <gtest/gtest.h>

#include "tracer/scene/read_scene.h"

namespace tribunal {
namespace {

Mesh tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

/// The mesh with separate vertices for each triangle.
Mesh loosened(const Mesh& mesh) {
  Mesh loose;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle t = mesh.triangle(i);
    const auto n = static_cast<std::uint32_t>(loose.vertices.size());
    loose.vertices.insert(loose.vertices.end(), {t.a, t.b, t.c});
    loose.triangles.push_back({n, n + 1, n + 2});
  }
  return loose;
}

Mesh solid_mesh(const std::string& name) {
  const std::string text =
      R"({"camera": {"eye": [0, 0, 9], "look_at": [0, 0, 0], "up": [0, 1, 0], "fov": 40, "width": 2,
    "height": 2}, "solids": [{"solid": ")" +
      name + R"(.json"}]})";
  return parse_scene(text, "data/solids/scene.json").solids[0].mesh;
}

TEST(Topology, ATetrahedronIsClosedAndOriented) {
  const Topology t = topology_of(tetrahedron());
  EXPECT_EQ(t.edges, 6u);
  EXPECT_TRUE(t.closed() && t.oriented());
  EXPECT_EQ(t.crowded, 0u);
  EXPECT_TRUE(t.sound());
  EXPECT_EQ(describe(t), "closed, oriented");
}

TEST(Topology, FacesThatAllLookInwards) {
  Mesh mesh = tetrahedron();
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(describe(topology_of(mesh)), "closed, oriented, but its faces look inwards");
  EXPECT_FALSE(topology_of(mesh).sound());
  for (Point3& v : mesh.vertices) v += Point3(0x1p40);
  EXPECT_TRUE(topology_of(mesh).inward);
}

TEST(Topology, PlacesCountNotIndicesAndMinusZeroIsZero) {
  Mesh loose = loosened(tetrahedron());
  loose.vertices[0].y = -0.0;
  const Topology t = topology_of(loose);
  EXPECT_EQ(t.edges, 6u);
  EXPECT_TRUE(t.oriented());
}

TEST(Topology, AMissingFaceOpensThreeEdges) {
  Mesh mesh = tetrahedron();
  mesh.triangles.pop_back();
  const Topology t = topology_of(mesh);
  EXPECT_EQ(t.odd, 3u);
  EXPECT_FALSE(t.closed() || t.oriented() || t.sound());
  EXPECT_EQ(describe(t), "open: 3 of 6 edges with an odd number of faces");
}

TEST(Topology, AFaceTurnedAroundIsClosedButNotOriented) {
  Mesh mesh = tetrahedron();
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  const Topology t = topology_of(mesh);
  EXPECT_TRUE(t.closed());
  EXPECT_EQ(t.unmatched, 3u);
  EXPECT_FALSE(t.sound());
  EXPECT_EQ(describe(t), "closed; faces turn against each other along 3 of 6 edges");
}

TEST(Topology, TwoSolidsAlongAnEdgeAreClosedOrientedAndNonManifold) {
  Mesh mesh = tetrahedron();
  mesh.vertices.insert(mesh.vertices.end(), {{0, -1, 0}, {0, 0, -1}});
  for (const auto& t : {std::array{0u, 4u, 1u}, {0u, 1u, 5u}, {1u, 4u, 5u}, {4u, 0u, 5u}}) {
    mesh.triangles.push_back({t[1], t[0], t[2]});
  }
  const Topology t = topology_of(mesh);
  EXPECT_EQ(t.crowded, 1u);
  EXPECT_TRUE(t.closed() && t.oriented());
  EXPECT_FALSE(t.sound());
}

TEST(Topology, HolesOfPolygonsHaveEdgesToo) {
  Mesh mesh{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {2, 1, 0}, {1, 2, 0}}, {}, {}};
  mesh.polygons.push_back({{0, 1, 2, 3}, {4, 5, 6}});
  EXPECT_EQ(topology_of(mesh).odd, 7u);
}

/// The solids that come with the project are what their descriptions say.
TEST(Topology, OfTheSolidsInData) {
  const std::pair<const char*, std::size_t> solids[] = {
      {"channel", 0}, {"comb", 7}, {"cross", 0}, {"gear", 0}, {"plate", 0}, {"edge-pair", 1}, {"vertex-pair", 0}};
  for (const auto& [name, expected] : solids) {
    SCOPED_TRACE(name);
    const Mesh mesh = solid_mesh(name);
    const Topology t = topology_of(mesh);
    EXPECT_TRUE(t.closed() && t.oriented() && !t.inward) << describe(t);
    EXPECT_EQ(t.crowded, expected);
  }
}

}  // namespace
}  // namespace tribunal
