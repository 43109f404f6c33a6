// Mesh files: what must be refused, and that the four formats carry the same mesh.
#include <cstring>

#include "tests/tracer/support.h"
#include "tracer/mesh/read_mesh.h"
#include "tracer/mesh/triangulate.h"

namespace tribunal {
namespace {

using testing::refusal_of;
using testing::TemporaryDirectory;

const std::string tetrahedron_off = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
const std::string tetrahedron_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf -3 -2 -1\n";
const std::string ply_header =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
const std::string ply_vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
const std::string ply_faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
const std::string facet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

template <class T>
void append(std::string& bytes, T x) {
  bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
}

/// Binary STL of the tetrahedron, announcing `count` triangles.
std::string binary_stl(std::uint32_t count, float first = 0) {
  std::string bytes = "solid but binary" + std::string(64, ' ');
  append(bytes, count);
  const float v[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (const auto& f : faces) {
    for (int i = 0; i < 3; ++i) append(bytes, 0.0f);
    for (const int corner : f) {
      for (const float x : v[corner]) append(bytes, x == 0 ? first : x);
    }
    append(bytes, std::uint16_t{0});
  }
  return bytes;
}

std::string binary_ply(bool big) {
  std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                      "_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                      "element face 4\nproperty list uchar uint vertex_indices\nend_header\n";
  const auto put = [&](auto x) {
    std::string raw;
    append(raw, x);
    if (big) std::reverse(raw.begin(), raw.end());
    bytes += raw;
  };
  const float v[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::uint32_t faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  for (const auto& p : v) {
    for (const float x : p) put(x);
  }
  for (const auto& f : faces) {
    put(std::uint8_t{3});
    for (const std::uint32_t i : f) put(i);
  }
  return bytes;
}

struct BadFile {
  const char* name;
  std::string bytes;
  const char* message;  ///< a part of the expected line
};

std::vector<BadFile> bad_files() {
  const auto ply = [](const std::string& from, const std::string& to) {
    std::string text = ply_header + ply_vertices + ply_faces;
    return text.replace(text.find(from), from.size(), to);
  };
  const auto off = [](const std::string& from, const std::string& to) {
    std::string text = tetrahedron_off;
    return text.replace(text.find(from), from.size(), to);
  };
  const std::string solid = "solid s\n" + facet + "endsolid s\n";
  return {
      {"empty.off", "", "is empty"},
      {"blank.off", "\n\n", "file ends early, expected \"OFF\""},
      {"magic.off", "PLY\n1 1 0\n", "starts with \"PLY\""},
      {"binary.off", "OFF BINARY\n", "binary OFF"},
      {"four.off", "4OFF\n1 1 0\n", "starts with \"4OFF\""},
      {"mesh.xyz", "0 0 0\n", "unknown mesh format \".xyz\""},
      {"negative.off", off("4 4 0", "-4 4 0"), "announces -4 vertices"},
      {"nofaces.off", off("4 4 0", "4 0 0"), "announces 0 faces"},
      {"bomb.off", off("4 4 0", "4000000000 4 0"), "more than the file's"},
      {"overflow.off", off("4 4 0", "99999999999999999999 4 0"), ":2:"},
      {"facebomb.off", off("4 4 0", "4 4000000000 0"), "more than the file's"},
      {"degree.off", off("3 0 2 1", "2000000000 0 2 1"), ":7: face announces 2000000000 corners"},
      {"degree2.off", off("3 0 2 1", "2 0 2"), ":7: face with 2 corners"},
      {"degree0.off", off("3 0 2 1", "0"), "face with 0 corners"},
      {"index.off", off("3 0 2 1", "3 0 2 4"), ":7: vertex index 4 is out of range"},
      {"index-.off", off("3 0 2 1", "3 0 -2 1"), "vertex index -2 is out of range"},
      {"fraction.off", off("3 0 2 1", "3 0 2.5 1"), "expected a vertex index"},
      {"nan.off", off("0 1 0", "0 nan 0"), ":5: \"nan\" is not finite"},
      {"inf.off", off("0 1 0", "inf 1 0"), "not finite"},
      {"huge.off", off("0 1 0", "0 1e999 0"), ":5: number \"1e999\" is out of range"},
      {"hex.off", off("0 1 0", "0 0x1p0 0"), "not a decimal number"},
      {"two.off", off("0 1 0", "0 1"), "too few numbers"},
      {"vertexcut.off", off("4 4 0", "7 1 0").substr(0, 48), "file ends early, expected 7 vertices"},
      {"facecut.off", tetrahedron_off.substr(0, 58), "file ends early, expected 4 faces"},
      {"trailing.off", tetrahedron_off + "3 0 1 2\n", ":11: trailing"},
      {"nul.off", off("0 1 0", std::string("0 \0 0", 5)), "NUL byte"},
      {"empty.obj", "# nothing\n", "no vertices"},
      {"nofaces.obj", "v 0 0 0\n", "no faces"},
      {"zero.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", ":4: vertex index 0"},
      {"beyond.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", ":4: vertex index 4 is out of range"},
      {"back.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 1 2\n", ":4: vertex index -4"},
      {"edge.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2\n", ":4: face with 2 corners"},
      {"nan.obj", "v 0 nan 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", ":1: \"nan\" is not finite"},
      {"word.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 x\n", "expected a vertex index"},
      {"keyword.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nbanana\nf 1 2 3\n", "CGAL's reader refuses"},
      {"empty.ply", "", "is empty"},
      {"magic.ply", "plx\n", "expected \"ply\""},
      {"format.ply", ply("ascii", "ebcdic"), ":2: format \"ebcdic\""},
      {"negative.ply", ply("vertex 4", "vertex -4"), "announces -4 items"},
      {"bomb.ply", ply("face 4", "face 4000000000"), "more than the file's"},
      {"more.ply", ply("face 4", "face 5"), "file ends early"},
      {"less.ply", ply("face 4", "face 3"), "trailing data"},
      {"index.ply", ply("3 0 2 1", "3 0 2 4"), "vertex index 4 is out of range"},
      {"degree.ply", ply("3 0 2 1", "200 0 2 1"), "more than the file could hold"},
      {"degree2.ply", ply("3 0 2 1", "2 0 2"), "has 2 corners"},
      {"nan.ply", ply("1 0 0", "1 nan 0"), "not finite"},
      {"x.ply", ply("property double x", "property double w"), "without x"},
      {"list.ply", ply("vertex_indices", "corners"), "without corners"},
      {"type.ply", ply("uchar int", "float int"), "expected an integer type"},
      {"header.ply", ply_header.substr(0, 60), "expected"},
      {"bincut.ply", binary_ply(false).substr(0, binary_ply(false).size() - 1), "more than the file could hold"},
      {"bintail.ply", binary_ply(false) + "x", "trailing data"},
      {"magic.stl", "hello", "neither text"},
      {"empty.stl", "", "is empty"},
      {"nofacets.stl", "solid s\nendsolid s\n", "no facets"},
      {"cut.stl", "solid s\n" + facet, "file ends early"},
      {"facetcut.stl", "solid s\n" + facet.substr(0, 60), "expected"},
      {"tail.stl", solid + "garbage\n", ":10: trailing"},
      {"nan.stl", "solid s\n" + std::string(facet).replace(facet.find("1 0 0"), 5, "1 nan 0") + "endsolid\n",
       "not finite"},
      {"four.stl",
       "solid s\n" + std::string(facet).replace(facet.find("endloop"), 7, "vertex 0 0 1\nendloop") + "endsolid\n",
       "expected \"endloop\""},
      {"binnan.stl", binary_stl(4, std::numeric_limits<float>::quiet_NaN()), "not finite"},
      {"bincount.stl", "x" + binary_stl(4000000000u).substr(1), "does not fit its size"},
      {"bincut.stl", "x" + binary_stl(4).substr(1, 200), "does not fit its size"},
      {"bintail.stl", "x" + binary_stl(4).substr(1) + "x", "does not fit its size"},
  };
}

TEST(ReadMesh, RefusesBadFilesInOneLine) {
  const TemporaryDirectory directory;
  for (const BadFile& bad : bad_files()) {
    SCOPED_TRACE(bad.name);
    const std::string path = directory.file(bad.name, bad.bytes);
    const std::string line = refusal_of([&] { read_mesh(path); });
    EXPECT_TRUE(line.starts_with(path + ":")) << line;
    EXPECT_NE(line.find(bad.message), std::string::npos) << line;
  }
}

TEST(ReadMesh, RefusesWhatIsNoFile) {
  const TemporaryDirectory directory;
  EXPECT_NE(refusal_of([&] { read_mesh(directory.path("missing.off")); }).find("cannot read"), std::string::npos);
  std::filesystem::create_directory(directory.path("directory.off"));
  EXPECT_NE(refusal_of([&] { read_mesh(directory.path("directory.off")); }).find("directory"), std::string::npos);
}

/// Every prefix of every format is either refused in one line or, for the last blanks, the whole mesh.
TEST(ReadMesh, RefusesEveryTruncation) {
  const TemporaryDirectory directory;
  const std::pair<const char*, std::string> wholes[] = {{".off", tetrahedron_off},
                                                        {".ply", ply_header + ply_vertices + ply_faces},
                                                        {".ply", binary_ply(true)},
                                                        {".stl", binary_stl(4)},
                                                        {".stl", "solid s\n" + facet + "endsolid s\n"}};
  for (const auto& [extension, whole] : wholes) {
    std::size_t accepted = 0;
    for (std::size_t n = 0; n < whole.size(); ++n) {
      const std::string path = directory.file(std::string("cut") + extension, whole.substr(0, n));
      try {
        read_mesh(path);
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
  expect_same(off, read_mesh(directory.file("t.ply", ply_header + ply_vertices + ply_faces)));
  expect_same(off, read_mesh(directory.file("little.ply", binary_ply(false))));
  expect_same(off, read_mesh(directory.file("big.ply", binary_ply(true))));
  expect_same(off, read_mesh(directory.file("t.stl", stl + "endsolid t\n")));
  expect_same(off, read_mesh(directory.file("binary.STL", binary_stl(4))));
  expect_same(off, read_mesh(directory.file("crlf.off", crlf)));
  expect_same(off,
              read_mesh(directory.file("comments.off", "OFF # a comment\n\n# one more\n" + tetrahedron_off.substr(4))));
}

TEST(ReadMesh, ReadsNumbersCorrectly) {
  const TemporaryDirectory directory;
  const std::string long_tenth = "0.1" + std::string(400, '0');
  const Mesh mesh = read_mesh(directory.file("n.off", "OFF\n3 1 0\n" + long_tenth +
                                                          " 4.9406564584124654e-324 -0\n1.7976931348623157e308 +2 3e0\n"
                                                          "9007199254740993 1e-310 0.3\n3 0 1 2\n"));
  EXPECT_EQ(mesh.vertices[0], Point3(0.1, 0x1p-1074, 0));
  EXPECT_EQ(mesh.vertices[1], Point3(std::numeric_limits<double>::max(), 2, 3));
  EXPECT_EQ(mesh.vertices[2], Point3(9007199254740992.0, 1e-310, 0.3));
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
