// What is kept of a sweep: all that a figure needs.
#pragma once

#include <string>
#include <vector>

#include "exact/base/figures.h"
#include "exact/base/json_fwd.h"
#include "exact/cases/case_io.h"
#include "exact/sweep/thresholds.h"

namespace tribunal {

/// A threshold with its first witness, shrunk; a refusal is no counterexample, and its witness stays as it is.
struct WitnessedThreshold {
  Threshold threshold;
  Case witness;
};

/// In the order of the thresholds. Shrinks on `threads` threads; the bytes do not depend on how many.
std::vector<WitnessedThreshold> with_witnesses(const SweepPlan& plan, const Sweep& sweep,
                                               const std::vector<Threshold>& thresholds);

/// sweep.json. Rows and thresholds stand on one line each.
std::string to_json_text(const SweepPlan& plan, const Sweep& sweep, const std::vector<WitnessedThreshold>& thresholds);

/// sweep.csv: one line for each place and outcome.
std::string to_csv(const SweepPlan& plan, const Sweep& sweep);

/// What the terminal shows: the worst of each method, and where it begins to fail.
std::string to_table(const SweepPlan& plan, const Sweep& sweep, const std::vector<Threshold>& thresholds);

/// The figures that are drawn of sweep.json.
inline const FigureNames sweep_figures = {"thresholds", "axis-*"};

/// The name of the file of the mesh that an axis aimed at, for `leak` and `render`.
std::string mesh_file(const SweepPlan& plan);

/// Writes sweep.csv, witnesses.jsonl, the mesh if an axis has one, and sweep.json to the directory, together. Figures
/// of an earlier record go.
void write_record(const std::string& directory, const SweepPlan& plan, const Sweep& sweep,
                  const std::vector<WitnessedThreshold>& thresholds);

}  // namespace tribunal
