#include "exact/sweep/axes/table.h"

#include <algorithm>
#include <array>

namespace tribunal {

std::span<const StressAxis> all_stress_axes() {
  static const std::array table = {scale_axis(),        one_scale_axis(), offset_axis(),   sliver_axis(),
                                   grazing_axis(),      distance_axis(),  fill_axis(),     ulps_axis(),
                                   direction_axis(),    spread_axis(),    vertices_axis(), polygon_fill_axis(),
                                   polygon_scale_axis()};
  return table;
}

const StressAxis* find_stress_axis(std::string_view name) {
  const auto found = std::ranges::find(all_stress_axes(), name, &StressAxis::name);
  return found == all_stress_axes().end() ? nullptr : &*found;
}

}  // namespace tribunal
