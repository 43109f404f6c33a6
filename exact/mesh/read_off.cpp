// OFF: magic word, counts, one vertex a line, one face a line. Source: Geomview's manual, "OFF Files".
#include "exact/mesh/readers.h"
#include "exact/mesh/text.h"

namespace tribunal {
namespace {

/// The numbers on the line of a vertex: three coordinates, then what the magic word announces. Files under plain "OFF"
/// often have more than that.
struct Width {
  std::size_t least = 3;
  static constexpr std::size_t most = 3 + 3 + 4 + 2;  ///< coordinates, normal, colour with opacity, texture coordinates
};

bool take(std::string_view& word, std::string_view prefix) {
  if (!word.starts_with(prefix)) return false;
  word.remove_prefix(prefix.size());
  return true;
}

/// The magic word is [ST][C][N]OFF. Four- and n-dimensional and binary files are not read.
Width read_magic(Text& in) {
  in.require_line("\"OFF\"");
  const std::string_view magic = in.token();
  std::string_view word = magic;
  Width width;
  if (take(word, "ST")) width.least += 2;
  if (take(word, "C")) width.least += 3;
  if (take(word, "N")) width.least += 3;
  if (word != "OFF") throw in.error("starts with " + in_quotes(magic) + ", expected \"OFF\" and text");
  return width;
}

/// A count of at least 1, at most what `size` bytes can hold if each item takes `least` bytes.
std::size_t read_count(Text& in, const char* of, std::size_t size, std::size_t least) {
  const std::string_view token = in.token();
  if (token == "BINARY") throw in.error("is a binary OFF file, expected the text form");
  const long long n = in.to_integer(token, "the numbers of vertices, faces and edges");
  if (n <= 0) throw in.error("announces " + std::to_string(n) + " " + of + ", expected at least 1");
  if (static_cast<unsigned long long>(n) > size / least) {
    throw in.error("announces " + std::to_string(n) + " " + of + ", more than the file could hold in " +
                   std::to_string(size) + " bytes");
  }
  return static_cast<std::size_t>(n);
}

struct Counts {
  std::size_t vertices, faces;
};

/// The counts follow the magic word on its own line or the next. A number with its separator takes at least 2 bytes,
/// and so a face 8 ("3 0 0 0\n"); the last line may lack its end. The number of edges is often wrong or missing.
Counts read_counts(Text& in, const Width& width, std::size_t file_size) {
  if (!in.has_token()) in.require_line("the numbers of vertices, faces and edges");
  const std::size_t vertices = read_count(in, "vertices", file_size + 1, 2 * width.least);
  const std::size_t left = file_size + 1 - 2 * width.least * vertices;
  const std::size_t faces = read_count(in, "faces", left, 8);
  if (in.has_token()) in.integer("the number of edges");
  in.require_line_end("the end of the line");
  return {vertices, faces};
}

Point3 read_vertex(Text& in, const Width& width) {
  const double x = in.coordinate();
  const double y = in.coordinate();
  const double z = in.coordinate();
  std::size_t numbers = 3;
  for (; in.has_token() && numbers < Width::most; ++numbers) in.check_number(in.token(), "a number");
  if (numbers < width.least) {
    throw in.error("vertex with " + std::to_string(numbers) + " numbers, expected at least " +
                   std::to_string(width.least) + " after this magic word");
  }
  in.require_line_end("at most 12 numbers for a vertex");
  return {x, y, z};
}

void read_corner(Text& in, long long left, PolygonSoup& soup) {
  if (!in.has_token()) throw in.error("the line ends, but the face has " + std::to_string(left) + " more corners");
  const long long index = in.integer("a vertex index");
  if (index < 0 || static_cast<unsigned long long>(index) >= soup.points.size()) {
    throw in.error("vertex index " + std::to_string(index) + " is out of range, expected 0 to " +
                   std::to_string(soup.points.size() - 1));
  }
  soup.corners.push_back(static_cast<std::uint32_t>(index));
}

/// The corners, then nothing or a colour: an index into a map, or three or four numbers.
void read_face(Text& in, PolygonSoup& soup) {
  const long long degree = in.integer("the number of corners of a face");
  if (degree < 3) throw in.error("face with " + std::to_string(degree) + " corners, expected at least 3");
  for (long long left = degree; left > 0; --left) read_corner(in, left, soup);
  for (int i = 0; i < 4 && in.has_token(); ++i) in.check_number(in.token(), "a colour");
  in.require_line_end("a colour of at most four numbers");
  soup.end_face();
}

std::string missing(std::size_t announced, const char* of, std::size_t found) {
  return std::to_string(announced) + " " + of + " but found " + std::to_string(found);
}

}  // namespace

PolygonSoup read_off(const std::string& file, std::string_view bytes) {
  require_text(file, bytes);
  Text in(file, bytes);
  const Width width = read_magic(in);
  const Counts counts = read_counts(in, width, bytes.size());
  PolygonSoup soup;
  soup.points.reserve(counts.vertices);
  for (std::size_t i = 0; i < counts.vertices; ++i) {
    if (!in.next_line()) throw in.early_end(missing(counts.vertices, "vertices", i));
    soup.points.push_back(read_vertex(in, width));
  }
  soup.ends.reserve(counts.faces);
  soup.corners.reserve(3 * counts.faces);
  for (std::size_t i = 0; i < counts.faces; ++i) {
    if (!in.next_line()) throw in.early_end(missing(counts.faces, "faces", i));
    read_face(in, soup);
  }
  if (in.next_line()) in.require_line_end("the end of the file after the last face");
  return soup;
}

}  // namespace tribunal
