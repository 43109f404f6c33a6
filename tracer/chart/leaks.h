// How often methods leak on a mesh, for a chart.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/method.h"
#include "exact/base/json_fwd.h"
#include "exact/mesh/mesh.h"
#include "tracer/leak/surface.h"

namespace tribunal {

struct LeakChartPlan {
  std::vector<Method> methods;  ///< those that take no rays of triangles are left out
  std::string mesh;             ///< file name, for messages
  std::uint64_t seed = 1, rays = 0;
  unsigned threads = 1;
};

/// One method under the rays of one format.
struct LeakRow {
  std::size_t method = 0;
  Format format = Format::binary64;
  std::uint64_t rays = 0, leaks = 0;
};

/// The mesh in either format, read before anything is measured. Fails as leak::Surface does.
std::vector<leak::Surface> surfaces_of(const Mesh& triangles, const std::string& file);

/// In the order surface, method, by the trial of tracer/leak. Does not depend on the number of threads. Fails with
/// 128 + signal if interrupted, and with Exit::resources if no ray could be judged.
std::vector<LeakRow> measure_leaks(const LeakChartPlan& plan, std::span<const leak::Surface> surfaces);

/// {"mesh", "rows"}.
Json to_json(const LeakChartPlan& plan, const std::vector<LeakRow>& rows);
std::string to_table(const LeakChartPlan& plan, const std::vector<LeakRow>& rows);

}  // namespace tribunal
