#include "tracer/render/heat_map.h"

#include <algorithm>
#include <cmath>

namespace tribunal {
namespace {

template <class Paint>
Image painted(const Rendering& r, const Paint& paint) {
  Image image(r.image.width, r.image.height);
  std::transform(r.costs.begin(), r.costs.end(), image.pixels.begin(), paint);
  return image;
}

}  // namespace

std::uint64_t greatest_tests(const Rendering& r) {
  std::uint64_t greatest = 0;
  for (const Cost& c : r.costs) greatest = std::max(greatest, c.tests);
  return greatest;
}

Image tests_heat_map(const Rendering& r) {
  const double whole = std::log1p(static_cast<double>(greatest_tests(r)));
  return painted(r, [whole](const Cost& c) {
    const double heat = whole > 0 ? 3 * std::log1p(static_cast<double>(c.tests)) / whole : 0;
    return to_pixel({heat, heat - 1, heat - 2});
  });
}

Image stages_heat_map(const Rendering& r) {
  constexpr Pixel colours[stage_count] = {{0, 0, 0}, {20, 30, 90}, {255, 140, 0}, {255, 255, 255}};
  return painted(r, [&colours](const Cost& c) { return colours[static_cast<std::size_t>(c.deepest)]; });
}

}  // namespace tribunal
