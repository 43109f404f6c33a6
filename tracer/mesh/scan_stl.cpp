// STL: text ("solid … endsolid") or binary (80 bytes of header, a count, 50 bytes a triangle, little-endian).
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "tracer/mesh/scan.h"
#include "tracer/mesh/text_lines.h"

namespace tribunal {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is read by copying bytes");

constexpr std::size_t header_size = 84;
constexpr std::size_t record_size = 50;

template <class T>
T value_at(const std::string& bytes, std::size_t offset) {
  T x;
  std::memcpy(&x, bytes.data() + offset, sizeof x);
  return x;
}

bool is_binary(const std::string& bytes) {
  return bytes.size() >= header_size &&
         bytes.size() == header_size + record_size * std::size_t{value_at<std::uint32_t>(bytes, 80)};
}

ScannedMesh scan_binary(const std::string& file, std::string& bytes) {
  const std::size_t count = value_at<std::uint32_t>(bytes, 80);
  if (count == 0) throw bad_input(file, 0, "announces 0 triangles, expected at least 1");
  for (std::size_t t = 0; t < count; ++t) {
    for (std::size_t i = 3; i < 12; ++i) {  // three numbers of normal, then nine of corners
      if (std::isfinite(value_at<float>(bytes, header_size + record_size * t + 4 * i))) continue;
      throw bad_input(file, 0, "triangle " + std::to_string(t) + " has a coordinate that is not finite");
    }
  }
  bytes.replace(0, 80, 80, 'b');  // many binary files begin with "solid", by which CGAL would take them for text
  return {std::nullopt, std::vector<std::size_t>(count, 3)};
}

void expect(TextLines& in, std::string_view first, std::string_view second = {}) {
  const std::string wanted = second.empty() ? std::string(first) : std::string(first) + " " + std::string(second);
  in.require("\"" + wanted + "\"");
  const bool matches = in.token(0) == first && (second.empty() || in.token(1) == second);
  if (!matches) throw in.error(quoted(in.token(0)) + ", expected \"" + wanted + "\"");
}

void scan_facet(TextLines& in) {
  expect(in, "outer", "loop");
  for (int corner = 0; corner < 3; ++corner) {
    expect(in, "vertex");
    for (const std::size_t i : {1u, 2u, 3u}) in.coordinate(i);
  }
  expect(in, "endloop");
  expect(in, "endfacet");
}

/// One or more solids; returns the number of facets in all.
std::size_t scan_solids(TextLines& in) {
  std::size_t facets = 0;
  for (expect(in, "solid"); !in.tokens().empty(); in.next()) {
    if (in.token(0) != "solid") throw in.error("trailing " + quoted(in.token(0)) + ", expected the end of the file");
    for (in.require("\"facet\""); in.token(0) == "facet"; in.require("\"facet\" or \"endsolid\"")) {
      scan_facet(in);
      ++facets;
    }
    if (in.token(0) != "endsolid") throw in.error(quoted(in.token(0)) + ", expected \"facet\" or \"endsolid\"");
  }
  return facets;
}

}  // namespace

ScannedMesh scan_stl(const std::string& file, std::string& bytes) {
  if (is_binary(bytes)) return scan_binary(file, bytes);
  if (bytes.compare(0, 5, "solid") != 0) {
    throw bad_input(file, 0,
                    bytes.size() < header_size
                        ? "is neither text (\"solid\") nor long enough for a binary STL header"
                        : "announces " + std::to_string(value_at<std::uint32_t>(bytes, 80)) +
                              " triangles, which does not fit its size of " + std::to_string(bytes.size()) +
                              " bytes; expected 84 + 50 bytes a triangle, or text that starts with \"solid\"");
  }
  require_text(file, bytes);
  TextLines in(bytes, file, '\0');
  const std::size_t facets = scan_solids(in);
  if (facets == 0) throw bad_input(file, 0, "has no facets, expected at least 1");
  return {std::nullopt, std::vector<std::size_t>(facets, 3)};
}

}  // namespace tribunal
