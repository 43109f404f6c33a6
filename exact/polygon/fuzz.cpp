#include "exact/polygon/fuzz.h"

#include "exact/harness/fuzz_run.h"

namespace tribunal {

template PolygonFuzzReport empty_report(const PolygonFuzzPlan& plan);
template PolygonFuzzReport fuzz(const PolygonFuzzPlan& plan, PolygonFuzzReport so_far,
                                const Checkpoint<OnPolygons>& checkpoint);

std::vector<PolygonStream> all_polygon_streams() {
  std::vector<PolygonStream> streams;
  for (const PolygonFamily& family : all_polygon_families()) {
    for (const Format format : {Format::binary64, Format::binary32}) streams.push_back({&family, format});
  }
  return streams;
}

}  // namespace tribunal
