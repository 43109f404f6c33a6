// The rows of the table of families, each made in the file of its name.
#pragma once

#include "exact/cases/families/family.h"

namespace tribunal {

Family affine_family();
Family ulp_family();
Family offset_family();
Family scale_family();
Family zeros_family();
Family midpoint_family();
Family sliver_family();
Family grazing_family();
Family distance_family();
Family near_family();
Family flip_family();
Family shared_family();
Family mesh_family();
Family tilt_family();
Family spread_family();
Family extreme_family();
Family overflow_family();
Family direction_family();
Family size_family();
Family plain_family();
Family bounds_family();

}  // namespace tribunal
