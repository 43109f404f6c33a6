// The table of axes, each made in the file of its name.
#pragma once

#include "exact/sweep/axes/axis.h"

namespace tribunal {

StressAxis scale_axis();
StressAxis one_scale_axis();
StressAxis offset_axis();
StressAxis sliver_axis();
StressAxis grazing_axis();
StressAxis distance_axis();
StressAxis fill_axis();
StressAxis ulps_axis();
StressAxis direction_axis();
StressAxis spread_axis();
StressAxis vertices_axis();
StressAxis polygon_fill_axis();
StressAxis polygon_scale_axis();

/// All axes, in the order of reports.
std::span<const StressAxis> all_stress_axes();

/// The axis of this name; nullptr if there is none.
const StressAxis* find_stress_axis(std::string_view name);

}  // namespace tribunal
