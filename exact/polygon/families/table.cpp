#include "exact/polygon/families/table.h"

#include <algorithm>
#include <array>

namespace tribunal {

std::span<const PolygonFamily> all_polygon_families() {
  static const std::array table = {
      polygon_affine_family(),   polygon_scale_family(),    polygon_zeros_family(),     polygon_extreme_family(),
      polygon_overflow_family(), polygon_distance_family(), polygon_direction_family(), polygon_ulp_family(),
      polygon_in_plane_family(), polygon_point_family(),    polygon_grid_family(),      polygon_warped_family(),
      polygon_spread_family(),   polygon_rounded_family(),  polygon_size_family(),      polygon_many_family(),
  };
  return table;
}

const PolygonFamily* find_polygon_family(std::string_view name) {
  const auto families = all_polygon_families();
  const auto found = std::ranges::find(families, name, &PolygonFamily::name);
  return found == families.end() ? nullptr : &*found;
}

}  // namespace tribunal
