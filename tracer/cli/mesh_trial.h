// What the commands that put tests on trial on a mesh show and write.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "exact/base/json.h"
#include "tracer/leak/report.h"

namespace tribunal {

/// What is to be shown and written of one mesh trial in one format, or of several.
struct MeshTrial {
  std::string text{}, verdicts{};
  Json summaries = Json::array();
  std::vector<Case> cases{};
  std::vector<std::pair<std::string, std::string>> pictures{};  ///< file names and contents
  bool erred = false;
};

/// What a mesh trial is shown by.
struct MeshTrialOptions {
  std::string mesh{}, out{};
  std::uint64_t seed = 1;
  unsigned threads = 1;
  std::size_t keep = 4;
  bool by_aim = false, json = false;
  std::vector<std::string> command{};  ///< the words that make the same trial, but for --out and what changes no count
};

/// Adds a complete trial of one format. Fails with Exit::resources if it judged no ray.
void add(MeshTrial& trial, const MeshTrialOptions& o, const leak::Surface& surface,
         const std::vector<leak::Subject>& subjects, const leak::LeakReport& report);

/// Prints the trial, after the line `first`, or its JSON; writes its files if a directory is given; and returns the
/// exit code.
int finish(const MeshTrial& trial, const MeshTrialOptions& o, const std::string& first);

}  // namespace tribunal
