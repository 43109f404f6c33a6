#include "exact/mesh/ply_header.h"

#include <algorithm>

namespace tribunal {
namespace {

struct TypeRow {
  const char *name, *other_name;
  PlyType type;
};

constexpr TypeRow types[] = {
    {"char", "int8", {1, true}},           {"uchar", "uint8", {1}},
    {"short", "int16", {2, true}},         {"ushort", "uint16", {2}},
    {"int", "int32", {4, true}},           {"uint", "uint32", {4}},
    {"float", "float32", {4, true, true}}, {"double", "float64", {8, true, true}},
};

PlyType type_named(const Text& in, std::string_view name, bool integer) {
  for (const TypeRow& row : types) {
    if ((name == row.name || name == row.other_name) && !(integer && row.type.floating)) return row.type;
  }
  throw in.error(in_quotes(name) + ", expected " + (integer ? "an integer type" : "a type") + " of PLY");
}

PlyCoding read_coding(Text& in) {
  const std::string_view name = in.token();
  if (name == "ascii") return PlyCoding::text;
  if (name == "binary_little_endian") return PlyCoding::little;
  if (name == "binary_big_endian") return PlyCoding::big;
  throw in.error("format " + in_quotes(name) + ", expected ascii, binary_little_endian or binary_big_endian");
}

std::string read_name(Text& in) {
  const std::string name(in.token());
  if (name.empty()) throw in.error("the line ends, expected a name");
  return name;
}

/// "property float x" or "property list uchar int vertex_indices", without its first word.
PlyProperty read_property(Text& in) {
  PlyProperty property;
  std::string_view type = in.token();
  if (type == "list") {
    property.count = type_named(in, in.token(), true);
    type = in.token();
  }
  property.type = type_named(in, type, false);
  property.name = read_name(in);
  return property;
}

/// "element vertex 8", without its first word.
PlyElement read_element(Text& in) {
  PlyElement element;
  element.line = in.line();
  element.name = read_name(in);
  const long long n = in.integer("the number of items");
  if (n < 0) throw in.error("announces " + std::to_string(n) + " items, expected at least 0");
  element.items = static_cast<std::size_t>(n);
  return element;
}

bool is_remark(std::string_view word) { return word == "comment" || word == "obj_info"; }

/// The next word that starts a line and is no remark.
std::string_view read_keyword(Text& in, const char* expected) {
  for (;;) {
    in.require_line(expected);
    const std::string_view word = in.token();
    if (!is_remark(word)) return word;
  }
}

void read_declaration(Text& in, std::string_view word, PlyHeader& header) {
  if (word == "element") {
    header.elements.push_back(read_element(in));
  } else if (word == "property" && !header.elements.empty()) {
    header.elements.back().properties.push_back(read_property(in));
  } else {
    throw in.error(in_quotes(word) + ", expected \"element\", \"property\" or \"end_header\"");
  }
  in.require_line_end("the end of the line");
}

PlyHeader parse(Text& in) {
  PlyHeader header;
  in.require_line("\"ply\"");
  const std::string_view magic = in.token();
  if (magic != "ply") throw in.error("starts with " + in_quotes(magic) + ", expected \"ply\"");
  const std::string_view format = read_keyword(in, "\"format\"");
  if (format != "format") throw in.error(in_quotes(format) + ", expected \"format\"");
  header.coding = read_coding(in);
  for (;;) {
    const std::string_view word = read_keyword(in, "\"end_header\"");
    if (word == "end_header") return header;
    read_declaration(in, word, header);
  }
}

PlyRole role_on_vertex(const PlyProperty& p) {
  if (p.is_list()) return PlyRole::other;
  return p.name == "x" ? PlyRole::x : p.name == "y" ? PlyRole::y : p.name == "z" ? PlyRole::z : PlyRole::other;
}

PlyRole role_on_face(const PlyProperty& p) {
  const bool corners = p.name == "vertex_indices" || p.name == "vertex_index";
  return corners && p.is_list() && !p.type.floating ? PlyRole::corners : PlyRole::other;
}

/// An error unless exactly one property has the role.
void require_role(const std::string& file, const PlyElement& element, PlyRole role, const char* expected) {
  const auto has = [role](const PlyProperty& p) { return p.role == role; };
  if (std::count_if(element.properties.begin(), element.properties.end(), has) == 1) return;
  throw bad_input(file, element.line, "element " + in_quotes(element.name) + ", expected one property " + expected);
}

void assign_roles(const std::string& file, PlyElement& element) {
  if (element.properties.empty()) {
    throw bad_input(file, element.line, "element " + in_quotes(element.name) + " has no properties");
  }
  for (PlyProperty& p : element.properties) {
    if (element.is_vertex()) p.role = role_on_vertex(p);
    if (element.is_face()) p.role = role_on_face(p);
  }
  if (element.is_vertex()) {
    require_role(file, element, PlyRole::x, "x that is a number");
    require_role(file, element, PlyRole::y, "y that is a number");
    require_role(file, element, PlyRole::z, "z that is a number");
  } else if (element.is_face()) {
    require_role(file, element, PlyRole::corners, "\"vertex_indices\" that is a list of integers");
  }
}

template <class Test>
const PlyElement* only(const std::vector<PlyElement>& elements, Test test) {
  const auto first = std::find_if(elements.begin(), elements.end(), test);
  if (first == elements.end() || std::any_of(first + 1, elements.end(), test)) return nullptr;
  return &*first;
}

template <class Test>
void require_items(const Text& in, const PlyHeader& header, Test test, const char* name) {
  const PlyElement* const element = only(header.elements, test);
  if (!element) throw bad_input(in.file(), in.line(), std::string("expected exactly one element \"") + name + "\"");
  if (element->items > 0) return;
  throw bad_input(in.file(), element->line, std::string("announces 0 items, expected at least 1 ") + name);
}

bool is_vertex(const PlyElement& e) { return e.is_vertex(); }
bool is_face(const PlyElement& e) { return e.is_face(); }

/// The fewest bytes that an item takes: in text a digit and a blank for each property, in binary its bytes; a list may
/// be empty, but its length is always there.
std::size_t least_size(const PlyElement& element, PlyCoding coding) {
  std::size_t size = 0;
  for (const PlyProperty& p : element.properties) {
    size += coding == PlyCoding::text ? 2 : p.is_list() ? p.count.bytes : p.type.bytes;
  }
  return size;
}

/// An error unless `size` bytes can hold the items that the header announces. The last number of a text needs no blank
/// after it.
void require_room(const Text& in, const PlyHeader& header, std::size_t size) {
  std::size_t left = size + (header.coding == PlyCoding::text);
  for (const PlyElement& element : header.elements) {
    const std::size_t least = least_size(element, header.coding);
    if (element.items > left / least) {
      throw bad_input(in.file(), element.line,
                      "announces " + std::to_string(element.items) + " items, more than the file could hold in " +
                          std::to_string(size) + " bytes of data");
    }
    left -= element.items * least;
  }
}

}  // namespace

const PlyElement& PlyHeader::vertex() const { return *only(elements, is_vertex); }
const PlyElement& PlyHeader::face() const { return *only(elements, is_face); }

PlyHeader read_ply_header(Text& in) {
  PlyHeader header = parse(in);
  require_items(in, header, is_vertex, "vertex");
  require_items(in, header, is_face, "face");
  for (PlyElement& element : header.elements) assign_roles(in.file(), element);
  require_room(in, header, in.size() - in.offset());
  return header;
}

}  // namespace tribunal
