// One tetrahedron as a file of each format, and what the tests of the readers share.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "exact/mesh/read_mesh.h"
#include "tests/tracer/support.h"

namespace tribunal::testing {

inline const std::string tetrahedron_off =
    "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
inline const std::string tetrahedron_obj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf -3 -2 -1\n";
inline const std::string ply_header =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n";
inline const std::string tetrahedron_ply =
    ply_header + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
inline const std::string facet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";

/// The bytes of a number in this byte order.
template <class Number>
std::string raw(Number x, bool big = false) {
  std::string bytes(reinterpret_cast<const char*>(&x), sizeof x);
  if (big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

constexpr float tetrahedron_points[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr std::uint32_t tetrahedron_faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

/// Binary STL that announces `count` triangles, with `zero` wherever a coordinate is 0.
inline std::string binary_stl(std::uint32_t count = 4, float zero = 0) {
  std::string bytes = "solid but binary" + std::string(64, ' ') + raw(count);
  for (const auto& face : tetrahedron_faces) {
    bytes += raw(0.0f) + raw(0.0f) + raw(0.0f);
    for (const std::uint32_t corner : face) {
      for (const float x : tetrahedron_points[corner]) bytes += raw(x == 0 ? zero : x);
    }
    bytes += raw(std::uint16_t{0});
  }
  return bytes;
}

inline std::string binary_ply(bool big, float zero = 0) {
  std::string bytes = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                      "_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                      "element face 4\nproperty list uchar uint vertex_indices\nend_header\n";
  for (const auto& p : tetrahedron_points) {
    for (const float x : p) bytes += raw(x == 0 ? zero : x, big);
  }
  for (const auto& f : tetrahedron_faces) {
    bytes += raw(std::uint8_t{3});
    for (const std::uint32_t i : f) bytes += raw(i, big);
  }
  return bytes;
}

/// The text with the first occurrence of `from` replaced by `to`.
inline std::string edited(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == text.npos) throw std::logic_error("no \"" + from + "\" to replace");
  return text.replace(at, from.size(), to);
}

inline std::vector<std::vector<std::uint32_t>> faces_of(const PolygonSoup& soup) {
  std::vector<std::vector<std::uint32_t>> faces;
  for (std::size_t f = 0; f < soup.size(); ++f) faces.emplace_back(soup.face(f).begin(), soup.face(f).end());
  return faces;
}

/// A file that must be refused, and how the line goes on after the file's name.
struct BadFile {
  const char* what;
  std::string bytes;
  const char* message;  ///< how it starts, e.g. ":7: face with 2 corners"
};

inline void expect_refused(const std::string& file, const std::vector<BadFile>& files) {
  for (const BadFile& bad : files) {
    SCOPED_TRACE(bad.what);
    const std::string line = refusal_of([&] { read_soup(file, bad.bytes); });
    EXPECT_TRUE(line.starts_with(file + bad.message)) << line;
  }
}

}  // namespace tribunal::testing
