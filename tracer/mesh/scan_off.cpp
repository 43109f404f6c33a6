// OFF: magic word, counts, one vertex a line, one face a line. Source: Geomview's manual, "OFF Files".
#include <algorithm>

#include "tracer/mesh/scan.h"
#include "tracer/mesh/text_lines.h"

namespace tribunal {
namespace {

/// OFF with optional texture, colour and normal data. Four- and n-dimensional and binary files are not read.
bool is_magic(std::string_view word) {
  constexpr std::string_view known[] = {"OFF", "COFF", "NOFF", "CNOFF", "STOFF", "STCOFF", "STNOFF", "STCNOFF"};
  return std::find(std::begin(known), std::end(known), word) != std::end(known);
}

/// The announced counts; they follow the magic word on its own line or the next.
struct Counts {
  std::size_t vertices, faces;
};

std::size_t count_at(const TextLines& in, std::size_t i, const char* of, std::size_t file_size, std::size_t least) {
  const long long n = in.integer(i, "the numbers of vertices, faces and edges");
  if (n <= 0) throw in.error("announces " + std::to_string(n) + " " + of + ", expected at least 1");
  if (static_cast<unsigned long long>(n) > file_size / least) {
    throw in.error("announces " + std::to_string(n) + " " + of + ", more than the file's " + std::to_string(file_size) +
                   " bytes could hold");
  }
  return static_cast<std::size_t>(n);
}

/// A vertex takes at least 6 bytes ("0 0 0\n"), a face 8 ("3 0 0 0\n"); the last line may lack its end.
Counts read_counts(TextLines& in, std::size_t file_size) {
  in.require("\"OFF\"");
  if (!is_magic(in.token(0))) throw in.error("starts with " + quoted(in.token(0)) + ", expected \"OFF\" and text");
  if (in.token(1) == "BINARY") throw in.error("is a binary OFF file, expected the text form");
  std::size_t first = 1;
  if (in.tokens().size() == 1) {
    in.require("the numbers of vertices, faces and edges");
    first = 0;
  }
  return {count_at(in, first, "vertices", file_size + 1, 6), count_at(in, first + 1, "faces", file_size + 1, 8)};
}

std::size_t scan_face(const TextLines& in, std::size_t vertices) {
  const long long degree = in.integer(0, "the number of corners of a face");
  if (degree < 3) throw in.error("face with " + std::to_string(degree) + " corners, expected at least 3");
  if (static_cast<unsigned long long>(degree) >= in.tokens().size()) {
    throw in.error("face announces " + std::to_string(degree) + " corners, but the line has only " +
                   std::to_string(in.tokens().size() - 1));
  }
  for (std::size_t i = 1; i <= static_cast<std::size_t>(degree); ++i) {
    const long long index = in.integer(i, "a vertex index");
    if (index < 0 || static_cast<unsigned long long>(index) >= vertices) {
      throw in.error("vertex index " + std::to_string(index) + " is out of range, expected 0 to " +
                     std::to_string(vertices - 1));
    }
  }
  return static_cast<std::size_t>(degree);
}

}  // namespace

ScannedMesh scan_off(const std::string& file, std::string& bytes) {
  require_text(file, bytes);
  TextLines in(bytes, file);
  const Counts counts = read_counts(in, bytes.size());
  for (std::size_t i = 0; i < counts.vertices; ++i) {
    in.require(std::to_string(counts.vertices) + " vertices but found " + std::to_string(i));
    for (const std::size_t axis : {0u, 1u, 2u}) in.coordinate(axis);
  }
  ScannedMesh mesh{counts.vertices, {}};
  for (std::size_t i = 0; i < counts.faces; ++i) {
    in.require(std::to_string(counts.faces) + " faces but found " + std::to_string(i));
    mesh.degrees.push_back(scan_face(in, counts.vertices));
  }
  if (in.next())
    throw in.error("trailing " + quoted(in.token(0)) + " after the last face, expected the end of the file");
  return mesh;
}

}  // namespace tribunal
