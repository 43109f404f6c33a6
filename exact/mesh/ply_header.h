// The header of a PLY file: elements and their properties. Source: Turk, "The PLY Polygon File Format", 1994.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "exact/mesh/text.h"

namespace tribunal {

/// A scalar type of PLY; `bytes` is 0 where there is none.
struct PlyType {
  std::size_t bytes = 0;
  bool is_signed = false, floating = false;

  /// Whether n is a value of this integer type.
  bool holds(long long n) const {
    const auto values = 1LL << (8 * bytes);
    return is_signed ? -values / 2 <= n && n < values / 2 : 0 <= n && n < values;
  }
};

/// Which part of a mesh a property describes.
enum class PlyRole { other, x, y, z, corners };

/// A number of each item, or a list of numbers.
struct PlyProperty {
  std::string name;
  PlyType type;
  PlyType count;  ///< the type of a list's length
  PlyRole role = PlyRole::other;

  bool is_list() const { return count.bytes > 0; }
};

struct PlyElement {
  std::string name;
  std::size_t items = 0;
  std::size_t line = 0;  ///< where the header announces it
  std::vector<PlyProperty> properties;

  bool is_vertex() const { return name == "vertex" || name == "vertices"; }
  bool is_face() const { return name == "face" || name == "faces"; }
};

enum class PlyCoding { text, little, big };

struct PlyHeader {
  PlyCoding coding = PlyCoding::text;
  std::vector<PlyElement> elements;  ///< in the order of the data

  const PlyElement& vertex() const;
  const PlyElement& face() const;
};

/// Reads up to the end of the line "end_header". The result has one vertex element with one x, y and z each and one
/// face element with one list of corners, neither of them empty, in any order and among any others; and the text's
/// remaining bytes can hold all items that it announces.
PlyHeader read_ply_header(Text& in);

}  // namespace tribunal
