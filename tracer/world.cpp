#include "tracer/world.h"

#include <cmath>

#include "exact/io/failure.h"

namespace tribunal {
namespace {

struct Triangles {
  std::vector<Triangle> list;
  std::vector<std::uint32_t> solid_of;
};

Triangles gather(const Scene& scene, Format format) {
  Triangles all;
  for (std::uint32_t s = 0; s < scene.solids.size(); ++s) {
    const Mesh& mesh = scene.solids[s].mesh;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const Triangle t = mesh.triangle(i);
      const Triangle rounded{in_format(t.a, format), in_format(t.b, format), in_format(t.c, format)};
      if (!is_finite(rounded)) {
        throw bad_input(scene.file, 0,
                        "solids[" + std::to_string(s) +
                            "]: a vertex is beyond binary32, expected one that the method can represent");
      }
      all.list.push_back(rounded);
      all.solid_of.push_back(s);
    }
  }
  return all;
}

double greatest_coordinate(const std::vector<Triangle>& triangles) {
  double greatest = 0;
  for (const Triangle& t : triangles) {
    for (const Point3& v : {t.a, t.b, t.c}) {
      greatest = std::max({greatest, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    }
  }
  return greatest;
}

}  // namespace

World make_world(const Scene& scene, Format format, Accel accel) {
  Triangles all = gather(scene, format);
  BoxTree tree(accel, all.list, all.solid_of);
  const double step = scene.bias * greatest_coordinate(all.list);
  return {&scene, format, std::move(all.list), std::move(all.solid_of), std::move(tree), step};
}

}  // namespace tribunal
