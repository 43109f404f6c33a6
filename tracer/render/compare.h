// Where two methods' pictures of one world differ, and why.
#pragma once

#include "exact/cases/case_io.h"
#include "tracer/render/render.h"

namespace tribunal {

/// A pixel for which the two methods made different decisions.
struct DifferingPixel {
  int column, row;
  bool colour_differs;  ///< if false, the decisions differ but the rounded colours are equal
};

/// All pixels on which the decisions of two renderings differ, in row order.
std::vector<DifferingPixel> differing_pixels(const Rendering& a, const Rendering& b);

/// The picture in dim grey, with pixels of another colour in magenta and those of other decisions only in yellow.
Image difference_image(const Image& image, const std::vector<DifferingPixel>& pixels);

/// The first decision of a pixel in which two methods differ.
struct Parting {
  RayKind kind;
  Probe probe;  ///< the first method's probe
  /// A face on which the methods' answers to this probe differ. Empty if they agree on every face, and differ only in
  /// which hit comes first, or because their rays start at different points.
  std::optional<std::uint32_t> face;
  bool other_start;  ///< the second method's ray starts elsewhere: one start is proved, the other customary
};

/// Traces the pixel with both methods and returns their first difference; empty if there is none.
///
/// Up to their first different decision both hit the same faces, since all else is shared arithmetic; but secondary
/// rays of an exact and of an inexact method start at slightly different points (departure.h).
std::optional<Parting> parting_at(const World& world, const Method& a, const Method& b, const DifferingPixel& pixel,
                                  int depth);

/// Whether the method answers wrongly, and the tracer reads its answer otherwise than the exact one: a hit for a miss
/// or a miss for a hit, a contact that makes a face visible or hides it, or an end of a shadow ray told wrongly, so
/// that the face blocks the light or does not. A wrong answer that the tracer reads as it reads the exact one moves no
/// pixel; one that differs by the method's convention, or where its contract owes nothing, is not wrong.
bool shows_wrong_answer(const Method& method, const Query& query);

/// A self-contained case, "px-COLUMN-ROW-KIND-triID" or "…-faceID", that `replay` explains; `expect` is the exact
/// answer, and the finding is of the last of the two that shows a wrong one. The parting must have a face.
Case to_case(const World& world, const Method& a, const Method& b, const DifferingPixel& pixel, const Parting& parting);

}  // namespace tribunal
