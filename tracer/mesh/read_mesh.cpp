#include "tracer/mesh/read_mesh.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>

#include "exact/io/failure.h"
#include "exact/io/files.h"
#include "tracer/mesh/cgal_readers.h"
#include "tracer/mesh/scan.h"
#include "tracer/mesh/triangulate.h"

namespace tribunal {
namespace {

struct FormatRow {
  const char* extension;
  MeshFormat format;
  ScannedMesh (*scan)(const std::string& file, std::string& bytes);
};

constexpr FormatRow formats[] = {{".off", MeshFormat::off, scan_off},
                                 {".obj", MeshFormat::obj, scan_obj},
                                 {".ply", MeshFormat::ply, scan_ply},
                                 {".stl", MeshFormat::stl, scan_stl}};

const FormatRow& format_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const FormatRow& row : formats) {
    if (extension == row.extension) return row;
  }
  throw bad_input(path, 0, "unknown mesh format \"" + extension + "\", expected .off, .obj, .ply or .stl");
}

/// CGAL and the scan must have seen the same file.
void require_agreement(const std::string& path, const ScannedMesh& scanned, const PolygonSoup& soup) {
  const auto fail = [&](const std::string& what) { throw bad_input(path, 0, "was not read whole: " + what); };
  if (scanned.vertices && *scanned.vertices != soup.points.size()) {
    fail(std::to_string(soup.points.size()) + " vertices, expected " + std::to_string(*scanned.vertices));
  }
  if (scanned.degrees.size() != soup.polygons.size()) {
    fail(std::to_string(soup.polygons.size()) + " faces, expected " + std::to_string(scanned.degrees.size()));
  }
  for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
    const auto& ring = soup.polygons[f];
    if (ring.size() != scanned.degrees[f]) fail("face " + std::to_string(f) + " lost corners");
    const auto in_range = [&](std::size_t i) { return i < soup.points.size(); };
    if (!std::all_of(ring.begin(), ring.end(), in_range)) fail("face " + std::to_string(f) + " has a bad index");
  }
  if (!std::all_of(soup.points.begin(), soup.points.end(), [](const Point3& p) { return is_finite(p); })) {
    fail("a coordinate is not finite");
  }
  if (soup.points.size() > std::numeric_limits<std::uint32_t>::max())
    fail("too many vertices, expected at most 2^32 − 1");
}

}  // namespace

void require_text(const std::string& file, std::string& bytes) {
  std::size_t line = 1;
  for (char& c : bytes) {
    if (c == '\0') throw bad_input(file, line, "has a NUL byte, expected text");
    line += c == '\n';
    if (c == '\r' || c == '\t' || c == '\f' || c == '\v') c = ' ';
  }
}

Mesh read_mesh(const std::string& path) {
  const FormatRow& row = format_of(path);
  std::string bytes = read_file(path);
  if (bytes.empty()) throw bad_input(path, 0, "is empty, expected a mesh");
  const ScannedMesh scanned = row.scan(path, bytes);
  PolygonSoup soup;
  if (!read_soup(row.format, bytes, soup)) throw bad_input(path, 0, "CGAL's reader refuses it, expected a valid mesh");
  require_agreement(path, scanned, soup);
  return mesh_of(soup);
}

}  // namespace tribunal
