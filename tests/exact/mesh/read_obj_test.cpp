// OBJ: what is read, what is skipped, and what is refused where.
#include "tests/exact/mesh/mesh_files.h"

namespace tribunal {
namespace {

using namespace testing;

PolygonSoup read(const std::string& bytes) { return read_soup("m.obj", bytes); }

const std::string corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::vector<std::vector<std::uint32_t>> triangle = {{0, 1, 2}};

TEST(ReadObj, ReadsEveryFormOfACorner) {
  for (const char* face :
       {"f 1 2 3", "f 1/4 2/5 3/6", "f 1//7 2//8 3//9", "f 1/4/7 2/5/8 3/6/9", "f -3 -2 -1", "f -3/-1/-1 -2//-1 -1/1",
        "f +1 2/ 3//", "fo 1 2 3", "f 1 2 \\\n 3", "f\\\n1\\\r\n2\\\n3\\\n", "\tf\t1\t2\t3\r"}) {
    SCOPED_TRACE(face);
    const PolygonSoup soup = read(corner + face + "\n");
    EXPECT_EQ(soup.points, (std::vector<Point3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(faces_of(soup), triangle);
  }
}

TEST(ReadObj, SkipsLinesWithoutGeometry) {
  const std::string others =
      "# comment \\\nmtllib a.mtl b.mtl\no object\ng one two\ns off\ns 1\nmg 1 0.5\nusemtl red\nusemap off\n"
      "maplib a\nvt 0.5\nvt 0.5 0.5 0\nvn 0 0 1\nvn nan nan nan\nvp 0.1 0.2\np 1 2\nl 1 2\nl 1/1 2/2 \\\n 3/3\nbevel "
      "on\n"
      "c_interp on\nd_interp off\nlod 5\nshadow_obj a.obj\ntrace_obj a.obj\n#\n";
  const PolygonSoup soup = read(others + corner + others + "f 1 2 3\n" + others);
  EXPECT_EQ(soup.points.size(), 3u);
  EXPECT_EQ(faces_of(soup), triangle);
}

TEST(ReadObj, CountsBackFromTheVerticesSoFar) {
  const PolygonSoup soup = read(corner + "f -1 -2 -3\nv 5 5 5\nf -1 -2 -3 -4\n");
  EXPECT_EQ(faces_of(soup), (std::vector<std::vector<std::uint32_t>>{{2, 1, 0}, {3, 2, 1, 0}}));
}

TEST(ReadObj, LetsFacesComeFirst) { EXPECT_EQ(faces_of(read("f 1 2 3\n" + corner)), triangle); }

TEST(ReadObj, IgnoresWeightsAndColours) {
  EXPECT_EQ(read("v 1 2 3 1.0\nv 0 0 0 0.5 0.5 0.5\nv 0 1 0 1 0.5 0.5 0.5\nf 1 2 3").points[0], Point3(1, 2, 3));
}

TEST(ReadObj, RefusesWithTheLine) {
  expect_refused(
      "m.obj",
      {{"empty", "", ": is empty"},
       {"comment only", "# nothing\n", ": has no vertices"},
       {"no faces", "v 0 0 0\n", ": has no faces"},
       {"index 0", corner + "f 0 1 2\n", ":4: vertex index 0"},
       {"index beyond", corner + "f 1 2 4\nf 1 2 3\n", ":4: vertex index 4 is out of range, expected 1 to 3"},
       {"index of 64 bits", corner + "f 1 2 4294967297\n", ":4: vertex index 4294967297 is out of range"},
       {"index overflows", corner + "f 1 2 9223372036854775808\n", ":4: \"9223372036854775808\" is out of range"},
       {"greatest of several", corner + "f 1 2 5\n\nf 1 2 6\nf 1 2 4\n", ":6: vertex index 6 is out of range"},
       {"beyond the first", corner + "f -4 1 2\n", ":4: vertex index -4 reaches back beyond the first of 3"},
       {"back before any", "f -1 -2 -3\n" + corner, ":1: vertex index -1 reaches back"},
       {"least integer", corner + "f -9223372036854775808 1 2\n", ":4: vertex index -9223372036854775808 reaches"},
       {"two corners", corner + "f 1 2\n", ":4: face with 2 corners, expected at least 3, at column 5"},
       {"no corners", corner + "f\n", ":4: face with 0 corners"},
       {"word", corner + "f 1 2 x\n", ":4: \"x\", expected a vertex index, at column 7"},
       {"no vertex", corner + "f 1 2 /3\n", ":4: \"/3\", expected a corner like 7, 7/1"},
       {"bad texture", corner + "f 1 2 3/x\n", ":4: \"x\", expected a corner like 7, 7/1, 7//3 or 7/1/3"},
       {"three slashes", corner + "f 1 2 3/1/1/1\n", ":4: \"/1\", expected a corner like"},
       {"nan", "v 0 nan 0\n" + corner + "f 1 2 3\n", ":1: \"nan\" is not finite"},
       {"two coordinates", "v 0 0\n" + corner + "f 1 2 3\n", ":1: the line ends"},
       {"coordinate on a joined line", "v 0 \\\n 0 \\\n x\n", ":3: \"x\" is not a decimal number"},
       {"word after a vertex", "v 0 0 0 w\n", ":1: \"w\" is not a decimal number, expected a weight or a colour"},
       {"many after a vertex", "v 0 0 0 1 2 3 4 5\n", ":1: \"5\", expected at most seven numbers"},
       {"unknown statement", corner + "banana\nf 1 2 3\n", ":4: unknown statement \"banana\""},
       {"free-form surface", corner + "surf 0 1 0 1 1 2 3\nf 1 2 3\n", ":4: unknown statement \"surf\""},
       {"another file", corner + "call other.obj\nf 1 2 3\n", ":4: unknown statement \"call\""},
       {"capital", corner + "F 1 2 3\n", ":4: unknown statement \"F\""},
       {"nul", corner + std::string("f 1 \0 3\n", 8), ":4: has a NUL byte"}});
}

}  // namespace
}  // namespace tribunal
