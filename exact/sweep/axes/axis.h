// A stress axis: a quantity that makes cases harder for arithmetic that rounds, and how a case is placed at one value
// of it.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "exact/cases/families/draw.h"
#include "exact/cases/families/family.h"

namespace tribunal {

/// The probes that an axis asks: one that is about directions has nothing to say of segments.
enum class AxisProbes : std::uint8_t { segments_and_rays, rays };

/// How a figure spaces the values: as they are, or by their logarithms, since they are numbers of something.
enum class Spacing : std::uint8_t { even, logarithmic };

/// Adding an axis is adding a file and a row.
struct StressAxis {
  std::string_view name;        ///< on the command line
  std::string_view quantity;    ///< with its unit: what a value says
  std::string_view population;  ///< which cases a figure is about
  Operands operands = Operands::triangles;
  AxisProbes probes = AxisProbes::segments_and_rays;
  Spacing spacing = Spacing::even;
  int (*easiest)(Format);                  ///< one of the values: away from it, on either side, cases become harder
  std::span<const int> (*values)(Format);  ///< in ascending order
  std::uint32_t stream;                    ///< in the register of random streams
  /// The place of case k among its like: which class, or whether the probe is a ray, goes by k in turn. Null where the
  /// rays are aimed at a mesh, and not each at a triangle of its own.
  Trial (*place)(Draw& draw, Format format, int value, std::uint64_t k) = nullptr;

  bool is_of_mesh() const { return place == nullptr; }
  bool has_segments() const { return probes == AxisProbes::segments_and_rays; }
};

/// Case k at a value: a pure function of axis, format, seed, value and k < 2³².
Trial case_at(const StressAxis& axis, Format format, std::uint64_t seed, int value, std::uint64_t k);

/// The easiest value of many axes.
constexpr int zero(Format) { return 0; }

}  // namespace tribunal
