// Sets of cases small enough to run whole: what is said of them is proved, not sampled.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "exact/trial/fuzz.h"

namespace tribunal {

/// The outcome of a whole set.
struct ScopeResult {
  std::string name;
  bool of_rays = false;            ///< else of segments
  std::string oracles;             ///< the formulations that agreed on every case
  std::uint64_t size = 0;          ///< cases in the set
  std::uint64_t answers_hash = 0;  ///< FNV-1a over the method's answers, in the set's order
  Count count{};
  int classes = 0;       ///< of all classes, or of the outcomes of polygons, how many the method answered cases of
  bool complete = true;  ///< false if interrupted
  std::vector<Query> wrong{};  ///< the first of each class (or exact contact) × outcome × severity, in the set's order
};

/// What a set is called, and how many cases it has: known before it is run, so that a log can be held to it.
struct SetDescription {
  std::string name;
  std::uint64_t size;
  bool of_rays = false;
};

SetDescription pocket_set();
SetDescription ray_pocket_set();
SetDescription lattice_set(int side);
SetDescription ray_lattice_set(bool full);
SetDescription line_set();
SetDescription rings_set(int most_vertices);
SetDescription ray_rings_set(int most_vertices);
SetDescription holes_set(int vertices);
SetDescription two_holes_set();
SetDescription centred_rings_set();

/// 163 classes × 12 labelled orders × 48 signed axis permutations = 93,888 cases; every coordinate within ±4. The
/// same cases serve both formats. Order: class, then vertex order, direction, axis permutation, signs.
ScopeResult pocket_run(const Method& method);

/// The same of rays: 165 classes × 6 vertex orders × 48 signed axis permutations × 3 lengths of the direction (2⁻¹⁰⁰,
/// 1, 2¹⁰⁰) = 142,560 cases. Order: class, vertex order, axis permutation, signs, length.
ScopeResult ray_pocket_run(const Method& method);

/// All rays with origin and direction in {−1, 0, 1}³ against all ordered triangles of {0, 1, 2}³: 27⁵ = 14,348,907
/// cases; if `full`, with origins in {−1..2}³, directions in {−2..2}³ and triangles of {0, 1, 2}³: 157,464,000. The
/// exact answer to each unordered case is found twice, as in lattice_run. Order: triangle a ≤ b ≤ c, origin, direction,
/// then the distinct orders of the triangle.
ScopeResult ray_lattice_run(const Method& method, bool full, unsigned threads);

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
ScopeResult rings_run(const Method& method, int most_vertices, unsigned threads);

/// Those of 3 and 4 vertices, in this thread.
ScopeResult pocket_of_rings_run(const Method& method);

/// The same rings, each pierced at those points by rays, whose directions take turns at three lengths (2⁻¹⁰⁰, 1, 2¹⁰⁰).
ScopeResult ray_rings_run(const Method& method, int most_vertices, unsigned threads);

/// Every ring of so many vertices of that grid (3 or 4) with every triangular hole, likewise: 2,250,360 and 15,989,400
/// cases. Holes lie inside and outside, cross the ring, touch it in corners and share its edges.
ScopeResult holes_run(const Method& method, int vertices, unsigned threads);

/// The grid's square with every pair of triangular holes, nested, touching and sharing edges: 663,264 cases.
ScopeResult two_holes_run(const Method& method, unsigned threads);

/// Every ring of 3 to 5 vertices that starts at the grid's centre, against points three times as fine: 2,992,626.
ScopeResult centred_rings_run(const Method& method, unsigned threads);

}  // namespace tribunal
