// OFF: what is read, and what is refused where.
#include "tests/exact/mesh/mesh_files.h"

namespace tribunal {
namespace {

using namespace testing;

PolygonSoup read(const std::string& bytes) { return read_soup("m.off", bytes); }
std::string off(const std::string& from, const std::string& to) { return edited(tetrahedron_off, from, to); }

const std::vector<std::vector<std::uint32_t>> triangle = {{0, 1, 2}};

/// All these files describe the same triangle.
TEST(ReadOff, ReadsEveryDialect) {
  for (const char* bytes :
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2",
        "# made by hand\n\nOFF # magic\n# counts\n3 1 # no edges\n0 0 0 # origin\n1 0 0\n\n0 1 0\n3 0 1 2\n# end\n",
        "OFF\r\n3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2\r\n",
        "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0.5 0.5 0.5\n0 1 0 1 1 1 1\n3 0 1 2 255 0 0 1\n",
        "NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 nan 0 1\n3 0 1 2\n",
        "CNOFF\n3 1 0\n0 0 0 0 0 1 1 1 1\n1 0 0 0 0 1 1 1 1 1\n0 1 0 0 0 1 1 1 1\n3 0 1 2 7\n",
        "STOFF\n3 1 0\n0 0 0 0 1\n1 0 0 1 1\n0 1 0 1 0\n3 0 1 2 0.1 0.2 0.3\n",
        "STCNOFF\n3 1 0\n0 0 0 0 0 1 1 1 1 1 0 1\n1 0 0 0 0 1 1 1 1 1 0 1\n0 1 0 0 0 1 1 1 1 1 0 1\n3 0 1 2\n",
        "OFF\n3 1 0\n0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n3 0 1 2\n"}) {
    SCOPED_TRACE(bytes);
    const PolygonSoup soup = read(bytes);
    EXPECT_EQ(soup.points, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(faces_of(soup), triangle);
  }
}

TEST(ReadOff, ReadsFacesOfAnyDegree) {
  const PolygonSoup soup = read("OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 2 0\n3 0 1 2\n5 0 1 2 3 4\n4 0 0 0 0\n");
  EXPECT_EQ(faces_of(soup), (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {0, 1, 2, 3, 4}, {0, 0, 0, 0}}));
}

TEST(ReadOff, RefusesWithTheLine) {
  expect_refused(
      "m.off",
      {{"empty", "", ": is empty"},
       {"blank", "\n\n", ":2: file ends early, expected \"OFF\""},
       {"magic", "PLY\n1 1 0\n", ":1: starts with \"PLY\""},
       {"four dimensions", "4OFF\n1 1 0\n", ":1: starts with \"4OFF\""},
       {"order of prefixes", "NCOFF\n1 1 0\n", ":1: starts with \"NCOFF\""},
       {"binary", "OFF BINARY\n", ":1: is a binary OFF file"},
       {"binary on the next line", "OFF\nBINARY\n", ":2: is a binary OFF file"},
       {"no counts", "OFF\n", ":1: file ends early, expected the numbers"},
       {"one count", off("4 4 0", "4"), ":2: the line ends, expected the numbers"},
       {"count not a number", off("4 4 0", "4 x"), ":2: \"x\", expected the numbers"},
       {"edges not a number", off("4 4 0", "4 4 x"), ":2: \"x\", expected the number of edges"},
       {"four counts", off("4 4 0", "4 4 0 0"), ":2: \"0\", expected the end of the line, at column 7"},
       {"negative", off("4 4 0", "-4 4 0"), ":2: announces -4 vertices, expected at least 1, at column 1"},
       {"no faces", off("4 4 0", "4 0 0"), ":2: announces 0 faces"},
       {"vertex bomb", off("4 4 0", "1000000000000 4 0"), ":2: announces 1000000000000 vertices, more than the file"},
       {"face bomb", off("4 4 0", "4 1000000000000 0"), ":2: announces 1000000000000 faces, more than the file"},
       {"overflow", off("4 4 0", "99999999999999999999 4 0"), ":2: \"99999999999999999999\" is out of range"},
       {"too many together", "OFF\n4 4 0\n0 0 0\n0 0 0\n0 0 0\n0 0 0\n3 0 0 0\n3 0 0 0",
        ":2: announces 4 faces, more than"},
       {"degree bomb", off("3 0 2 1", "2000000000 0 2 1"), ":7: the line ends, but the face has 1999999997 more"},
       {"degree overflow", off("3 0 2 1", "9223372036854775807 0"), ":7: the line ends, but the face has"},
       {"two corners", off("3 0 2 1", "2 0 2"), ":7: face with 2 corners"},
       {"no corners", off("3 0 2 1", "0"), ":7: face with 0 corners"},
       {"index", off("3 0 2 1", "3 0 2 4"), ":7: vertex index 4 is out of range, expected 0 to 3, at column 7"},
       {"negative index", off("3 0 2 1", "3 0 -2 1"), ":7: vertex index -2 is out of range"},
       {"index of 64 bits", off("3 0 2 1", "3 0 4294967296 1"), ":7: vertex index 4294967296 is out of range"},
       {"fraction", off("3 0 2 1", "3 0 2.5 1"), ":7: \"2.5\", expected a vertex index"},
       {"colour", off("3 0 2 1", "3 0 2 1 red"), ":7: \"red\" is not a decimal number, expected a colour, at column 9"},
       {"long colour", off("3 0 2 1", "3 0 2 1 1 2 3 4 5"), ":7: \"5\", expected a colour of at most four numbers"},
       {"nan", off("0 1 0", "0 nan 0"), ":5: \"nan\" is not finite"},
       {"inf", off("0 1 0", "inf 1 0"), ":5: \"inf\" is not finite"},
       {"huge", off("0 1 0", "0 1e999 0"), ":5: \"1e999\" is out of range"},
       {"hex", off("0 1 0", "0 0x1p0 0"), ":5: \"0x1p0\" is not a decimal number"},
       {"two coordinates", off("0 1 0", "0 1"), ":5: the line ends, expected a finite decimal coordinate"},
       {"word after a vertex", off("0 1 0", "0 1 0 banana"), ":5: \"banana\""},
       {"many after a vertex", off("0 1 0", "0 1 0 1 2 3 4 5 6 7 8 9 10"), ":5: \"10\", expected at most 12 numbers"},
       {"no normals", edited("N" + tetrahedron_off + std::string(99, '\n'), "0 1 0", "0 1 0"),
        ":3: vertex with 3 numbers, expected at least 6"},
       {"two vertices a line", off("0 0 0\n1", "0 0 0 1"), ":9: file ends early, expected 4 faces but found 3"},
       {"cut in the vertices", "OFF\n9 1 0\n0 0 0." + std::string(60, '0'),
        ":3: file ends early, expected 9 vertices but found 1"},
       {"cut in the faces", tetrahedron_off.substr(0, 58), ":9: file ends early, expected 4 faces but found 3"},
       {"trailing", tetrahedron_off + "3 0 1 2\n", ":11: \"3\", expected the end of the file"},
       {"nul", off("0 1 0", std::string("0 \0 0", 5)), ":5: has a NUL byte"}});
}

}  // namespace
}  // namespace tribunal
