// Mesh files by name: that the four formats carry the same mesh, that no part of a file passes for the whole, and what
// is made of faces.
#include "exact/mesh/read_mesh.h"

#include "exact/mesh/triangulate.h"
#include "tests/exact/mesh/mesh_files.h"

namespace tribunal {
namespace {

using namespace testing;

TEST(ReadMesh, RefusesWhatIsNoFile) {
  const TemporaryDirectory directory;
  EXPECT_NE(refusal_of([&] { read_mesh(directory.path("missing.off")); }).find("cannot read"), std::string::npos);
  EXPECT_NE(refusal_of([&] { read_mesh(directory.path("m.xyz")); }).find("unknown mesh format \".xyz\""),
            std::string::npos);
  std::filesystem::create_directory(directory.path("directory.off"));
  EXPECT_NE(refusal_of([&] { read_mesh(directory.path("directory.off")); }).find("directory"), std::string::npos);
}

/// Every prefix of every format is either refused in one line or, for the last blanks, the whole mesh.
TEST(ReadMesh, RefusesEveryTruncation) {
  const std::pair<const char*, std::string> wholes[] = {{".off", tetrahedron_off},
                                                        {".ply", tetrahedron_ply},
                                                        {".ply", binary_ply(true)},
                                                        {".stl", binary_stl(4)},
                                                        {".stl", "solid s\n" + facet + "endsolid s\n"}};
  for (const auto& [extension, whole] : wholes) {
    std::size_t accepted = 0;
    for (std::size_t n = 0; n < whole.size(); ++n) {
      try {
        read_soup(std::string("cut") + extension, whole.substr(0, n));
        ++accepted;
      } catch (const Failure& failure) {
        ASSERT_EQ(failure.exit(), Exit::bad_input);
      }
    }
    EXPECT_LE(accepted, 3u) << extension << ": only a missing line end or solid name may be forgiven";
  }
}

std::vector<Triangle> triangles_of(const Mesh& mesh) {
  std::vector<Triangle> list;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) list.push_back(mesh.triangle(i));
  return list;
}

void expect_same(const Mesh& a, const Mesh& b) {
  const auto s = triangles_of(a), t = triangles_of(b);
  ASSERT_EQ(s.size(), t.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    EXPECT_TRUE(s[i].a == t[i].a && s[i].b == t[i].b && s[i].c == t[i].c) << "triangle " << i;
  }
}

TEST(ReadMesh, ReadsTheSameMeshFromEveryFormat) {
  const TemporaryDirectory directory;
  const Mesh off = read_mesh(directory.file("t.off", tetrahedron_off));
  EXPECT_EQ(off.vertices.size(), 4u);
  ASSERT_EQ(off.triangles.size(), 4u);
  std::string stl = "solid t\n";
  for (const Triangle& t : triangles_of(off)) {
    stl += "facet normal 0 0 0\nouter loop\n";
    for (const Point3& v : {t.a, t.b, t.c}) {
      stl += "vertex " + std::to_string(v.x) + " " + std::to_string(v.y) + " " + std::to_string(v.z) + "\n";
    }
    stl += "endloop\nendfacet\n";
  }
  std::string crlf;
  for (const char c : tetrahedron_off) crlf += c == '\n' ? "\r\n" : std::string(1, c);
  expect_same(off, read_mesh(directory.file("t.obj", tetrahedron_obj)));
  expect_same(off, read_mesh(directory.file("t.ply", tetrahedron_ply)));
  expect_same(off, read_mesh(directory.file("little.ply", binary_ply(false))));
  expect_same(off, read_mesh(directory.file("big.ply", binary_ply(true))));
  expect_same(off, read_mesh(directory.file("t.stl", stl + "endsolid t\n")));
  expect_same(off, read_mesh(directory.file("binary.STL", binary_stl(4))));
  expect_same(off, read_mesh(directory.file("crlf.off", crlf)));
  expect_same(off,
              read_mesh(directory.file("comments.off", "OFF # a comment\n\n# one more\n" + tetrahedron_off.substr(4))));
}

TEST(ReadMesh, FansConvexPolygons) {
  const TemporaryDirectory directory;
  const Mesh mesh =
      read_mesh(directory.file("p.off", "OFF\n5 2 0\n0 0 1\n2 0 1\n3 1 1\n2 2 1\n0 2 1\n5 0 1 2 3 4\n4 4 3 2 0\n"));
  EXPECT_EQ(mesh.triangles.size(), 5u);
}

TEST(ReadMesh, KeepsConcavePolygons) {
  const TemporaryDirectory directory;
  const std::string pentagram = "OFF\n5 1 0\n0 3 0\n2 -3 0\n-3 1 0\n3 1 0\n-2 -3 0\n5 0 1 2 3 4\n";
  const Mesh mesh = read_mesh(directory.file("pentagram.off", pentagram));
  EXPECT_TRUE(mesh.triangles.empty());
  ASSERT_EQ(mesh.polygons.size(), 1u);
  EXPECT_EQ(mesh.polygons[0][0].size(), 5u);
  EXPECT_NE(refusal_of([&] { triangulated(mesh, "pentagram.off"); }).find("its edges cross"), std::string::npos);
}

TEST(ReadMesh, KeepsFacesWithoutArea) {
  const TemporaryDirectory directory;
  const Mesh mesh = read_mesh(directory.file("d.off", "OFF\n3 3 0\n0 0 0\n1 1 1\n2 2 2\n3 0 1 2\n3 0 0 0\n3 0 1 2\n"));
  EXPECT_EQ(mesh.triangles.size(), 3u);
}

}  // namespace
}  // namespace tribunal
