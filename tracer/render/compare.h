// Where two methods' pictures of one world part, and why.
#pragma once

#include "exact/cases/case_io.h"
#include "tracer/render/render.h"

namespace tribunal {

/// A pixel on which the methods decided differently somewhere.
struct DifferingPixel {
  int column, row;
  bool colour_differs;  ///< false: the decisions differ, but the colours round to the same
};

/// All of them in row order.
std::vector<DifferingPixel> differing_pixels(const Rendering& a, const Rendering& b);

/// The picture in dim grey, with pixels of another colour in magenta and those of other decisions only in yellow.
Image difference_image(const Image& image, const std::vector<DifferingPixel>& pixels);

/// The first decision of a pixel on which two methods part.
struct Parting {
  RayKind kind;
  Probe probe;  ///< the first method's
  /// A face on which the methods' answers to this probe differ; empty if they agree on every face and part only about
  /// which hit comes first, or because they were asked about rays that start at different points.
  std::optional<std::uint32_t> face;
  bool other_start;  ///< the second method was asked about another ray: one start is proved, the other customary
};

/// Traces the pixel with both methods. Empty if they agree after all.
///
/// Up to the first different outcome both met the same faces, since all else is shared arithmetic; but secondary rays
/// of an exact and an inexact method start at slightly different points (departure.h).
std::optional<Parting> parting_at(const World& world, const Method& a, const Method& b, const DifferingPixel& pixel,
                                  int depth);

/// A self-contained case, "px-COLUMN-ROW-KIND-triID" or "…-faceID", that `replay` explains; `expect` is the exact
/// answer. The parting must have a face.
Case to_case(const World& world, const Method& a, const Method& b, const DifferingPixel& pixel, const Parting& parting);

}  // namespace tribunal
