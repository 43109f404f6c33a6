// What shading needs of the faces that rays hit, cached since neighbouring rays hit the same faces.
#pragma once

#include <array>
#include <cstdint>

#include "exact/filtered/term_filter.h"
#include "tracer/world/world.h"

namespace tribunal {

using namespace detail;

/// The id of no face.
inline constexpr std::uint32_t no_face = ~std::uint32_t{0};

struct KnownFace {
  std::uint32_t id = no_face;
  Triangle triangle;  ///< the face, or one in its plane
  Box box;            ///< the box of the face
  Point3 normal;  ///< of unit length, on the side that sees the vertices counterclockwise; 0 if the rounded area is 0
  const Material* material;
  PlaneFilter plane{Triangle{}};
};

/// A cache of faces, indexed by the last bits of their ids. Not thread-safe: one object per thread.
class KnownFaces {
 public:
  explicit KnownFaces(const World& world) : world_(world) {}

  const KnownFace& operator[](std::uint32_t id) {
    KnownFace& face = faces_[id % faces_.size()];
    if (face.id != id) fill(face, id);
    return face;
  }

 private:
  void fill(KnownFace& face, std::uint32_t id) const;

  const World& world_;
  std::array<KnownFace, 64> faces_;
};

}  // namespace tribunal
