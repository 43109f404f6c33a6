// Sets of cases small enough to run whole: what is said of them is proved, not sampled.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "exact/polygon/fuzz.h"

namespace tribunal {

/// The outcome of a whole set.
template <class On>
struct BasicScopeResult {
  std::string name;
  std::string oracles;             ///< the formulations that agreed on every case
  std::uint64_t size = 0;          ///< cases in the set
  std::uint64_t answers_hash = 0;  ///< FNV-1a over the method's answers, in the set's order
  Count count{};
  int classes = 0;       ///< of the 163, or of the outcomes of polygons, how many the method answered cases of
  bool complete = true;  ///< false if interrupted
  std::vector<typename On::Query> wrong{};  ///< the first of each class or outcome, in the set's order
};

using ScopeResult = BasicScopeResult<OnTriangles>;
using PolygonScopeResult = BasicScopeResult<OnPolygons>;

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

/// Every ring of 3 to `most_vertices` vertices on a 3×3 grid that starts with its lowest, each against the 49 points of
/// the half grid around it (pierced through, from and to in turn) and all 45 segments of the grid. 4 vertices: 2,310
/// rings and 217,140 cases; 5: 1,658,442; 6: 13,015,992. The exact answer to each is found twice, by a ray that meets
/// no vertex and by half-open crossings; a contradiction fails with Exit::oracles_contradict.
PolygonScopeResult rings_run(const Method& method, int most_vertices, unsigned threads);

/// Those of 3 and 4 vertices, in this thread.
PolygonScopeResult pocket_of_rings_run(const Method& method);

/// Every quadrilateral of that grid with every triangular hole, likewise: 15,989,400 cases.
PolygonScopeResult holes_run(const Method& method, unsigned threads);

/// Every ring of 3 to 5 vertices that starts at the grid's centre, against points three times as fine: 2,992,626.
PolygonScopeResult centred_rings_run(const Method& method, unsigned threads);

}  // namespace tribunal
