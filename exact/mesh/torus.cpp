#include "exact/mesh/torus.h"

#include <glm/vec2.hpp>

namespace tribunal {
namespace {

/// Point i of 4·n on the unit circle. In each quarter the tangent t of half the angle rises from 0 to 1, as
/// tan(π/4·f) does but for 5 %: the steps differ little.
glm::dvec2 on_circle(std::uint32_t i, std::uint32_t n) {
  const double f = static_cast<double>(i % n) / n, t = f * (0.71 + 0.29 * f);
  const double x = (1 - t * t) / (1 + t * t), y = 2 * t / (1 + t * t);
  const glm::dvec2 turned[] = {{x, y}, {-y, x}, {-x, -y}, {y, -x}};
  return turned[i / n % 4];
}

/// Nine times a rotation.
constexpr double tilt[3][3] = {{1, 8, -4}, {4, -4, -7}, {-8, -1, -4}};

Point3 tilted(const Point3& p) {
  Point3 q;
  for (int i = 0; i < 3; ++i) q[i] = (tilt[i][0] * p.x + tilt[i][1] * p.y + tilt[i][2] * p.z) / 9;
  return q;
}

}  // namespace

Mesh torus(std::uint32_t around, std::uint32_t along) {
  constexpr double tube = 0.4;
  Mesh mesh;
  for (std::uint32_t i = 0; i < 4 * around; ++i) {
    const glm::dvec2 u = on_circle(i, around);
    for (std::uint32_t j = 0; j < 4 * along; ++j) {
      const glm::dvec2 v = on_circle(j, along);
      const double ring = 1 + tube * v.x;
      mesh.vertices.push_back(tilted({ring * u.x, ring * u.y, tube * v.y}));
    }
  }
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) { return i % (4 * around) * 4 * along + j % (4 * along); };
  for (std::uint32_t i = 0; i < 4 * around; ++i) {
    for (std::uint32_t j = 0; j < 4 * along; ++j) {
      const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

}  // namespace tribunal
