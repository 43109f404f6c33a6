#include "exact/mesh/read_mesh.h"
#include "exact/mesh/triangulate.h"
#include "tests/fuzz/targets.h"

namespace tribunal::fuzzing {
namespace {

/// Finite points, and faces of at least three corners that are all among the points.
void demand_whole(const PolygonSoup& soup) {
  demand(soup.size() > 0, "a mesh without faces");
  for (const Point3& p : soup.points) demand(is_finite(p), "a point that is not finite");
  for (const std::uint32_t i : soup.corners) demand(i < soup.points.size(), "a corner that is no point");
  for (std::size_t f = 0; f < soup.size(); ++f) demand(soup.face(f).size() >= 3, "a face with less than three corners");
}

void read(const char* file, std::string_view bytes) {
  accepts([&] {
    PolygonSoup soup = read_soup(file, bytes);
    demand_whole(soup);
    mesh_of(std::move(soup));
  });
}

}  // namespace

void off(std::string_view bytes) { read("fuzzed.off", bytes); }
void obj(std::string_view bytes) { read("fuzzed.obj", bytes); }
void ply(std::string_view bytes) { read("fuzzed.ply", bytes); }
void stl(std::string_view bytes) { read("fuzzed.stl", bytes); }

}  // namespace tribunal::fuzzing
