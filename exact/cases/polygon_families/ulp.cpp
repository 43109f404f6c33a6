// Neighbours of constructions, some units in the last place away.
#include "exact/cases/families/ulp.h"

#include "exact/cases/polygon_families/aim.h"
#include "exact/cases/polygon_families/table.h"
#include "exact/cases/polygon_families/vectors.h"

namespace tribunal {
namespace {

constexpr int steps[] = {1, 2, 8, 64, 1024};

std::span<const int> levels(Format) { return steps; }

/// A random vertex; every other time the source or the target of the probe, which for a ray is its direction.
Point3& draw_vector(Draw& draw, Query& query) {
  const bool of_probe = draw.below(2) == 0;
  if (of_probe) return *vectors_of(query.probe)[draw.below(2)];
  return query.polygon().vertices[draw.below(query.polygon().vertices.size())];
}

Trial make(Format format, std::uint64_t seed, std::uint64_t k) {
  Draw draw(stream_of("polygon family ulp"), seed, k);
  const Aim aim = draw_aim(k, std::size(steps), draw);
  const int bits = draw_fill(draw, format);
  const AffineMap map = draw_polygon_map(draw, format, bits);
  Trial trial = image_of(aim, map, format, draw);
  trial.construction.reset();
  Point3& v = draw_vector(draw, trial.query);
  const auto axis = static_cast<int>(draw.below(3));
  const std::int64_t by = draw.below(2) == 0 ? steps[trial.level] : -steps[trial.level];
  v[axis] = moved_by_ulps(v[axis], by, format);
  return trial;
}

}  // namespace

/// An affine image of a shape with one coordinate, of a vertex or of the probe, moved by ±level units in the last
/// place.
Family polygon_ulp_family() {
  return {.name = "polygon-ulp",
          .stresses = "near-degeneracy: one coordinate some ulps off, of a vertex or of the probe",
          .population = "affine images of the shapes, one coordinate moved",
          .axis = "units in the last place",
          .constructs = false,
          .levels = levels,
          .make = make,
          .operands = Operands::polygons};
}

}  // namespace tribunal
