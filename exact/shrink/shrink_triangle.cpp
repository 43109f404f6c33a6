#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "exact/cases/families/axis_maps.h"
#include "exact/cases/families/pair_vectors.h"
#include "exact/shrink/affine_frame.h"
#include "exact/shrink/shrinker.h"

namespace tribunal {
namespace {

/// The point with +0 for −0, which an axis map makes of zeros.
Point3 without_minus_zero(const Point3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

/// The query under all orders of its vertices (and ends, for a segment) and all signed axis permutations.
std::vector<Query> images_of(Query query) {
  std::vector<Query> images;
  const PairVectors from = vectors_of(query);
  std::array<std::size_t, 3> corner{0, 1, 2};
  do {
    for (const std::size_t first_end : {3U, 4U}) {
      if (first_end == 4 && from.points < 5) continue;  // a ray has no other direction
      const std::size_t source[] = {corner[0], corner[1], corner[2], first_end, 7 - first_end};
      for (const AxisMap& map : axis_maps()) {
        Query image = query;
        const PairVectors to = vectors_of(image);
        for (std::size_t i = 0; i < 5; ++i) *to.v[i] = without_minus_zero(map(*from.v[source[i]]));
        images.push_back(image);
      }
    }
  } while (std::next_permutation(corner.begin(), corner.end()));
  return images;
}

constexpr int frame_bits[] = {1, 2, 3, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 28, 32, 36, 40, 44, 48};
constexpr FrameRounding frame_roundings[] = {
    [](double x, double unit) { return std::nearbyint(x / unit) * unit; },
    [](double x, double unit) { return std::floor(x / unit) * unit; },
    [](double x, double unit) { return std::ceil(x / unit) * unit; },
};

bool take_smaller_frame(Shrinker& s) {
  for (const int bits : frame_bits) {
    for (const FrameRounding round : frame_roundings) {
      const std::optional<Query> candidate = in_smaller_frame(s.best(), s.format(), bits, round);
      if (candidate && s.offer(*candidate)) return true;
    }
  }
  return false;
}

/// Offers the images from the simplest on, until one is found that is still answered wrongly.
bool take_least_image(Shrinker& s) {
  std::vector<std::pair<QueryCost, Query>> simpler;
  for (const Query& image : images_of(s.best())) {
    const QueryCost cost = cost_of(image);
    if (cost < s.cost()) simpler.emplace_back(cost, image);
  }
  std::ranges::stable_sort(simpler, {}, &std::pair<QueryCost, Query>::first);
  return std::ranges::any_of(simpler, [&](const auto& image) { return s.offer(image.second); });
}

}  // namespace

bool simplify_triangle(Shrinker& s) {
  bool simpler = take_smaller_frame(s);
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t vertex = 0; vertex < 4; ++vertex) simpler |= s.translate(axis, vertex);
    simpler |= s.scale(axis);
  }
  simpler |= s.simplify_values();
  simpler |= s.simplify_bounds();
  return simpler || take_least_image(s);
}

}  // namespace tribunal
