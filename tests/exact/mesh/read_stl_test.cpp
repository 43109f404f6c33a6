// STL: what is read, how text and binary are told apart, and what is refused where.
#include <limits>

#include "tests/exact/mesh/mesh_files.h"

namespace tribunal {
namespace {

using namespace testing;

PolygonSoup read(const std::string& bytes) { return read_soup("m.stl", bytes); }

const std::string solid = "solid s\n" + facet + "endsolid s\n";
const std::string stl_facet_upper =
    "FACET NORMAL 0 0 1\nOUTER LOOP\nVERTEX 0 0 0\nVERTEX 1 0 0\nVERTEX 0 1 0\nENDLOOP\nENDFACET\n";
const std::vector<Point3> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const std::vector<std::vector<std::uint32_t>> triangle = {{0, 1, 2}};

TEST(ReadStl, ReadsText) {
  for (const std::string& bytes :
       {solid, std::string("solid\n") + facet + "endsolid",
        std::string("\n  solid facet of a name\n") + facet + "endsolid\n",
        "SOLID S\n" + stl_facet_upper + "ENDSOLID S\n", "solid # no comment\n" + facet + "endsolid # none\n",
        edited(solid, "normal 0 0 1", "normal nan -nan(ind) 0"), edited(solid, "0 0 0\n", "0.0 +0 0e9\r\n")}) {
    SCOPED_TRACE(bytes);
    const PolygonSoup soup = read(bytes);
    EXPECT_EQ(soup.points, corners);
    EXPECT_EQ(faces_of(soup), triangle);
  }
}

TEST(ReadStl, ReadsSeveralSolids) {
  const PolygonSoup soup = read(solid + "\n" + solid + "solid empty\nendsolid\n");
  EXPECT_EQ(soup.points.size(), 3u) << "corners at the same place are one vertex";
  EXPECT_EQ(faces_of(soup), (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {0, 1, 2}}));
}

TEST(ReadStl, MergesZerosOfBothSigns) {
  const PolygonSoup soup = read(edited(solid, "vertex 1 0 0", "vertex -0 0 -0"));
  EXPECT_EQ(faces_of(soup), (std::vector<std::vector<std::uint32_t>>{{0, 0, 1}}));
  EXPECT_EQ(soup.points.size(), 2u);
}

TEST(ReadStl, ReadsBinary) {
  const PolygonSoup soup = read(binary_stl());
  EXPECT_EQ(soup.points, (std::vector<Point3>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}));
  EXPECT_EQ(faces_of(soup), (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {2, 1, 3}}));
  EXPECT_EQ(read(binary_stl(4, 0x1p-149f)).points[0].x, 0x1p-149);
}

/// A file is binary by its size, whatever its header holds: the words of a text STL, or text to its last byte.
TEST(ReadStl, TakesTheSizeForTheSignOfABinary) {
  for (std::string header : {"solid", "solid s\nfacet normal 0 0 1\n", "endsolid", "", "SOLID"}) {
    header.resize(80, header.size() % 2 ? ' ' : '\0');
    EXPECT_EQ(read(header + binary_stl().substr(80)).size(), 4u) << header;
  }
}

TEST(ReadStl, RefusesBinariesWithTheByte) {
  const std::string whole = binary_stl();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  expect_refused("m.stl",
                 {{"nan", binary_stl(4, nan), ": byte 96: a coordinate is not finite"},
                  {"nan in the last corner", std::string(whole).replace(278, 4, raw(nan)),
                   ": byte 278: a coordinate is not finite"},
                  {"no triangles", binary_stl(0).substr(0, 84), ": byte 80: announces 0 triangles"},
                  {"count", binary_stl(4000000000u), ": byte 80: announces 4000000000 triangles, which does not fit"},
                  {"count too small", binary_stl(3), ": byte 80: announces 3 triangles, which does not fit"},
                  {"cut", whole.substr(0, 283), ": byte 80: announces 4 triangles, which does not fit"},
                  {"tail", whole + "x", ": byte 80: announces 4 triangles, which does not fit"},
                  {"cut in the count", "x" + whole.substr(1, 81), ": is neither text"}});
}

TEST(ReadStl, RefusesTextWithTheLine) {
  expect_refused(
      "m.stl",
      {{"empty", "", ": is empty"},
       {"magic", "hello", ": is neither text"},
       {"solids", "solids\n", ":1: \"solids\", expected \"solid\""},
       {"no facets", "solid s\nendsolid s\n", ": has no facets"},
       {"no end", "solid s\n" + facet, ":8: file ends early, expected \"facet\" or \"endsolid\""},
       {"cut in a facet", "solid s\n" + facet.substr(0, 60), ":6: \"vert\", expected \"vertex\""},
       {"no normal", edited(solid, "facet normal", "facet"), ":2: \"0\", expected \"normal\""},
       {"no loop", edited(solid, "outer loop", "outer"), ":3: \"\", expected \"loop\""},
       {"after the loop", edited(solid, "outer loop", "outer loop vertex"), ":3: \"vertex\", expected the end"},
       {"tail", solid + "garbage\n", ":10: \"garbage\", expected \"solid\""},
       {"nested", edited(solid, "facet", "solid"), ":2: \"solid\", expected \"facet\" or \"endsolid\""},
       {"nan", edited(solid, "1 0 0", "1 nan 0"), ":5: \"nan\" is not finite"},
       {"huge", edited(solid, "1 0 0", "1 1e999 0"), ":5: \"1e999\" is out of range"},
       {"two coordinates", edited(solid, "1 0 0", "1 0"), ":5: the line ends"},
       {"four coordinates", edited(solid, "1 0 0", "1 0 0 0"), ":5: \"0\", expected three coordinates, at column 14"},
       {"four corners", edited(solid, "endloop", "vertex 0 0 1\nendloop"), ":7: \"vertex\", expected \"endloop\""},
       {"two corners", edited(solid, "vertex 0 1 0\n", ""), ":6: \"endloop\", expected \"vertex\""},
       {"nul", edited(solid + std::string(99, ' '), "endloop", std::string("endloop\0", 8)), ":7: has a NUL byte"}});
}

}  // namespace
}  // namespace tribunal
