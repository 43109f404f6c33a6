#include "exact/cases/family_table.h"

#include <algorithm>
#include <array>

#include "exact/cases/families/table.h"
#include "exact/cases/polygon_families/table.h"

namespace tribunal {
namespace {

std::span<const Family> triangle_families() {
  static const std::array table = {
      affine_family(), ulp_family(),     offset_family(),   scale_family(),   zeros_family(),    midpoint_family(),
      sliver_family(), grazing_family(), distance_family(), near_family(),    flip_family(),     shared_family(),
      mesh_family(),   tilt_family(),    spread_family(),   extreme_family(), overflow_family(), direction_family(),
      size_family(),   plain_family(),   bounds_family(),
  };
  return table;
}

}  // namespace

std::span<const Family> families_of(Operands operands) {
  return operands == Operands::triangles ? triangle_families() : polygon_families();
}

const Family* find_family(std::string_view name) {
  for (const Operands operands : {Operands::triangles, Operands::polygons}) {
    const auto families = families_of(operands);
    const auto found = std::ranges::find(families, name, &Family::name);
    if (found != families.end()) return &*found;
  }
  return nullptr;
}

}  // namespace tribunal
