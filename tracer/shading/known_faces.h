// What shading asks of the faces that rays hit, kept for the next ray: neighbours hit the same ones.
#pragma once

#include <array>
#include <cstdint>

#include "exact/filtered/term_filter.h"
#include "tracer/world/world.h"

namespace tribunal {

/// Nobody's id.
inline constexpr std::uint32_t no_face = ~std::uint32_t{0};

struct KnownFace {
  std::uint32_t id = no_face;
  Triangle triangle;  ///< the face, or one in its plane
  Box box;            ///< of the face
  Point3 normal;      ///< of unit length, sees the corners counter-clockwise; zero for a face that rounds to no area
  const Material* material;
  PlaneFilter plane{Triangle{}};
};

/// The faces asked for of late, by the last bits of their ids. One object a thread.
class KnownFaces {
 public:
  explicit KnownFaces(const World& world) : world_(world) {}

  const KnownFace& operator[](std::uint32_t id) {
    KnownFace& face = faces_[id % faces_.size()];
    if (face.id != id) meet(face, id);
    return face;
  }

 private:
  void meet(KnownFace& face, std::uint32_t id) const;

  const World& world_;
  std::array<KnownFace, 64> faces_;
};

}  // namespace tribunal
