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
  std::string oracles;             ///< the formulations that agreed on every case
  std::uint64_t size = 0;          ///< cases in the set
  std::uint64_t answers_hash = 0;  ///< FNV-1a over the method's answers, in the set's order
  Count count{};
  int classes = 0;             ///< of the 163, how many the method answered cases of
  bool complete = true;        ///< false if interrupted
  std::vector<Query> wrong{};  ///< the first of each class, in the set's order
};

/// 163 classes × 12 labelled orders × 48 signed axis permutations = 93,888 cases; every coordinate within ±4. The
/// same cases serve both formats. Order: class, then vertex order, direction, axis permutation, signs.
ScopeResult pocket_run(const Method& method);

/// All ordered tuples of {0..side−1}³: (side³)⁵ cases, 14,348,907 for side 3 and 1,073,741,824 for side 4. The exact
/// answer to each unordered tuple is found twice, by class (32-bit orientations, looked up) and by Carathéodory's
/// theorem (32-bit integers), and the tuples of each class are counted against the table; a contradiction fails with
/// Exit::oracles_contradict. The method is asked in every order. Order: triangle a ≤ b ≤ c, segment p ≤ q
/// (lexicographic), then the distinct orders of each.
ScopeResult lattice_run(const Method& method, int side, unsigned threads);

/// All ordered tuples of five points of a line, along each of the 13 directions of {−1,0,1}³: 13·5⁵ = 40,625 cases.
/// With {0..3}³ they have every class. Exact answers as in lattice_run.
ScopeResult line_run(const Method& method);

}  // namespace tribunal
