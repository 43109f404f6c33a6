#include "exact/cases/polygon_families/table.h"

#include <array>

namespace tribunal {

std::span<const Family> polygon_families() {
  static const std::array table = {
      polygon_affine_family(),   polygon_scale_family(),    polygon_zeros_family(),     polygon_extreme_family(),
      polygon_overflow_family(), polygon_distance_family(), polygon_direction_family(), polygon_ulp_family(),
      polygon_in_plane_family(), polygon_point_family(),    polygon_grid_family(),      polygon_warped_family(),
      polygon_spread_family(),   polygon_rounded_family(),  polygon_size_family(),      polygon_many_family(),
  };
  return table;
}

}  // namespace tribunal
