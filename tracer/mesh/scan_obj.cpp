// Wavefront OBJ: `v x y z`, `f i j k …` with indices from 1, or negative ones that count back from the last vertex.
#include "tracer/mesh/scan.h"
#include "tracer/mesh/text_lines.h"

namespace tribunal {
namespace {

/// The vertex part of "7", "7/1", "7//3" or "7/1/3".
long long vertex_index(const TextLines& in, std::size_t i) {
  const std::string_view token = in.token(i);
  return parse_integer(token.substr(0, token.find('/')), in.file(), in.line(), "a vertex index");
}

/// Checks one face against the vertices so far; returns its greatest index, which may point further ahead.
/// CGAL takes index 0 for "the vertex after the last": it must never see one.
long long scan_face(const TextLines& in, long long vertices_so_far) {
  if (in.tokens().size() < 4) {
    throw in.error("face with " + std::to_string(in.tokens().size() - 1) + " corners, expected at least 3");
  }
  long long greatest = 0;
  for (std::size_t i = 1; i < in.tokens().size(); ++i) {
    const long long index = vertex_index(in, i);
    if (index == 0) throw in.error("vertex index 0, expected indices from 1, or negative ones");
    if (index < -vertices_so_far) {
      throw in.error("vertex index " + std::to_string(index) + " reaches back beyond the first of " +
                     std::to_string(vertices_so_far) + " vertices");
    }
    greatest = std::max(greatest, index);
  }
  return greatest;
}

}  // namespace

ScannedMesh scan_obj(const std::string& file, std::string& bytes) {
  require_text(file, bytes);
  TextLines in(bytes, file);
  long long vertices = 0, greatest = 0;
  std::size_t greatest_line = 0;
  ScannedMesh mesh;
  while (in.next()) {
    if (in.token(0) == "v") {
      for (const std::size_t axis : {1u, 2u, 3u}) in.coordinate(axis);
      ++vertices;
    } else if (in.token(0) == "f") {
      const long long index = scan_face(in, vertices);
      if (index > greatest) greatest = index, greatest_line = in.line();
      mesh.degrees.push_back(in.tokens().size() - 1);
    }
  }
  if (vertices == 0) throw bad_input(file, 0, "has no vertices, expected an OBJ file with \"v\" lines");
  if (mesh.degrees.empty()) throw bad_input(file, 0, "has no faces, expected an OBJ file with \"f\" lines");
  if (greatest > vertices) {
    throw bad_input(
        file, greatest_line,
        "vertex index " + std::to_string(greatest) + " is out of range, expected 1 to " + std::to_string(vertices));
  }
  mesh.vertices = static_cast<std::size_t>(vertices);
  return mesh;
}

}  // namespace tribunal
