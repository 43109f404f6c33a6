// A spread of times as it stands in chart.json.
#pragma once

#include "exact/base/json.h"
#include "exact/chart/timing.h"

namespace tribunal {

/// Without `lower` and `upper` where there is no interval.
inline Json median_json(const Median& m) {
  Json object = {{"median", m.value}};
  if (m.has_interval()) object.update({{"lower", m.lower}, {"upper", m.upper}});
  return object;
}

inline Json timing_json(const Timing& t) {
  Json object = {{"batch", t.batch},
                 {"stretches", t.stretches},
                 {"repetitions", t.repetitions},
                 {"min", t.min},
                 {"lower_quartile", t.lower_quartile},
                 {"median", t.median},
                 {"upper_quartile", t.upper_quartile},
                 {"max", t.max}};
  if (t.ratio) object["ratio"] = median_json(*t.ratio);
  return object;
}

}  // namespace tribunal
