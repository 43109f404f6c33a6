// Our readers against CGAL's, on the meshes of libcgal-demo: as they are, and written anew in every other form.
#include <bit>
#include <charconv>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>

#include "tests/exact/mesh/cgal_readers.h"
#include "tests/exact/mesh/mesh_files.h"

namespace tribunal {
namespace {

using namespace testing;

enum class Verdict { both_accept, only_cgal_accepts, only_we_accept, both_refuse };

struct Difference {
  Verdict verdict;
  const char* why;
};

/// The files of libcgal-demo that the two readers treat differently.
const std::map<std::string, Difference> differences = {
    {"b9.ply", {Verdict::only_cgal_accepts, "a cloud of points: it announces 0 faces, and we ask for a mesh"}},
    {"prim.off", {Verdict::only_cgal_accepts, "a face beyond the announced 7: CGAL stops reading before it"}},
};

Verdict expected_verdict(const std::string& name) {
  const auto row = differences.find(name);
  return row == differences.end() ? Verdict::both_accept : row->second.verdict;
}

std::vector<std::filesystem::path> demo_meshes() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator("data/meshes")) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::optional<PolygonSoup> our_soup(const std::string& file, const std::string& bytes) {
  try {
    return read_soup(file, bytes);
  } catch (const Failure&) {
    return std::nullopt;
  }
}

/// Bit by bit, so that 0 and −0 differ.
bool same(const Point3& a, const Point3& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.z) == bits(b.z);
}

void expect_same(const PolygonSoup& ours, const PolygonSoup& theirs) {
  EXPECT_TRUE(std::equal(ours.points.begin(), ours.points.end(), theirs.points.begin(), theirs.points.end(), same));
  EXPECT_EQ(ours.corners, theirs.corners);
  EXPECT_EQ(ours.ends, theirs.ends);
}

Verdict compare(const std::string& file, const std::string& bytes) {
  const auto ours = our_soup(file, bytes);
  const auto theirs = cgal_soup(file, bytes);
  if (!theirs) return ours ? Verdict::only_we_accept : Verdict::both_refuse;
  if (!ours) return Verdict::only_cgal_accepts;
  expect_same(*ours, *theirs);
  return Verdict::both_accept;
}

TEST(SecondOpinion, OnTheMeshesAsTheyAre) {
  std::size_t both = 0, rows = 0;
  for (const auto& path : demo_meshes()) {
    SCOPED_TRACE(path);
    const std::string name = path.filename();
    const Verdict verdict = compare(name, bytes_of(path));
    EXPECT_EQ(verdict, expected_verdict(name));
    both += verdict == Verdict::both_accept;
    rows += differences.contains(name);
  }
  EXPECT_GE(both, 141u);
  EXPECT_EQ(rows, differences.size()) << "a row is about a file that is not there";
}

/// A numeral that reads back as this number.
std::string numeral(double x) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, x).ptr};
}

std::string line(const Point3& p) { return numeral(p.x) + " " + numeral(p.y) + " " + numeral(p.z) + "\n"; }

std::string as_obj(const PolygonSoup& soup) {
  std::string text = "# written by a test\no mesh\n";
  for (const Point3& p : soup.points) text += "v " + line(p);
  text += "vn 0 0 1\ns off\n";
  for (std::size_t f = 0; f < soup.size(); ++f) {
    text += "f";
    for (const std::uint32_t i : soup.face(f)) text += " " + std::to_string(i + 1) + "//1";
    text += "\n";
  }
  return text;
}

