// The 163 classes of a segment and a triangle, and the 165 of a ray and a triangle; any of them possibly degenerate.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "core/answer.h"
#include "core/operands.h"
#include "exact/classes/chirotope.h"

namespace tribunal {

inline constexpr int class_count = 163;      ///< of segments: ids 1..163, named C001..C163
inline constexpr int ray_class_count = 165;  ///< of rays: the ids that follow, named R001..R165
inline constexpr int all_class_count = class_count + ray_class_count;

constexpr bool is_ray_class(ClassId id) { return id > class_count; }

/// One row of data/classes163.tsv or data/ray_classes.tsv; the ids are frozen. Up to vertex order, reflection and, of
/// segments, direction, the chirotopes fall into exactly these classes.
///
/// That there are no more classes of rays: rank 4 has one linear dependency of five vectors, so one sign vector up to
/// negation, whose signs at a, b, c, o are all zero or not all of one sign: 24 up to the order of a, b, c. In rank 3
/// the dependencies are a plane, in which five vectors of small integers, the four of the points adding up to zero, are
/// run through: 110 from coordinates up to 3 on, the same as with all rays of {0..3}³ and {−2..2}³. In rank 2 they are
/// the 30 weak orders of four points on a line with a sense for d; in rank 1 there is one.
struct ClassRow {
  ClassId id;
  int rank;                  ///< of the chirotope: 1 + the dimension that all elements span
  std::string triangle;      ///< tri, col (collinear, distinct), dup (two vertices equal), pt
  std::string probe;         ///< seg, ray or pt
  std::string intersection;  ///< empty, point, segment
  std::string touches;       ///< which part of the probe meets which part of the triangle, e.g. "end/E", "origin/V"
  std::uint64_t count_3;     ///< unordered tuples of {0,1,2}³ in the class; of rays, d from {−1,0,1}³
  std::uint64_t count_4;     ///< unordered tuples of {0..3}³ in the class; of rays, d from {−2..2}³
  std::array<std::array<int, 3>, 5> points;  ///< a representative: a, b, c, p, q or a, b, c, o, d

  bool hit() const { return intersection != "empty"; }
  Contact contact() const;
  Segment representative_segment() const;  ///< of a segment's class
  Ray representative_ray() const;          ///< of a ray's class
  Probe representative_probe() const;
  Triangle representative_triangle() const;
};

/// All classes of segments, that of id i at index i − 1.
std::span<const ClassRow> class_table();

/// All classes of rays, that of id class_count + i at index i − 1.
std::span<const ClassRow> ray_class_table();

const ClassRow& class_row(ClassId id);

/// "C001" … "C163", "R001" … "R165"; empty for 0.
std::string class_name(ClassId id);

/// The id of "C017" or "R017", or 0 if it is none.
ClassId class_named(std::string_view name);

/// The class of segments with this chirotope, or 0: signs that no five points have, as only an inexact kernel can
/// report.
ClassId class_of(const Chirotope& chirotope);

/// The class of rays with this chirotope, or 0.
ClassId ray_class_of(const Chirotope& chirotope);

template <Kernel K>
ClassId class_of(const Segment& s, const Triangle& t, const K& k) {
  return class_of(chirotope(s, t, k));
}

template <Kernel K>
ClassId class_of(const Ray& r, const Triangle& t, const K& k) {
  return ray_class_of(chirotope(r, t, k));
}

}  // namespace tribunal
