#include "exact/families/family.h"

#include <algorithm>
#include <array>

#include "exact/families/table.h"

namespace tribunal {

std::span<const Family> all_families() {
  static const std::array table = {
      affine_family(),   ulp_family(),      offset_family(),    scale_family(),    zeros_family(),
      midpoint_family(), sliver_family(),   grazing_family(),   distance_family(), near_family(),
      flip_family(),     shared_family(),   mesh_family(),      tilt_family(),     spread_family(),
      extreme_family(),  overflow_family(), direction_family(), size_family(),
  };
  return table;
}

const Family* find_family(std::string_view name) {
  const auto families = all_families();
  const auto found = std::ranges::find(families, name, &Family::name);
  return found == families.end() ? nullptr : &*found;
}

}  // namespace tribunal
