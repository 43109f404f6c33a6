// How bad a wrong answer is: whether its query is plain, where no sound test may be wrong.
//
// "Plain" is about where the points lie, and not about one formula. A volume may be far from zero beside the products
// that it is summed from while the probe passes a vertex by two units in the last place: differences of close numbers
// are exact, and so the sum that starts from that vertex is right. Whoever starts from another vertex loses the gap.
// So distances are compared with sizes:
//
//   R, D, T   the longest side of a box (parallel to the axes) around all points, the probe's vector, and the target
//   s         roundness: the largest component of the target's normal, whose length is twice its area, over T²
//   an edge   W/D, where W is six times the volume of the probe with the edge: twice the area that a point of the probe
//             and the edge span, seen along the probe; it is the edge's length times the distance at which the probe's
//             line passes its line, as seen so
//   an end    its height above the plane times |n|, over T², which is s times the height, up to a factor below 2
//   a ray     the same of its direction, which has a size of its own: over T²·D
//
// The *clearance* of a query is the least of s·W/(D·R²) over all edges, height·|n|/(T²·R) over the ends, also those
// that bounds cut, and that of the ray's direction. It is 0 where a sign vanishes, stays the same when everything is
// moved or scaled, and no length of a direction matters.
//
// Why these. A test in a format with unit roundoff u computes volumes from differences of coordinates, which are off by
// u·R at worst, from whatever vertex or end it starts: each such W is off by a few u·D·R², and the volume of an end by
// a few u·T²·R. Tests that first compute the point in the plane, or a stored transformation, divide by the volume of
// plane and direction, and go on in the plane: that point is off along the probe, and twice an area in the plane is
// measured beside |n| instead of T², which is where s comes from. So clearance of a few u is what a sound test needs,
// provided that no coordinate is larger than R: those that multiply coordinates as they stand (Plücker's coordinates, a
// stored plane) have M, the largest coordinate, for R.
//
// So two shares are asked for. The clearance must be at least 2^-18: some micrometres where triangle and probe are a
// metre in size. And, measured with M for R, it must be at least 64 u: that is 2^-18 too if all numbers are exact in
// binary32, so that tests in binary32 may be asked of them, else 2^-47. General position far from the origin, with the
// digits to tell, is plain. The bounds are measured, not proved: in 8 million cases of all families and 2 million of
// ten meshes no test of the shelf is wrong at a clearance above 7 u, measured with M, but for one of which volumes of
// the far end are small (Jiménez, 17 u), those that compare with a tolerance, and one that is unstable
// (docs/findings.md). tests/exact/severity_test.cpp holds smaller samples, half a million cases, to the two bounds.
//
// Computed in double: it ranks reports, and decides no answer.
#pragma once

#include "exact/trial/outcome.h"

namespace tribunal {

/// Clearance as above; measured with R, and with M.
struct Clearance {
  double of_extent, of_coordinates;
};

inline constexpr double least_clearance = 0x1p-18;

/// The query must be finite, and its target have a vertex at least. Without area, or with a probe that is a point, it
/// is 0 or not a number.
Clearance clearance_of(const Query& query);

/// `plain`: at everyday scale, where every coordinate is 0 or within 1e-4 and 1e5 in magnitude, exactly in general
/// position, and at least as clear as said above. Of a polygon general position is that no ring edge is met and that it
/// is planar; one without vertices is at a boundary.
Severity severity_of(const Query& query, const Truth& truth);

}  // namespace tribunal
