// PLY: a text header of elements and their properties, then the data in text or in binary of either byte order.
#include "exact/mesh/ply_header.h"
#include "exact/mesh/ply_values.h"
#include "exact/mesh/readers.h"

namespace tribunal {
namespace {

/// Reads what a header announces from PlyText or PlyBytes.
template <class Values>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, Values values) : header_(header), in_(values) {
    soup_.points.reserve(header.vertex().items);
    soup_.ends.reserve(header.face().items);
  }

  PolygonSoup read() {
    for (const PlyElement& element : header_.elements) {
      for (std::size_t item = 0; item < element.items; ++item) read_item(element);
    }
    in_.finish();
    return std::move(soup_);
  }

 private:
  void read_item(const PlyElement& element) {
    Point3 point(0);
    for (const PlyProperty& property : element.properties) read_property(property, point);
    if (element.is_vertex()) soup_.points.push_back(point);
  }

  void read_property(const PlyProperty& property, Point3& point) {
    switch (property.role) {
      case PlyRole::x:
        point.x = in_.coordinate(property.type);
        return;
      case PlyRole::y:
        point.y = in_.coordinate(property.type);
        return;
      case PlyRole::z:
        point.z = in_.coordinate(property.type);
        return;
      case PlyRole::corners:
        return read_corners(property);
      case PlyRole::other:
        return in_.skip(property.type, property.is_list() ? list_length(property) : 1);
    }
  }

  /// A list's length, checked against what is left of the file.
  std::size_t list_length(const PlyProperty& property) {
    const long long n = in_.integer(property.count);
    if (n < 0) throw in_.error("list of " + std::to_string(n) + " entries, expected at least 0");
    const auto length = static_cast<std::size_t>(n);
    if (length <= in_.room(property.type)) return length;
    throw in_.error("list of " + std::to_string(n) + " entries, more than the file could hold");
  }

  void read_corners(const PlyProperty& property) {
    const std::size_t corners = list_length(property);
    if (corners < 3) throw in_.error("face with " + std::to_string(corners) + " corners, expected at least 3");
    for (std::size_t i = 0; i < corners; ++i) soup_.corners.push_back(read_index(property));
    soup_.end_face();
  }

  /// An index of a vertex. Faces may come before the vertices; the header says how many there are.
  std::uint32_t read_index(const PlyProperty& property) {
    const long long index = in_.integer(property.type);
    const auto vertices = static_cast<long long>(header_.vertex().items);
    if (0 <= index && index < vertices) return static_cast<std::uint32_t>(index);
    throw in_.error("vertex index " + std::to_string(index) + " is out of range, expected 0 to " +
                    std::to_string(vertices - 1));
  }

  const PlyHeader& header_;
  Values in_;
  PolygonSoup soup_;
};

std::endian order_of(PlyCoding coding) { return coding == PlyCoding::big ? std::endian::big : std::endian::little; }

}  // namespace

PolygonSoup read_ply(const std::string& file, std::string_view bytes) {
  Text in(file, bytes, {'\0'});
  const PlyHeader header = read_ply_header(in);
  if (header.coding == PlyCoding::text) {
    require_text(file, bytes);
    return PlyReader(header, PlyText(in)).read();
  }
  return PlyReader(header, PlyBytes(Bytes(file, bytes, in.offset(), order_of(header.coding)))).read();
}

}  // namespace tribunal
