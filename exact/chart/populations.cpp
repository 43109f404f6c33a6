#include "exact/chart/populations.h"

#include <cmath>
#include <vector>

#include "exact/cases/families/affine.h"
#include "exact/cases/families/draw.h"
#include "exact/cases/family_table.h"
#include "exact/cases/polygon_families/table.h"
#include "exact/cases/polygons/shapes.h"
#include "exact/classes/class_table.h"
#include "exact/filtered/filtered.h"

namespace tribunal {
namespace {

constexpr int no_stress[] = {0};

std::span<const int> one_level(Format) { return no_stress; }

/// Multiples of 2⁻²⁴, or of 2⁻⁵³, below 1: the whole precision of the format.
Point3 random_point(Draw& draw, Format format) {
  const int bits = format == Format::binary32 ? 24 : 53;
  double x[3];
  for (double& coordinate : x) coordinate = std::ldexp(static_cast<double>(draw.next() >> (64 - bits)), -bits);
  return {x[0], x[1], x[2]};
}

/// Five random points; they are drawn again until the segment hits, if it is to, and else until it misses. Of any 100
/// cases in a row `percent` are to hit, in mixed order, since 37 has no divisor in common with 100.
Trial random_points(Format format, std::uint64_t seed, std::uint64_t k, int percent) {
  const bool wanted = static_cast<int>(k % 100 * 37 % 100) < percent;
  Draw draw(stream_of("chart general"), seed, k);
  for (;;) {
    Point3 v[5];
    for (Point3& vertex : v) vertex = random_point(draw, format);
    const Segment segment{v[3], v[4]};
    const Triangle triangle{v[0], v[1], v[2]};
    if (hits(segment, triangle) == wanted) return {.query = {segment, triangle}, .format = format};
  }
}

/// Case k of `affine` with the longest entries that the format holds.
Trial full_affine(Format format, std::uint64_t seed, std::uint64_t k) {
  static const Family affine = segments_of("affine");
  const std::uint64_t levels = affine.levels(format).size();
  const std::uint64_t last_level = k / class_count * levels + levels - 1;
  return affine.make(format, seed, last_level * class_count + k % class_count);
}

Family general_family(int percent) {
  return {
      .name = "general",
      .stresses = "nothing: five random points",
      .population = "five uniform points of the unit cube",
      .axis = "",
      .constructs = false,
      .levels = one_level,
      .make = [percent](Format f, std::uint64_t seed, std::uint64_t k) { return random_points(f, seed, k, percent); }};
}

Population general(std::string_view key, std::string_view title, int percent) {
  return {.key = key,
          .title = title,
          .about = "five random points of the unit cube",
          .family = general_family(percent),
          .figure = percent == 7 ? Figure::main : Figure::shares,
          .percent_hits = percent};
}

std::string polygon_text() {
  return "affine images of " + std::to_string(shape_count) + " shapes in " + std::to_string(place_count) + " places";
}

std::string class_text(const char* more) {
  return "affine images of all " + std::to_string(class_count) + " classes, " + more;
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
      general("general", "Random, 7 % hits", 7),
      {"degenerate", "Exactly degenerate", class_text("full mantissas"), degenerate_family()},
      {"near", "Nearly degenerate", class_text("one vertex moved by ulps"), segments_of("ulp")},
      general("general-0", "Random, 0 % hits", 0),
      general("general-50", "Random, 50 % hits", 50),
      general("general-100", "Random, 100 % hits", 100),
      {"polygons", "Polygons, degenerate", polygon_text(), polygon_affine_family(), Figure::polygons},
      {"polygons-near", "Polygons, nearly so", "affine images of the shapes, a coordinate moved by ulps",
       polygon_ulp_family(), Figure::polygons},
  };
  return table;
}

bool takes(const Method& method, const Population& population) {
  if (population.of_polygons()) return method.polygon && method.contract.polygons != Polygons::none;
  return method.segment && method.contract.probes.segments && method.contract.triangles != Triangles::none;
}

}  // namespace tribunal
