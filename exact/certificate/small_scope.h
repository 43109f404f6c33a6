// Sets of cases small enough to run whole: what is said of them is proved, not sampled.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "exact/harness/judge.h"

namespace tribunal {

/// The outcome of a whole set.
struct ScopeResult {
  std::string name;
  std::uint64_t size = 0;          ///< cases in the set
  std::uint64_t answers_hash = 0;  ///< FNV-1a over the method's answers, in the set's order
  Count count{};
  int classes = 0;             ///< how many of the 163 classes the set has
  bool complete = true;        ///< false if interrupted
  std::vector<Query> wrong{};  ///< the first few, in the set's order
};

/// 163 classes × 12 labelled orders × 48 signed axis permutations = 93,888 cases; every coordinate within ±4. The
/// same cases serve both formats. Order: class, then vertex order, direction, axis permutation, signs.
ScopeResult pocket_run(const Method& method);

/// All side³-point lattice tuples, ordered: (side³)⁵ cases, 14,348,907 for side 3. Truth is by class: orientations
/// over 64-bit integers, looked up in the table. Order: a, b, c, p, q, each lexicographic.
ScopeResult lattice_run(const Method& method, int side, unsigned threads);

}  // namespace tribunal
