#include "exact/cases/polygons/construction.h"

#include <algorithm>
#include <vector>

namespace tribunal {
namespace {

std::size_t flat_index(const Construction& c) {
  const auto place = static_cast<std::size_t>(c.place), approach = static_cast<std::size_t>(c.approach);
  return (c.shape * place_count + place) * approach_count + approach;
}

std::vector<Construction> find_constructions() {
  std::vector<Construction> found;
  for (std::size_t shape = 0; shape < shape_count; ++shape) {
    const Places& places = places_of(all_shapes()[shape]);
    for (std::size_t place = 0; place < place_count; ++place) {
      if (places[place].empty()) continue;
      for (int approach = 0; approach < approach_count; ++approach) {
        found.push_back({shape, static_cast<PolygonPlace>(place), static_cast<Approach>(approach)});
      }
    }
  }
  return found;
}

}  // namespace

std::span<const Construction> all_constructions() {
  static const std::vector<Construction> constructions = find_constructions();
  return constructions;
}

std::size_t index_of(const Construction& construction) {
  const std::span<const Construction> all = all_constructions();
  return static_cast<std::size_t>(std::ranges::lower_bound(all, flat_index(construction), {}, flat_index) -
                                  all.begin());
}

}  // namespace tribunal
