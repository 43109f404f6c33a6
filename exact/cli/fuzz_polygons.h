// `fuzz` on polygon families.
#pragma once

#include <string>

#include "exact/polygon/fuzz.h"

namespace tribunal {

/// The streams of the named polygon families ("polygon-affine,polygon-ulp"), or nothing if no name begins with
/// "polygon-". Fails with Exit::usage on an unknown name, or if the names mix polygon families with others.
std::vector<PolygonStream> polygon_streams_named(const std::string& comma_separated);

/// " polygon-affine polygon-ulp …", for help.
std::string polygon_family_names();

/// Runs the plan, prints a table a method × family × format, and writes summary.json and counterexamples.jsonl to
/// `out` unless it is empty. Returns the exit code. Methods that take no polygons are a usage error.
int run_polygons(const PolygonFuzzPlan& plan, const std::string& out, std::size_t keep, bool levels);

}  // namespace tribunal
