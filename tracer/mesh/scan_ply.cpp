// PLY: a text header of elements and their properties, then the data in text or in binary of either byte order.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "tracer/mesh/scan.h"
#include "tracer/mesh/text_lines.h"

namespace tribunal {
namespace {

/// A scalar type of PLY; `bytes` = 0 if unknown.
struct Type {
  std::size_t bytes = 0;
  bool is_signed = false, floating = false;
};

Type type_named(std::string_view name) {
  if (name == "char" || name == "int8") return {1, true};
  if (name == "uchar" || name == "uint8") return {1};
  if (name == "short" || name == "int16") return {2, true};
  if (name == "ushort" || name == "uint16") return {2};
  if (name == "int" || name == "int32") return {4, true};
  if (name == "uint" || name == "uint32") return {4};
  if (name == "float" || name == "float32") return {4, true, true};
  if (name == "double" || name == "float64") return {8, true, true};
  return {};
}

struct Property {
  std::string name;
  Type type;
  Type count;  ///< of a list; bytes = 0 for a scalar
};

struct Element {
  std::string name;
  std::size_t items;
  std::vector<Property> properties;
};

enum class Coding { text, little, big };

struct Header {
  Coding coding = Coding::text;
  std::vector<Element> elements;
  std::size_t size = 0;   ///< bytes up to the data
  std::size_t lines = 0;  ///< lines up to the data
};

bool is_vertex(const Element& e) { return e.name == "vertex" || e.name == "vertices"; }
bool is_face(const Element& e) { return e.name == "face" || e.name == "faces"; }
bool is_corners(const Property& p) { return p.name == "vertex_indices" || p.name == "vertex_index"; }
bool is_coordinate(const Property& p) { return p.name == "x" || p.name == "y" || p.name == "z"; }

Coding coding_named(const TextLines& in) {
  if (in.token(1) == "ascii") return Coding::text;
  if (in.token(1) == "binary_little_endian") return Coding::little;
  if (in.token(1) == "binary_big_endian") return Coding::big;
  throw in.error("format " + quoted(in.token(1)) + ", expected ascii, binary_little_endian or binary_big_endian");
}

Type require_type(const TextLines& in, std::size_t i, bool integer) {
  const Type type = type_named(in.token(i));
  if (type.bytes > 0 && !(integer && type.floating)) return type;
  throw in.error(quoted(in.token(i)) + ", expected " + (integer ? "an integer type" : "a type") + " of PLY");
}

Property parse_property(const TextLines& in) {
  if (in.token(1) != "list") return {std::string(in.token(2)), require_type(in, 1, false), {}};
  return {std::string(in.token(4)), require_type(in, 3, false), require_type(in, 2, true)};
}

/// Every item takes a byte at the least (unless it has no properties, which is refused below).
Element parse_element(const TextLines& in, std::size_t file_size) {
  const long long n = in.integer(2, "the number of items");
  if (n < 0) throw in.error("announces " + std::to_string(n) + " items, expected at least 0");
  if (static_cast<unsigned long long>(n) > file_size) {
    throw in.error("announces " + std::to_string(n) + " items, more than the file's " + std::to_string(file_size) +
                   " bytes could hold");
  }
  return {std::string(in.token(1)), static_cast<std::size_t>(n), {}};
}

Header parse_header(TextLines& in, std::size_t file_size) {
  Header header;
  in.require("\"ply\"");
  if (in.token(0) != "ply") throw in.error("starts with " + quoted(in.token(0)) + ", expected \"ply\"");
  in.require("\"format\"");
  if (in.token(0) != "format") throw in.error(quoted(in.token(0)) + ", expected \"format\"");
  header.coding = coding_named(in);
  for (in.require("\"end_header\""); in.token(0) != "end_header"; in.require("\"end_header\"")) {
    if (in.token(0) == "comment" || in.token(0) == "obj_info") continue;
    if (in.token(0) == "element") {
      header.elements.push_back(parse_element(in, file_size));
    } else if (in.token(0) == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(parse_property(in));
    } else {
      throw in.error(quoted(in.token(0)) + ", expected \"element\", \"property\" or \"end_header\"");
    }
  }
  header.size = std::min(in.offset(), file_size);
  header.lines = in.line();
  return header;
}

template <class Test>
const Element* find_element(const Header& h, Test test) {
  const auto it = std::find_if(h.elements.begin(), h.elements.end(), test);
  return it == h.elements.end() ? nullptr : &*it;
}

/// One vertex element with x, y, z of one floating type, before one face element with a list of 32-bit corners
/// (what CGAL reads), and nothing without properties.
void require_mesh(const Header& h, const std::string& file) {
  const Element* vertex = find_element(h, is_vertex);
  const Element* face = find_element(h, is_face);
  if (!vertex || vertex->items == 0) throw bad_input(file, 0, "has no vertices, expected an element \"vertex\"");
  if (!face || face->items == 0) throw bad_input(file, 0, "has no faces, expected an element \"face\"");
  if (face < vertex) throw bad_input(file, 0, "has faces before vertices, expected vertices first");
  if (std::count_if(h.elements.begin(), h.elements.end(),
                    [](const Element& e) { return is_vertex(e) || is_face(e); }) != 2) {
    throw bad_input(file, 0, "has repeated elements, expected one \"vertex\" and one \"face\"");
  }
  for (const char* name : {"x", "y", "z"}) {
    const auto has = [&](const Property& p) { return p.name == name && p.type.floating && p.count.bytes == 0; };
    if (std::count_if(vertex->properties.begin(), vertex->properties.end(), has) == 1) continue;
    throw bad_input(file, 0,
                    std::string("has vertices without ") + name + ", expected one property float or double " + name);
  }
  const auto corners = [](const Property& p) {
    return is_corners(p) && p.count.bytes > 0 && p.type.bytes == 4 && !p.type.floating;
  };
  if (std::count_if(face->properties.begin(), face->properties.end(), corners) != 1) {
    throw bad_input(file, 0, "has faces without corners, expected one list of int or uint \"vertex_indices\"");
  }
  for (const Element& e : h.elements) {
    if (e.properties.empty()) throw bad_input(file, 0, "element " + quoted(e.name) + " has no properties");
  }
}

/// The data as a stream of numbers; text and binary differ only here.
class Numbers {
 public:
  Numbers(const std::string& file, std::string_view data, Coding coding, std::size_t lines)
      : file_(file), data_(data), coding_(coding), line_(coding == Coding::text ? lines + 1 : 0) {}

