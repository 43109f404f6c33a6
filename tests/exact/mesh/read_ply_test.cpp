// PLY: what is read in text and in both byte orders, and what is refused where.
#include <limits>

#include "tests/exact/mesh/mesh_files.h"

namespace tribunal {
namespace {

using namespace testing;

PolygonSoup read(const std::string& bytes) { return read_soup("m.ply", bytes); }
std::string ply(const std::string& from, const std::string& to) { return edited(tetrahedron_ply, from, to); }

const std::vector<Point3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const std::vector<std::vector<std::uint32_t>> triangle = {{0, 1, 2}};

void expect_triangle(const std::string& bytes) {
  const PolygonSoup soup = read(bytes);
  EXPECT_EQ(soup.points, corners);
  EXPECT_EQ(faces_of(soup), triangle);
}

/// Faces first, properties before, between and after those that matter, lists on vertices, scalars on faces, other
/// elements.
const std::string odd_header =
    " 1.0\ncomment made by hand\nobj_info none\nelement face 1\nproperty uchar red\n"
    "property list ushort short vertex_index\nproperty list uchar float64 texcoord\nelement strip 2\n"
    "property list int8 int16 ends\nelement vertex 3\nproperty int32 z\nproperty list uint8 int8 tags\n"
    "property double y\nproperty float32 nx\nproperty short x\nelement camera 0\nproperty uint32 id\nend_header\n";

std::string odd_binary(bool big) {
  std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian" + odd_header;
  const auto put = [&](auto x) { bytes += raw(x, big); };
  put(std::uint8_t{255}), put(std::uint16_t{3});
  for (const int i : {0, 1, 2}) put(static_cast<std::int16_t>(i));
  put(std::uint8_t{1}), put(0.5);
  put(std::int8_t{0}), put(std::int8_t{2}), put(std::int16_t{-1}), put(std::int16_t{-2});
  for (const Point3& p : corners) {
    put(static_cast<std::int32_t>(p.z)), put(std::uint8_t{1}), put(std::int8_t{-1});
    put(p.y), put(std::numeric_limits<float>::quiet_NaN()), put(static_cast<std::int16_t>(p.x));
  }
  return bytes;
}

TEST(ReadPly, ReadsAnyPropertiesInAnyOrder) {
  expect_triangle("ply\nformat ascii" + odd_header +
                  "255 3 0 1 2 1 0.5\n0\n2 -1 -2\n0 1 -1 0 nan 0\n0 1 -1 0 inf 1\n0 0 1 1e99 0\n");
  expect_triangle(odd_binary(false));
  expect_triangle(odd_binary(true));
}

TEST(ReadPly, ReadsLooseText) {
  const std::string header = edited(edited(ply_header, "vertex 4", "vertex 3"), "face 4", "face 1");
  expect_triangle(header + "0 0 0 1 0 0\n\n0 1\n0 3 0\n1 2");
  std::string crlf;
  for (const char c : header + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n") crlf += c == '\n' ? "\r\n" : std::string(1, c);
  expect_triangle(crlf);
  expect_triangle(edited(header, "ply\n", "ply\ncomment before the format\n") + "0 0 0 1 0 0 0 1 0 3 0 1 2\n");
}

TEST(ReadPly, RoundsToTheTypeOfTheProperty) {
  const std::string narrow = edited(ply("1 0 0\n0 1", "0.1 1e-46 0\n0 1"), "double x", "float x");
  EXPECT_EQ(read(narrow).points[1], Point3(0.1f, 1e-46, 0));
}

TEST(ReadPly, KeepsTheBitsOfBinaryCoordinates) {
  EXPECT_EQ(read(binary_ply(true, 0x1p-149f)).points[1], Point3(1, 0x1p-149, 0x1p-149));
  EXPECT_EQ(read(binary_ply(false, -std::numeric_limits<float>::max())).points[0].x, -0x1.fffffep127);
}

TEST(ReadPly, RefusesHeadersWithTheLine) {
  expect_refused(
      "m.ply",
      {{"empty", "", ": is empty"},
       {"magic", "plx\n", ":1: starts with \"plx\""},
       {"no format", ply("format ascii 1.0\n", ""), ":2: \"element\", expected \"format\""},
       {"format", ply("ascii", "ebcdic"), ":2: format \"ebcdic\""},
       {"cut in the header", ply_header.substr(0, 60), ":5: \"prop\", expected \"element\""},
       {"no end of the header", edited(ply_header, "end_header\n", ""), ":8: file ends early, expected \"end_header\""},
       {"keyword", ply("property double y", "banana"), ":5: \"banana\", expected \"element\""},
       {"property of nothing", "ply\nformat ascii 1.0\nproperty int x\n", ":3: \"property\", expected"},
       {"negative", ply("vertex 4", "vertex -4"), ":3: announces -4 items"},
       {"no count", ply("vertex 4", "vertex"), ":3: the line ends, expected the number of items"},
       {"no vertices", ply("vertex 4", "vertex 0"), ":3: announces 0 items, expected at least 1 vertex"},
       {"no faces", ply("face 4", "face 0"), ":7: announces 0 items, expected at least 1 face"},
       {"vertex bomb", ply("vertex 4", "vertex 1000000000000"),
        ":3: announces 1000000000000 items, more than the file"},
       {"face bomb", ply("face 4", "face 9223372036854775807"), ":7: announces 9223372036854775807 items, more than"},
       {"bomb of another", ply("element face", "element a 4000000\nproperty list int int b\nelement face"),
        ":7: announces 4000000 items, more than"},
       {"binary bomb", edited(binary_ply(true), "vertex 4", "vertex 9"), ":3: announces 9 items, more than the file"},
       {"too many together", edited(binary_ply(true), "face 4", "face 53"),
        ":7: announces 53 items, more than the file"},
       {"no x", ply("double x", "double w"), ":3: element \"vertex\", expected one property x"},
       {"two x", ply("double y", "double x"), ":3: element \"vertex\", expected one property x"},
       {"list of x", ply("double x", "list int int x"), ":3: element \"vertex\", expected one property x"},
       {"no corners", ply("vertex_indices", "corners"), ":7: element \"face\", expected one property \"vertex_ind"},
       {"corner alone", ply("list uchar int", "int"), ":7: element \"face\", expected one property \"vertex_ind"},
       {"fractional corners", ply("uchar int", "uchar float"), ":7: element \"face\", expected one property"},
       {"fractional length", ply("uchar int", "float int"), ":8: \"float\", expected an integer type"},
       {"unknown type", ply("double x", "quad x"), ":4: \"quad\", expected a type of PLY"},
       {"no name", ply("double x", "double"), ":4: the line ends, expected a name"},
       {"two names", ply("double x", "double x y"), ":4: \"y\", expected the end of the line"},
       {"no properties", ply("element face", "element a 4\nelement face"), ":7: element \"a\" has no properties"},
       {"two elements", ply("element face", "element vertex 1\nproperty int x\nelement face"), ":11: expected exactly"},
       {"no face", ply("element face", "element fence"), ":9: expected exactly one element \"face\""}});
}

TEST(ReadPly, RefusesTextWithTheLine) {
  expect_refused("m.ply",
                 {{"more", ply("face 4", "face 5"), ":17: file ends early, expected another number"},
                  {"less", ply("face 4", "face 3"), ":17: \"3\", expected the end of the file"},
                  {"rest of a line", tetrahedron_ply + "\n7", ":19: \"7\", expected the end of the file"},
                  {"index", ply("3 0 2 1", "3 0 2 4"), ":14: vertex index 4 is out of range, expected 0 to 3"},
                  {"negative index", ply("3 0 2 1", "3 0 -2 1"), ":14: vertex index -2 is out of range"},
                  {"fraction", ply("3 0 2 1", "3 0 2.5 1"), ":14: \"2.5\", expected an integer"},
                  {"beyond its type", ply("3 0 2 1", "3 0 2147483648 1"), ":14: \"2147483648\" is out of range"},
                  {"long list", ply("3 0 2 1", "200 0 2 1"), ":14: list of 200 entries, more than the file"},
                  {"negative list", edited(ply("3 0 2 1", "-3 0 2 1"), "uchar", "char"), ":14: list of -3"},
                  {"two corners", ply("3 0 2 1", "2 0 2"), ":14: face with 2 corners"},
                  {"nan", ply("1 0 0", "1 nan 0"), ":11: \"nan\" is not finite"},
                  {"huge", edited(ply("1 0 0", "1e39 0 0"), "double x", "float x"), ":11: \"1e39\" is out of"},
                  {"word", ply("1 0 0", "1 x 0"), ":11: \"x\" is not a decimal number"},
                  {"nul", ply("1 0 0", std::string("1 \0 0", 5)), ":11: has a NUL byte"}});
}

TEST(ReadPly, RefusesBinariesWithTheByte) {
  const std::string whole = binary_ply(false);
  const std::size_t data = whole.find("end_header\n") + 11, first_face = data + 48;
  const auto refused = [&](const std::string& bytes, std::size_t byte, const std::string& what) {
    const std::string line = refusal_of([&] { read(bytes); });
    EXPECT_TRUE(line.starts_with("m.ply: byte " + std::to_string(byte) + ": " + what)) << line;
  };
  const auto patched = [&](std::size_t byte, const std::string& with) {
    return std::string(whole).replace(byte, with.size(), with);
  };
  refused(binary_ply(false, std::numeric_limits<float>::quiet_NaN()), data, "a coordinate is not finite");
  refused(binary_ply(true, std::numeric_limits<float>::infinity()), data - 3, "a coordinate is not finite");
  refused(whole + "x", whole.size(), "trailing data");
  refused(patched(first_face + 1, raw(4u)), first_face + 1, "vertex index 4 is out of range, expected 0 to 3");
  refused(patched(first_face, "\2"), first_face, "face with 2 corners");
  refused(patched(first_face, "\xff"), first_face, "list of 255 entries, more than the file could hold");
  refused(patched(whole.size() - 13, "\4"), whole.size() - 13, "list of 4 entries, more than the file could hold");
  const std::string fewer = edited(whole, "face 4", "face 3");
  refused(fewer, whole.size() - 13, "trailing data");
  refused(fewer.substr(0, whole.size() - 14), whole.size() - 26, "list of 3 entries, more than the file could hold");
}

}  // namespace
}  // namespace tribunal
