// Wavefront OBJ: "v x y z" and "f i j k …". Source: Wavefront's "Object Files (.obj)", appendix B1 of the Advanced
// Visualizer manual.
#include <algorithm>
#include <iterator>
#include <utility>

#include "exact/mesh/readers.h"
#include "exact/mesh/text.h"

namespace tribunal {
namespace {

/// Statements without faces: data of vertices, points and lines, groups, and how to draw. "call" and "csh" bring other
/// files in, and free-form curves and surfaces are geometry that is not read: these are refused like unknown words,
/// since a picture without them would be of something else.
constexpr std::string_view skipped[] = {"vt",  "vn",       "vp",       "p",          "l",        "o",      "g",
                                        "s",   "mg",       "usemtl",   "mtllib",     "usemap",   "maplib", "bevel",
                                        "lod", "c_interp", "d_interp", "shadow_obj", "trace_obj"};

constexpr const char* corner_form = "a corner like 7, 7/1, 7//3 or 7/1/3";

bool is_skipped(std::string_view word) {
  return std::find(std::begin(skipped), std::end(skipped), word) != std::end(skipped);
}

/// Reads an OBJ file. Its faces may name vertices that come later, so the greatest index is checked at the end.
class ObjReader {
 public:
  ObjReader(const std::string& file, std::string_view bytes) : in_(file, bytes, {'#', true}) {}

  PolygonSoup read() {
    while (in_.next_line()) read_statement();
    if (soup_.points.empty()) throw bad_input(in_.file(), 0, "has no vertices, expected \"v\" lines");
    if (soup_.size() == 0) throw bad_input(in_.file(), 0, "has no faces, expected \"f\" lines");
    if (greatest_ > vertices()) throw bad_input(in_.file(), greatest_line_, out_of_range());
    return std::move(soup_);
  }

 private:
  long long vertices() const { return static_cast<long long>(soup_.points.size()); }

  std::string out_of_range() const {
    return "vertex index " + std::to_string(greatest_) + " is out of range, expected 1 to " +
           std::to_string(vertices());
  }

  /// "fo" is how old files spell "f".
  void read_statement() {
    const std::string_view word = in_.token();
    if (word == "v") {
      read_vertex();
    } else if (word == "f" || word == "fo") {
      read_face();
    } else if (!is_skipped(word)) {
      throw in_.error("unknown statement " + in_quotes(word) + ", expected \"v\", \"f\" or one that has no geometry");
    }
  }

  /// After the coordinates a weight may follow, which is for curves, or a colour.
  void read_vertex() {
    const double x = in_.coordinate();
    const double y = in_.coordinate();
    const double z = in_.coordinate();
    for (int i = 0; i < 4 && in_.has_token(); ++i) in_.check_number(in_.token(), "a weight or a colour");
    in_.require_line_end("at most seven numbers for a vertex");
    soup_.points.emplace_back(x, y, z);
  }

  void read_face() {
    std::size_t corners = 0;
    for (; in_.has_token(); ++corners) soup_.corners.push_back(read_corner(in_.token()));
    if (corners < 3) throw in_.error("face with " + std::to_string(corners) + " corners, expected at least 3");
    soup_.end_face();
  }

  /// "7", "7/1", "7//3" or "7/1/3": the vertex, its texture coordinates and its normal.
  std::uint32_t read_corner(std::string_view token) {
    const std::size_t slash = std::min(token.find('/'), token.size());
    if (slash == 0) throw in_.error(in_quotes(token) + ", expected " + corner_form);
    check_attributes(token.substr(slash));
    return index_of(in_.to_integer(token.substr(0, slash), "a vertex index"));
  }

  void check_attributes(std::string_view rest) {
    for (int i = 0; i < 2 && !rest.empty(); ++i) {
      rest.remove_prefix(1);
      const std::size_t end = std::min(rest.find('/'), rest.size());
      if (end > 0) in_.to_integer(rest.substr(0, end), corner_form);
      rest.remove_prefix(end);
    }
    if (!rest.empty()) throw in_.error(in_quotes(rest) + ", expected " + corner_form);
  }

  /// Indices count from 1, or backwards from −1, which is the last vertex so far.
  std::uint32_t index_of(long long index) {
    if (index == 0) throw in_.error("vertex index 0, expected indices from 1, or negative ones");
    if (index < -vertices()) {
      throw in_.error("vertex index " + std::to_string(index) + " reaches back beyond the first of " +
                      std::to_string(vertices()) + " vertices");
    }
    if (index > greatest_) greatest_ = index, greatest_line_ = in_.line();
    return static_cast<std::uint32_t>(index < 0 ? vertices() + index : index - 1);
  }

  Text in_;
  PolygonSoup soup_;
  long long greatest_ = 0;
  std::size_t greatest_line_ = 0;
};

}  // namespace

PolygonSoup read_obj(const std::string& file, std::string_view bytes) {
  require_text(file, bytes);
  return ObjReader(file, bytes).read();
}

}  // namespace tribunal
