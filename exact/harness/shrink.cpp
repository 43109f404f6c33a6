#include "exact/harness/shrink.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "exact/families/axis_maps.h"
#include "exact/families/query_vectors.h"
#include "exact/harness/affine_frame.h"
#include "exact/harness/shrink_run.h"

namespace tribunal {
namespace {

struct Cost {
  CoordinateCost simplicity{};
  std::array<double, 15> coordinates{};
  auto operator<=>(const Cost&) const = default;
};

Cost cost_of(Query query) {
  Cost cost;
  std::size_t i = 0;
  for (const Point3* v : vectors_of(query).v) {
    for (int axis = 0; axis < 3; ++axis) {
      cost.simplicity.add((*v)[axis]);
      cost.coordinates[i++] = (*v)[axis];
    }
  }
  return cost;
}

/// Zeros as +0: an axis map makes −0 of them.
Point3 without_minus_zero(const Point3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }

/// The query under all orders of its vertices (and ends, for a segment) and all signed axis permutations.
std::vector<Query> images_of(Query query) {
  std::vector<Query> images;
  const QueryVectors from = vectors_of(query);
  std::array<std::size_t, 3> corner{0, 1, 2};
  do {
    for (const std::size_t first_end : {3U, 4U}) {
      if (first_end == 4 && from.points < 5) continue;  // a ray has no other direction
      const std::size_t source[] = {corner[0], corner[1], corner[2], first_end, 7 - first_end};
      for (const AxisMap& map : axis_maps()) {
        Query image = query;
        const QueryVectors to = vectors_of(image);
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

struct TriangleShrinking {
  using Query = tribunal::Query;
  using Truth = tribunal::Truth;

  static Cost cost_of(const Query& query) { return tribunal::cost_of(query); }
  static QueryVectors vectors_of(Query& query) { return tribunal::vectors_of(query); }
  static bool same_case(const Truth& a, const Truth& b) { return a.class_id == b.class_id && a.contact == b.contact; }
};

class TriangleShrinker : public Shrinker<TriangleShrinking> {
 public:
  TriangleShrinker(const Method& method, const Query& query, Format format)
      : Shrinker(method, query, format), format_(format) {}

  bool pass() {
    bool simpler = take_smaller_frame();
    for (int axis = 0; axis < 3; ++axis) {
      for (std::size_t vertex = 0; vertex < 4; ++vertex) simpler |= translate(axis, vertex);
      simpler |= scale(axis);
    }
    simpler |= simplify_values();
    return simpler || take_least_image();
  }

 private:
  bool take_smaller_frame() {
    for (const int bits : frame_bits) {
      for (const FrameRounding round : frame_roundings) {
        const std::optional<Query> candidate = in_smaller_frame(best(), format_, bits, round);
        if (candidate && offer(*candidate)) return true;
      }
    }
    return false;
  }

  /// From the simplest image up, until one is still answered wrongly.
  bool take_least_image() {
    std::vector<std::pair<Cost, Query>> simpler;
    for (const Query& image : images_of(best())) {
      const Cost cost_of_image = cost_of(image);
      if (cost_of_image < cost()) simpler.emplace_back(cost_of_image, image);
    }
    std::ranges::stable_sort(simpler, {}, &std::pair<Cost, Query>::first);
    return std::ranges::any_of(simpler, [&](const auto& image) { return offer(image.second); });
  }

  const Format format_;
};

}  // namespace

Query shrink(const Method& method, const Query& query, Format format) {
  TriangleShrinker shrinker(method, query, format);
  while (shrinker.pass()) {
  }
  return shrinker.best();
}

bool is_simpler(const Query& a, const Query& b) { return cost_of(a) < cost_of(b); }

}  // namespace tribunal
