// Segments against exactly planar polygons, drawn for a benchmark, with every answer known by integers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/polygon.h"

namespace tribunal::bench {

/// convex: a ring around a circle. concave: a star, with every other vertex moved inward (of four vertices, one).
/// holed: half of the vertices are a convex hole in a convex ring. concave_holed: a quarter of them are a convex hole
/// in a star.
enum class Outline : std::uint8_t { convex, concave, holed, concave_holed };

inline constexpr Outline all_outlines[] = {Outline::convex, Outline::concave, Outline::holed, Outline::concave_holed};

const char* name_of(Outline outline);

/// The least number of vertices that the outline takes.
int least_vertices(Outline outline);

/// Segments with both ends uniform in the cube around the polygon: half of them miss its plane. `hits_N` has N % hits
/// dealt among them; of `plane_missed`, 95 % miss the plane and the others the polygon. `boundary`: every segment runs
/// exactly through a ring vertex or the midpoint of a ring edge, which are hits.
enum class Mix : std::uint8_t { hits_0, hits_7, hits_50, plane_missed, boundary };

inline constexpr Mix all_mixes[] = {Mix::hits_0, Mix::hits_7, Mix::hits_50, Mix::plane_missed, Mix::boundary};

const char* name_of(Mix mix);

struct PolygonProbe {
  Segment segment;
  std::uint32_t polygon;  ///< an index
  bool hit;               ///< as integers say
};

struct Population {
  Outline outline;
  int vertices;
  Mix mix;
  std::vector<PolygonData> polygons;  ///< each in its own random plane, full mantissas, coordinates of a few units
  std::vector<PolygonProbe> probes;   ///< polygons in random order; general position but for `boundary`
  std::size_t hits = 0, plane_missed = 0;

  std::string name() const;  ///< e.g. "hits_7/convex/n4"
};

Population draw_population(Outline outline, int vertices, Mix mix, std::size_t polygons, std::size_t probes);

}  // namespace tribunal::bench
