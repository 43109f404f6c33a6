// Small files of every format, damaged at random: a reader accepts a mesh that is whole, or refuses in one line, and
// never takes memory beyond a multiple of the file's size.
#include <algorithm>
#include <iterator>
#include <map>

#include "exact/mesh/triangulate.h"
#include "tests/exact/mesh/allocations.h"
#include "tests/exact/mesh/mesh_files.h"

namespace tribunal {
namespace {

using namespace testing;

struct Seed {
  const char* file;
  std::string bytes;
};

std::vector<Seed> seeds() {
  const std::string coloured =
      "COFF # c\n4 2 5\n0 0 0 1 0 0 1\n1 0 0 1 0 0\n1 1 0 1 0 0 1\n0 1e-9 .5 0 0 0\n"
      "4 0 1 2 3 255 0 0\n3 0 1 3 7\n";
  const std::string forms =
      "# o\nmtllib a\nv 0 0 0 1\nv 1 0 0\nvt 0 0\nvn 0 0 1\nv 0 1.5e0 0\nl 1 2\ng a\n"
      "f 1/1/1 2//1 3/1\nf -1 -2 \\\n -3\nv 1 1 1\nf 1 2 3 4\n";
  const std::string lists =
      "ply\nformat ascii 1.0\ncomment c\nelement vertex 3\nproperty float x\nproperty list uchar int a\n"
      "property short y\nproperty double z\nelement face 1\nproperty uchar red\n"
      "property list int ushort vertex_indices\nend_header\n0 2 7 8 0 0\n1 0 1 0\n0 1 9 2 .5\n9 3 0 1 2\n";
  return {{"a.off", tetrahedron_off},
          {"b.off", coloured},
          {"a.obj", tetrahedron_obj},
          {"b.obj", forms},
          {"a.ply", tetrahedron_ply},
          {"b.ply", lists},
          {"little.ply", binary_ply(false)},
          {"big.ply", binary_ply(true)},
          {"a.stl", "solid s\n" + facet + "endsolid s\n"},
          {"binary.stl", binary_stl()}};
}

/// What formats are made of, and what breaks parsers.
constexpr std::string_view words[] = {"0",
                                      "-1",
                                      "3",
                                      "255",
                                      "4294967296",
                                      "9223372036854775807",
                                      "1e308",
                                      "1e-400",
                                      "nan",
                                      "inf",
                                      "0x1",
                                      "1e999999999999999999999",
                                      "\n",
                                      " ",
                                      "\\\n",
                                      "#",
                                      "/",
                                      "-",
                                      "property list uchar int q\n",
                                      "element x 1000000000000\n",
                                      "element vertex ",
                                      "facet ",
                                      "solid",
                                      "endsolid ",
                                      "f ",
                                      "v ",
                                      "\xff\xff\xff\xff",
                                      "\x7f\x80\0\0",
                                      "OFF",
                                      "end_header\n"};

std::string_view drawn_word(Random& random) { return words[random.below(std::size(words))]; }

/// Damages a file in one way: a byte replaced, a bit flipped, a part removed or repeated, a word inserted or written
/// over, or the end cut off.
void damage(std::string& bytes, Random& random) {
  const std::size_t kind = random.below(7);
  const std::size_t at = random.below(bytes.size() + 1);
  const std::size_t length = random.below(1 + random.below(24));
  if (kind == 0 && at < bytes.size()) bytes[at] = static_cast<char>(random.below(256));
  if (kind == 1 && at < bytes.size()) bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.below(8)));
  if (kind == 2) bytes.erase(at, length);
  if (kind == 3) bytes.insert(at, std::string(bytes, at, length));
  if (kind == 4) bytes.insert(at, drawn_word(random));
  if (kind == 5) bytes.replace(at, length, drawn_word(random));
  if (kind == 6) bytes.resize(at);
}

std::string damaged(std::string bytes, Random& random) {
  const std::size_t times = 1 + random.below(4);
  for (std::size_t i = 0; i < times; ++i) damage(bytes, random);
  return bytes;
}

void expect_whole(const PolygonSoup& soup) {
  ASSERT_GT(soup.size(), 0u);
  ASSERT_TRUE(std::all_of(soup.points.begin(), soup.points.end(), [](const Point3& p) { return is_finite(p); }));
  const auto known = [&](std::uint32_t i) { return i < soup.points.size(); };
  ASSERT_TRUE(std::all_of(soup.corners.begin(), soup.corners.end(), known));
  ASSERT_EQ(soup.ends.back(), soup.corners.size());
  for (std::size_t f = 0; f < soup.size(); ++f) ASSERT_GE(soup.face(f).size(), 3u);
}

