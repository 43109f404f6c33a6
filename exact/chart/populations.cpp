#include "exact/chart/populations.h"

#include <vector>

#include "exact/cases/families/affine.h"
#include "exact/cases/families/draw.h"
#include "exact/cases/family_table.h"
#include "exact/classes/class_table.h"

namespace tribunal {
namespace {

constexpr Format both[] = {Format::binary32, Format::binary64};
constexpr Format binary32_only[] = {Format::binary32};
constexpr int no_stress[] = {0};

std::span<const int> one_level(Format) { return no_stress; }

/// Multiples of 2⁻²⁴ below 1: exact in binary32, so that every method may be judged on the same bits.
Point3 random_point(Draw& draw) {
  double x[3];
  for (double& coordinate : x) coordinate = static_cast<double>(draw.below(1U << 24)) * 0x1p-24;
  return {x[0], x[1], x[2]};
}

Trial random_points(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("chart general"), seed, k);
  Point3 v[5];
  for (Point3& vertex : v) vertex = random_point(draw);
  return {.query = {Segment{v[3], v[4]}, Triangle{v[0], v[1], v[2]}}, .format = format};
}

/// Case k of `affine` with the longest entries that the format holds.
Trial full_affine(Format format, std::uint64_t seed, std::uint64_t k) {
  static const Family affine = segments_of("affine");
  const std::uint64_t levels = affine.levels(format).size();
  const std::uint64_t last_level = k / class_count * levels + levels - 1;
  return affine.make(format, seed, last_level * class_count + k % class_count);
}

Family general_family() {
  return {.name = "general",
          .stresses = "nothing: five random points",
          .population = "five uniform points of the unit cube",
          .axis = "",
          .constructs = false,
          .levels = one_level,
          .make = random_points};
}

Family degenerate_family() {
  Family family = segments_of("affine");
  family.name = "affine-full";
  family.make = full_affine;
  return family;
}

}  // namespace

Family segments_of(std::string_view name) {
  const Family& whole = *find_family(name);
  Family segments = whole;
  segments.make = [&whole](Format format, std::uint64_t seed, std::uint64_t k) {
    return whole.make(format, seed, segment_case(k));
  };
  return segments;
}

std::span<const Population> all_populations() {
  static const std::vector<Population> table = {
      {"general", "General position", "five random points of the unit cube, binary32 coordinates", general_family(),
       binary32_only},
      {"degenerate", "Exactly degenerate", "affine images of all 163 classes, full mantissas", degenerate_family(),
       both},
      {"near", "Nearly degenerate", "affine images of all 163 classes, one vertex moved by ulps", segments_of("ulp"),
       both},
  };
  return table;
}

Format drawn_format(const Population& population, const Method& method) {
  return population.formats.size() == 1 ? population.formats.front() : method.contract.format;
}

}  // namespace tribunal
