// STL: text ("solid … endsolid") or binary (80 bytes of header, a count, 50 bytes a triangle, little-endian). Source:
// 3D Systems, "StereoLithography Interface Specification", 1989. Corners at the same place are one vertex.
#include <algorithm>
#include <cctype>
#include <utility>

#include "exact/mesh/bytes.h"
#include "exact/mesh/merged_points.h"
#include "exact/mesh/readers.h"
#include "exact/mesh/text.h"

namespace tribunal {
namespace {

constexpr std::size_t count_at = 80, header_size = 84, record_size = 50;

std::size_t announced(const std::string& file, std::string_view bytes) {
  return Bytes(file, bytes, count_at, std::endian::little).next<std::uint32_t>();
}

/// Many binary files begin with "solid", so their size decides. No text has the size of a binary file: as its bytes are
/// at least 9 (a tab), a text of more than 84 bytes would announce 151,587,081 triangles or more, which take
/// 7.5 GB, and no file is larger than 2^32 bytes.
bool has_binary_size(const std::string& file, std::string_view bytes) {
  return bytes.size() >= header_size && bytes.size() == header_size + record_size * announced(file, bytes);
}

bool same_word(std::string_view token, std::string_view word) {
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  return std::equal(token.begin(), token.end(), word.begin(), word.end(), same);
}

/// A binary file that was cut may begin with "solid" too, but has a NUL byte in the header or in the count after it.
bool looks_like_text(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  return same_word(bytes.substr(first, 5), "solid") && bytes.substr(0, header_size).find('\0') == bytes.npos;
}

Point3 read_corner(Bytes& in) {
  const float x = in.coordinate<float>();
  const float y = in.coordinate<float>();
  const float z = in.coordinate<float>();
  return {x, y, z};
}

/// Each triangle is a normal, which is not looked at, three corners and two bytes of attributes.
PolygonSoup read_binary(const std::string& file, std::string_view bytes) {
  Bytes in(file, bytes, count_at, std::endian::little);
  const std::size_t count = in.next<std::uint32_t>();
  if (count == 0) throw in.error("announces 0 triangles, expected at least 1");
  PolygonSoup soup;
  soup.corners.reserve(3 * count);
  soup.ends.reserve(count);
  MergedPoints merged(soup.points);
  for (std::size_t t = 0; t < count; ++t) {
    in.skip(3 * sizeof(float));
    for (int corner = 0; corner < 3; ++corner) soup.corners.push_back(merged.index_of(read_corner(in)));
    in.skip(sizeof(std::uint16_t));
    soup.end_face();
  }
  return soup;
}

Failure neither(const std::string& file, std::string_view bytes) {
  if (bytes.size() < header_size) {
    return bad_input(file, 0, "is neither text (\"solid\") nor long enough for the header of a binary STL file");
  }
  return bad_input(file, 0,
                   "byte 80: announces " + std::to_string(announced(file, bytes)) +
                       " triangles, which does not fit the file's size of " + std::to_string(bytes.size()) +
                       " bytes; expected 84 + 50 bytes a triangle, or text that starts with \"solid\"");
}

/// Reads the text form. Words may be in capitals; the names of solids and the normals are not looked at.
class StlText {
 public:
  StlText(const std::string& file, std::string_view bytes) : in_(file, bytes, {'\0'}), merged_(soup_.points) {}

  PolygonSoup read() {
    while (in_.next_line()) read_solid();
    if (soup_.size() == 0) throw bad_input(in_.file(), 0, "has no facets, expected at least 1");
    return std::move(soup_);
  }

 private:
  void read_solid() {
    expect("solid");
    for (in_.require_line("\"facet\""); !at("endsolid"); in_.require_line("\"facet\" or \"endsolid\"")) read_facet();
  }

  void read_facet() {
    if (!same_word(word_, "facet")) throw in_.error(in_quotes(word_) + ", expected \"facet\" or \"endsolid\"");
    expect("normal");
    expect_line("outer");
    expect("loop");
    in_.require_line_end("the end of the line");
    for (int corner = 0; corner < 3; ++corner) read_corner();
    expect_line("endloop");
    in_.require_line_end("the end of the line");
    expect_line("endfacet");
    in_.require_line_end("the end of the line");
    soup_.end_face();
  }

  void read_corner() {
    expect_line("vertex");
    const double x = in_.coordinate();
    const double y = in_.coordinate();
    const double z = in_.coordinate();
    in_.require_line_end("three coordinates");
    soup_.corners.push_back(merged_.index_of({x, y, z}));
  }

  bool at(std::string_view word) {
    word_ = in_.token();
    return same_word(word_, word);
  }

  void expect(std::string_view word) {
    if (!at(word)) throw in_.error(in_quotes(word_) + ", expected \"" + std::string(word) + "\"");
  }

  void expect_line(const char* word) {
    in_.require_line(word);
    expect(word);
  }

  Text in_;
  std::string_view word_;  ///< the token that was read last
  PolygonSoup soup_;
  MergedPoints merged_;
};

}  // namespace

PolygonSoup read_stl(const std::string& file, std::string_view bytes) {
  if (has_binary_size(file, bytes)) return read_binary(file, bytes);
  if (!looks_like_text(bytes)) throw neither(file, bytes);
  require_text(file, bytes);
  return StlText(file, bytes).read();
}

}  // namespace tribunal
