// Class representatives, far from the origin.
#include "exact/cases/families/affine.h"
#include "exact/cases/families/shapes.h"
#include "exact/cases/families/table.h"

namespace tribunal {
namespace {

constexpr int offsets_64[] = {0, 20, 40, 50};
constexpr int offsets_32[] = {0, 10, 20, 22};

constexpr auto levels = by_format<offsets_64, offsets_32>;

/// Entries of at most digits − 5 bits leave 2^digits − 7·2^bits ≥ 2^(digits−1) of room: more than any level.
Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("family offset"), seed, k);
  const ClassTurn turn = class_turn_of(k, levels(format).size());
  AffineMap map = draw_map(draw, static_cast<int>(draw.between(0, digits_of(format) - 5)));
  const std::int64_t far = std::int64_t{1} << levels(format)[turn.level];
  for (std::int64_t& o : map.offset) o = draw.below(2) == 0 ? far : -far;
  return image_of(turn, map, format, draw);
}

}  // namespace

/// Class representatives under small integer maps, far from the origin by an exact 2^level.
Family offset_family() {
  return {.name = "offset",
          .stresses = "all classes, exactly, far from the origin",
          .population = "exact affine images of the class representatives, translated by powers of two",
          .axis = "log2 of the offset",
          .constructs = true,
          .levels = levels,
          .make = make};
}

}  // namespace tribunal