  double next(const Type& type) { return coding_ == Coding::text ? next_text() : next_binary(type); }

  /// How many more values of this size there can be: the bound on every list.
  std::size_t room(const Type& type) const { return (data_.size() - at_) / (coding_ == Coding::text ? 1 : type.bytes); }

  bool at_end() {
    if (coding_ == Coding::text) skip_blanks();
    return at_ == data_.size();
  }

  Failure error(const std::string& what) const { return bad_input(file_, line_, what); }

 private:
  void skip_blanks() {
    for (; at_ < data_.size() && (data_[at_] == ' ' || data_[at_] == '\n'); ++at_) line_ += data_[at_] == '\n';
  }

  double next_text() {
    skip_blanks();
    if (at_ == data_.size()) throw error("file ends early, expected another number");
    const std::size_t end = std::min(data_.find_first_of(" \n", at_), data_.size());
    const std::string_view token = data_.substr(at_, end - at_);
    at_ = end;
    return parse_coordinate(token, file_, line_);
  }

  template <class T>
  double decode(const char* bytes) const {
    char ordered[sizeof(T)];
    std::memcpy(ordered, bytes, sizeof(T));
    if ((coding_ == Coding::big) == (std::endian::native == std::endian::little)) {
      std::reverse(ordered, ordered + sizeof(T));
    }
    T x;
    std::memcpy(&x, ordered, sizeof(T));
    return static_cast<double>(x);
  }

  double next_binary(const Type& type) {
    if (data_.size() - at_ < type.bytes) throw error("file ends early, expected another number");
    const char* bytes = data_.data() + at_;
    at_ += type.bytes;
    if (type.floating) return type.bytes == 4 ? decode<float>(bytes) : decode<double>(bytes);
    switch (type.bytes) {
      case 1:
        return type.is_signed ? decode<std::int8_t>(bytes) : decode<std::uint8_t>(bytes);
      case 2:
        return type.is_signed ? decode<std::int16_t>(bytes) : decode<std::uint16_t>(bytes);
      default:
        return type.is_signed ? decode<std::int32_t>(bytes) : decode<std::uint32_t>(bytes);
    }
  }

  const std::string& file_;
  std::string_view data_;
  Coding coding_;
  std::size_t line_;
  std::size_t at_ = 0;
};

std::string item_name(const Element& e, std::size_t item) { return e.name + " " + std::to_string(item); }

/// A list's length, checked against the bytes that are left before anyone allocates it.
std::size_t list_length(Numbers& in, const Property& p, const std::string& where) {
  const double n = in.next(p.count);
  if (n < 0 || n != std::floor(n)) throw in.error(where + ": list length is not a count");
  if (n > static_cast<double>(in.room(p.type))) {
    throw in.error(where + ": list of " + std::to_string(static_cast<long long>(n)) +
                   " entries, more than the file could hold");
  }
  return static_cast<std::size_t>(n);
}

void scan_corners(Numbers& in, const Property& p, std::size_t vertices, const std::string& where, ScannedMesh& mesh) {
  const std::size_t corners = list_length(in, p, where);
  if (corners < 3) throw in.error(where + " has " + std::to_string(corners) + " corners, expected at least 3");
  for (std::size_t i = 0; i < corners; ++i) {
    const double index = in.next(p.type);
    if (index >= 0 && index < static_cast<double>(vertices) && index == std::floor(index)) continue;
    throw in.error(where + ": vertex index " + std::to_string(static_cast<long long>(index)) +
                   " is out of range, expected 0 to " + std::to_string(vertices - 1));
  }
  mesh.degrees.push_back(corners);
}

void scan_item(Numbers& in, const Element& e, std::size_t item, ScannedMesh& mesh) {
  for (const Property& p : e.properties) {
    const std::string where = item_name(e, item);
    if (is_face(e) && is_corners(p)) {
      scan_corners(in, p, *mesh.vertices, where, mesh);
      continue;
    }
    const std::size_t values = p.count.bytes > 0 ? list_length(in, p, where) : 1;
    for (std::size_t i = 0; i < values; ++i) {
      const bool finite = std::isfinite(in.next(p.type));
      if (!finite && is_vertex(e) && is_coordinate(p)) throw in.error(where + ": " + p.name + " is not finite");
    }
  }
}

}  // namespace

ScannedMesh scan_ply(const std::string& file, std::string& bytes) {
  TextLines lines(bytes, file, '\0');
  const Header header = parse_header(lines, bytes.size());
  require_mesh(header, file);
  if (header.coding == Coding::text) require_text(file, bytes);
  Numbers in(file, std::string_view(bytes).substr(header.size), header.coding, header.lines);
  ScannedMesh mesh{find_element(header, is_vertex)->items, {}};
  for (const Element& e : header.elements) {
    for (std::size_t item = 0; item < e.items; ++item) scan_item(in, e, item, mesh);
  }
  if (!in.at_end()) throw in.error("trailing data after the last element, expected the end of the file");
  return mesh;
}

}  // namespace tribunal
