// A spread of times as it stands in chart.json.
#pragma once

#include "exact/base/json.h"
#include "exact/chart/timing.h"

namespace tribunal {

inline Json timing_json(const Timing& t) {
  return {
      {"batch", t.batch},   {"repetitions", t.repetitions},       {"min", t.min}, {"lower_quartile", t.lower_quartile},
      {"median", t.median}, {"upper_quartile", t.upper_quartile}, {"max", t.max}};
}

}  // namespace tribunal
