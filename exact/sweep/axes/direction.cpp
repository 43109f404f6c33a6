// Directions far larger or smaller than the geometry.
#include "exact/cases/families/shapes.h"
#include "exact/sweep/axes/placed.h"
#include "exact/sweep/axes/table.h"

namespace tribunal {
namespace {

constexpr int ratios_64[] = {-2000, -1700, -1400, -1200, -1100, -1000, -900, -800, -720, -700,
                             -680,  -640,  -600,  -400,  -200,  0,     200,  400,  600,  640,
                             680,   720,   800,   900,   1000,  1200,  1500, 1700, 2000};
constexpr int ratios_32[] = {-240, -200, -160, -140, -120, -100, -90, -80, -60, -40, -20, 0,
                             20,   40,   60,   70,   80,   90,   100, 120, 160, 200, 240};
constexpr auto ratios = by_format<ratios_64, ratios_32>;

/// Short enough that 2^(bits + 3) times the geometry's scale, or the direction's, is in either format's range, and that
/// products of three are exact.
constexpr int most_bits(Format format) { return format == Format::binary32 ? 3 : 12; }

/// The geometry has the scale 2^−value/2 and the direction 2^value/2.
Trial place(Draw& draw, Format format, int value, std::uint64_t k) {
  AffineMap map = draw_map(draw, static_cast<int>(draw.between(0, most_bits(format))));
  map.scale = {-value / 2, -value / 2, -value / 2};
  return image_of(ray_class_in_turn(k), map, format, draw, value);
}

}  // namespace

StressAxis direction_axis() {
  return {.name = "direction",
          .quantity = "size of a ray's direction over that of the geometry (log2)",
          .population =
              "all classes of rays with short integers, the geometry 2^(-value/2) and the direction 2^(value/2) large",
          .probes = AxisProbes::rays,
          .easiest = zero,
          .values = ratios,
          .stream = stream_of("sweep direction"),
          .place = place};
}

}  // namespace tribunal
