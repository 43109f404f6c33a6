// A case file and a file of answers to it, both of any length, held against each other.
#pragma once

#include <string>
#include <vector>

#include "exact/base/lines.h"
#include "exact/certificate/own_cases.h"

namespace tribunal {

/// What came of the answers of one method.
struct JudgedAnswers {
  Method method;
  OwnCounts<Spool> counts{};
};

struct Judgement {
  std::vector<JudgedAnswers> methods{};            ///< in the order in which the answers name them
  bool any_triangles = false, any_bounds = false;  ///< among the cases
};

/// Answers every case exactly and judges the answers by the contract. Every method that the answers name must give
/// exactly one answer to every case, known by its id. Fails with Exit::bad_input where a line is wrong, two cases share
/// an id or a case claims something false of itself; at an unknown id and at a second answer; and, with their number,
/// where answers are missing. The result does not depend on the threads. Takes time in proportion to the files.
///
/// Memory: where the answers come in the order of the cases, those of several methods to one case next to each other
/// and always in one order, both files are read side by side in constant memory (and ids go to temporary files, 16
/// bytes a case). Else 16 bytes a case, 2 more for each method, and 40 more for each method that gives numbers.
Judgement judge_files(const Rereadable& cases, const Rereadable& answers, const Contract& contract, unsigned threads);

}  // namespace tribunal