/// Expects a message of one line that starts with the file's name.
void expect_refusal(const Failure& failure, const std::string& file) {
  const std::string line = failure.what();
  ASSERT_EQ(failure.exit(), Exit::bad_input) << line;
  ASSERT_TRUE(line.starts_with(file + ":")) << line;
  ASSERT_EQ(line.find('\n'), line.npos) << line;
  ASSERT_LT(line.size(), 300u) << line;
}

/// The bytes that a reader may hold for a file of this size. A vertex of 6 bytes in the file takes 24 in memory, a
/// face of 8 takes 16, a corner of 2 takes 4; growing arrays double that and hold the old and the new array at once;
/// messages add to it.
std::size_t memory_bound(std::size_t file_size) { return 16 * file_size + 4096; }

/// Whether the reader accepts the file. The bytes are copied to a block of exactly their size, so that the sanitizer
/// sees any access beyond them.
bool reads(const std::string& file, const std::string& text) {
  const std::vector<char> block(text.begin(), text.end());
  const std::string_view bytes(block.data(), block.size());
  const AllocationPeak peak;
  bool accepted = true;
  try {
    PolygonSoup soup = read_soup(file, bytes);
    EXPECT_LE(peak.bytes(), memory_bound(bytes.size())) << text;
    expect_whole(soup);
    mesh_of(std::move(soup));
  } catch (const Failure& failure) {
    expect_refusal(failure, file);
    EXPECT_LE(peak.bytes(), memory_bound(bytes.size())) << text;
    accepted = false;
  }
  return accepted;
}

TEST(MeshFuzz, DamagedFilesAreReadWholeOrRefused) {
  const int count = std::getenv("TRIBUNAL_LONG") ? 1000000 : 20000;
  for (const Seed& seed : seeds()) {
    SCOPED_TRACE(seed.file);
    ASSERT_TRUE(reads(seed.file, seed.bytes));
    Random random(13);
    int accepted = 0;
    for (int i = 0; i < count && !HasFatalFailure(); ++i) accepted += reads(seed.file, damaged(seed.bytes, random));
    EXPECT_GT(accepted, count / 1000) << "damage is never harmless: the reader is hardly entered";
    EXPECT_LT(accepted, count / 2) << "damage is mostly harmless";
  }
}

TEST(MeshFuzz, AnyFormatUnderAnyName) {
  for (const Seed& seed : seeds()) {
    for (const char* file : {"x.off", "x.obj", "x.ply", "x.stl"}) {
      const bool own = std::string_view(seed.file).ends_with(std::string_view(file).substr(1));
      EXPECT_EQ(reads(file, seed.bytes), own) << seed.file << " as " << file;
    }
  }
}

/// Large files that announce more than they hold, or as much as they can.
TEST(MeshFuzz, LargeFilesTakeAMultipleOfTheirSize) {
  const auto repeated = [](const std::string& line, int n) {
    std::string text;
    for (int i = 0; i < n; ++i) text += line;
    return text;
  };
  const std::string ply_counts =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 20000\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n";
  const std::string solid = "solid\n" + repeated(facet, 5000) + "endsolid\n";
  EXPECT_TRUE(reads("a.off", "OFF\n20000 20000\n" + repeated("0 0 0\n", 20000) + repeated("3 0 1 2\n", 20000)));
  EXPECT_TRUE(reads("a.obj", repeated("v 0 0 0\n", 20000) + repeated("f 1 1 1\n", 20000)));
  EXPECT_TRUE(reads("b.obj", "v 0 0 0\nf" + repeated(" 1", 100000)));
  EXPECT_TRUE(reads("a.ply", ply_counts + repeated("3 0 1 2\n", 20000)));
  EXPECT_TRUE(reads("a.stl", solid));
  EXPECT_FALSE(reads("a.off", "OFF\n1000000000000 1\n" + repeated("0 0 0\n", 1000)));
  EXPECT_FALSE(reads("c.obj", "v 0 0 0\nf" + repeated(" 2", 100000)));
  EXPECT_FALSE(reads("b.off", repeated("x", 1 << 20)));
  EXPECT_FALSE(reads("b.obj", repeated("v 1\\\n", 10000)));
}

}  // namespace
}  // namespace tribunal
