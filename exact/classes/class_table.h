// The 163 classes of a closed segment and a closed triangle, either possibly degenerate.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "core/answer.h"
#include "core/query.h"
#include "exact/classes/chirotope.h"

namespace tribunal {

inline constexpr int class_count = 163;

/// One row of data/classes163.tsv. Up to vertex order, segment direction and reflection the chirotopes of five
/// points fall into exactly these classes; the ids are frozen.
struct ClassRow {
  ClassId id;
  int rank;                  ///< 1 + dimension of the affine hull of the five points
  std::string triangle;      ///< tri, col (collinear, distinct), dup (two vertices equal), pt
  std::string segment;       ///< seg or pt
  std::string intersection;  ///< empty, point, segment
  std::string touches;       ///< which part of the segment meets which part of the triangle, e.g. "end/E"
  std::uint64_t count_3;     ///< unordered tuples of {0,1,2}³ in the class
  std::uint64_t count_4;     ///< unordered tuples of {0..3}³ in the class
  std::array<std::array<int, 3>, 5> points;  ///< a representative: a, b, c, p, q

  bool hit() const { return intersection != "empty"; }
  Contact contact() const;
  Segment representative_segment() const;
  Triangle representative_triangle() const;
};

/// All rows, the row of id i at index i − 1.
std::span<const ClassRow> class_table();

const ClassRow& class_row(ClassId id);

/// "C001" … "C163"; empty for 0.
std::string class_name(ClassId id);

/// The id of "C017", or 0 if it is none.
ClassId class_named(std::string_view name);

/// The class with this chirotope, or 0: signs that no five points have, as only an inexact kernel can report.
ClassId class_of(const Chirotope& chirotope);

}  // namespace tribunal