std::string ply_header_of(const PolygonSoup& soup, const char* format) {
  return std::string("ply\nformat ") + format + " 1.0\nelement vertex " + std::to_string(soup.points.size()) +
         "\nproperty double x\nproperty double y\nproperty uchar red\nproperty double z\nelement face " +
         std::to_string(soup.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string as_text_ply(const PolygonSoup& soup) {
  std::string text = ply_header_of(soup, "ascii");
  for (const Point3& p : soup.points) text += numeral(p.x) + " " + numeral(p.y) + " 255 " + numeral(p.z) + "\n";
  for (std::size_t f = 0; f < soup.size(); ++f) {
    text += std::to_string(soup.face(f).size());
    for (const std::uint32_t i : soup.face(f)) text += " " + std::to_string(i);
    text += "\n";
  }
  return text;
}

std::string as_binary_ply(const PolygonSoup& soup, bool big) {
  std::string bytes = ply_header_of(soup, big ? "binary_big_endian" : "binary_little_endian");
  for (const Point3& p : soup.points) bytes += raw(p.x, big) + raw(p.y, big) + "\xff" + raw(p.z, big);
  for (std::size_t f = 0; f < soup.size(); ++f) {
    bytes += static_cast<char>(soup.face(f).size());
    for (const std::uint32_t i : soup.face(f)) bytes += raw(i, big);
  }
  return bytes;
}

/// Each face as its first three corners.
std::string as_text_stl(const PolygonSoup& soup) {
  std::string text = "solid mesh\n";
  for (std::size_t f = 0; f < soup.size(); ++f) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t i : soup.face(f).first(3)) text += "vertex " + line(soup.points[i]);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid mesh\n";
}

std::string as_binary_stl(const PolygonSoup& soup) {
  std::string bytes = std::string(80, 'b') + raw(static_cast<std::uint32_t>(soup.size()));
  for (std::size_t f = 0; f < soup.size(); ++f) {
    bytes.append(12, '\0');
    for (const std::uint32_t i : soup.face(f).first(3)) {
      const Point3& p = soup.points[i];
      bytes += raw(static_cast<float>(p.x)) + raw(static_cast<float>(p.y)) + raw(static_cast<float>(p.z));
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

TEST(SecondOpinion, OnTheMeshesInOtherForms) {
  const std::pair<const char*, std::function<std::string(const PolygonSoup&)>> forms[] = {
      {"m.obj", as_obj},
      {"m.ply", as_text_ply},
      {"little.ply", [](const PolygonSoup& s) { return as_binary_ply(s, false); }},
      {"big.ply", [](const PolygonSoup& s) { return as_binary_ply(s, true); }},
      {"m.stl", as_text_stl},
      {"binary.stl", as_binary_stl}};
  std::size_t both = 0;
  for (const auto& path : demo_meshes()) {
    if (std::filesystem::file_size(path) > 300000) continue;
    const auto soup = our_soup(path.filename(), bytes_of(path));
    if (!soup) continue;
    for (const auto& [file, write] : forms) {
      SCOPED_TRACE(path.string() + " as " + file);
      const Verdict verdict = compare(file, write(*soup));
      EXPECT_EQ(verdict, Verdict::both_accept);
      both += verdict == Verdict::both_accept;
    }
  }
  EXPECT_GT(both, 300u);
}

/// An unusual file, and how CGAL 5.5 reads it.
struct Odd {
  const char* file;
  const char* what;
  std::string bytes;
  Verdict verdict;
};

std::vector<Odd> odd_files() {
  const std::string corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const std::string faces_first =
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nelement vertex 3\n"
      "property double x\nproperty double y\nproperty double z\nend_header\n3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n";
  const std::string floats = edited(tetrahedron_ply, "1 0 0", "0.1 0 1e-3");
  return {
      {"a.obj", "CGAL knows no lines", corner + "l 1 2\nf 1 2 3\n", Verdict::only_we_accept},
      {"b.obj", "CGAL joins no lines", corner + "f 1 2 3 \\\n1\n", Verdict::only_we_accept},
      {"c.obj", "CGAL takes index 0 for the vertex after the last", corner + "f 0 1 2\n", Verdict::only_cgal_accepts},
      {"d.obj", "CGAL skips free-form surfaces", corner + "surf 0 1 0 1 1 2 3\nf 1 2 3\n", Verdict::only_cgal_accepts},
      {"e.ply", "CGAL lets indices pass that are out of range", edited(tetrahedron_ply, "3 0 2 1", "3 0 2 9"),
       Verdict::only_cgal_accepts},
      {"f.ply", "faces before vertices", faces_first, Verdict::both_accept},
      {"g.ply", "a float is a float in text too", edited(floats, "double x", "float x"), Verdict::both_accept},
      {"h.stl", "a binary that begins with \"solid\"", binary_stl(), Verdict::both_accept},
      {"i.stl", "CGAL lets NaN pass", "x" + binary_stl(4, std::numeric_limits<float>::quiet_NaN()).substr(1),
       Verdict::only_cgal_accepts},
      {"j.stl", "CGAL knows no capitals", "SOLID\n" + facet + "ENDSOLID\n", Verdict::only_we_accept},
      {"k.off", "CGAL does not look behind the last face", tetrahedron_off + "3 0 1 2\n", Verdict::only_cgal_accepts},
      {"l.off", "normals", "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n", Verdict::both_accept}};
}

TEST(SecondOpinion, OnOddFiles) {
  for (const Odd& odd : odd_files()) {
    SCOPED_TRACE(std::string(odd.file) + ": " + odd.what);
    EXPECT_EQ(compare(odd.file, odd.bytes), odd.verdict);
  }
}

}  // namespace
}  // namespace tribunal
