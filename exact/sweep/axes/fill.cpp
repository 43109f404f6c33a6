// Exact degeneracies with longer and longer numbers.
#include "exact/cases/families/shapes.h"
#include "exact/sweep/axes/placed.h"
#include "exact/sweep/axes/table.h"

namespace tribunal {
namespace {

constexpr int fills_64[] = {0, 4, 8, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 22, 24, 28, 32, 40, 50};
constexpr int fills_32[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 16, 21};
constexpr auto fills = by_format<fills_64, fills_32>;

Trial place(Draw& draw, Format format, int value, std::uint64_t k) {
  const AffineMap map = draw_placed_map(draw, format, value);
  return placed_image(class_in_turn(k), map, format, draw);
}

}  // namespace

/// The differences of coordinates have about `value` bits, and half of the cases have an offset that fills the
/// significand: where products of differences are exact, so is a naive test that begins with differences.
StressAxis fill_axis() {
  return {.name = "fill",
          .quantity = "bits of the differences of coordinates (entries of the map)",
          .population = "exact affine images of all classes under maps with entries of value bits",
          .easiest = zero,
          .values = fills,
          .stream = stream_of("sweep fill"),
          .place = place};
}

}  // namespace tribunal
