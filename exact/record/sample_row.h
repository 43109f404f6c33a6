// Counts by class as records of a log: what checkpoints and certificates are made of.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "exact/base/record.h"
#include "exact/trial/fuzz.h"

namespace tribunal {

/// Counts of one method in one stream at one level of its stress axis.
struct SampleRow {
  std::string method, family;
  Format format = Format::binary64;
  std::size_t level = 0;
  int stress = 0;                  ///< the level's value on the stress axis
  std::map<Slot, Count> counts{};  ///< only slots in which something was asked
};

Count total_of(const SampleRow& row);

/// The sum over the slots of rays, or of segments.
Count total_of(const SampleRow& row, bool rays);

/// All rows of a report in which anything was asked, in the plan's order.
std::vector<SampleRow> rows_of(const FuzzPlan& plan, const FuzzReport& report);

/// The record "sample". A count is [asked, wrong, unsupported, filter, integers, exact, refused, false hits, false
/// misses, wrong contacts, faults, plain, boundary, extreme, logic, rounding] without trailing zeros; what no stage
/// answered came from a method without stages. Older logs end with `exact`: what their wrong answers are is not said.
Json to_record(const SampleRow& row);
SampleRow to_sample_row(const Record& record);

Json to_array(const Count& count);
Count to_count(const Record& array);

/// What the wrong answers are, by words: "outcomes", "severity", "cause" and "refused".
Json outcomes_of(const Count& count);

/// The member "fmt".
Format format_of(const Record& record);

}  // namespace tribunal
