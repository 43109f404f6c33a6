// The compiler as a stress axis: the same source, the same cases, built otherwise; what of the answers changes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "exact/base/json_fwd.h"
#include "exact/cases/families/family.h"
#include "exact/compilers/builds.h"
#include "exact/trial/count.h"

namespace tribunal {

struct ComparePlan {
  std::vector<Build> builds;         ///< each with the same methods
  std::vector<std::string> methods;  ///< their names
  std::uint64_t seed = 1;
  std::uint64_t cases = 0;  ///< of each format, dealt to all families of triangles in turn
  unsigned threads = 1;
};

/// One method in one build, on the cases of its format.
struct BuildRow {
  std::size_t method, build;
  Format format;
  Count count;                            ///< judged as ever
  std::uint64_t changed = 0;              ///< hit or miss is not what the program's own build says
  std::uint64_t spoiled = 0, mended = 0;  ///< of these, wrong only here; wrong only there
  std::optional<Trial> witness{};         ///< of the changes the first
};

/// Deterministic, whatever the number of threads. Fails with 128 + signal if interrupted.
std::vector<BuildRow> compare_builds(const ComparePlan& plan);

/// Every number, and what the builds are.
Json to_json(const ComparePlan& plan, const std::vector<BuildRow>& rows);

/// What the terminal shows: a row a method, a column a build.
std::string to_table(const ComparePlan& plan, const std::vector<BuildRow>& rows);

}  // namespace tribunal
