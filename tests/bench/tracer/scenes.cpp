#include "tests/bench/tracer/scenes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/format.h"
#include "exact/cases/families/draw.h"

namespace tribunal::bench {
namespace {

constexpr std::uint32_t ray_stream = stream_of("benchmark rays");

Point3 rounded(const Point3& p) { return in_format(p, Format::binary32); }

Point3 on_torus(double u, double v) {
  const double tube = 0.4 + 0.05 * std::sin(9 * u) * std::cos(7 * v);
  const double ring = 1 + tube * std::cos(v);
  return rounded({ring * std::cos(u), ring * std::sin(u), tube * std::sin(v)});
}

Point3 uniform_point(Draw& draw, double half) {
  Point3 p;
  for (int i = 0; i < 3; ++i) p[i] = half * (std::ldexp(static_cast<double>(draw.next() >> 11), -52) - 1);
  return p;
}

Ray through(const Point3& from, const Point3& to) {
  const Point3 o = rounded(from);
  return {o, {rounded(glm::normalize(to - o))}};
}

}  // namespace

Mesh torus(std::uint32_t n) {
  const std::uint32_t around = 2 * n, along = n;
  Mesh mesh;
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < along; ++j) {
      mesh.vertices.push_back(on_torus(2 * std::numbers::pi * i / around, 2 * std::numbers::pi * j / along));
    }
  }
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) { return i % around * along + j % along; };
  for (std::uint32_t i = 0; i < around; ++i) {
    for (std::uint32_t j = 0; j < along; ++j) {
      const std::uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

std::vector<Ray> coherent_rays(int side) {
  const Point3 eye(0.9, -2.6, 2.2), ahead = glm::normalize(-eye);
  const Point3 right = glm::normalize(glm::cross(ahead, Point3(0, 0, 1))), up = glm::cross(right, ahead);
  constexpr double half_view = 0.48;  // the tangent of half the field of view
  std::vector<Ray> rays;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double x = half_view * ((2 * column + 1.0) / side - 1), y = half_view * (1 - (2 * row + 1.0) / side);
      rays.push_back(through(eye, eye + ahead + x * right + y * up));
    }
  }
  return rays;
}

std::vector<Ray> random_rays(std::size_t n) {
  std::vector<Ray> rays;
  for (std::uint64_t k = 0; k < n; ++k) {
    Draw draw(ray_stream, 1, k);
    const Point3 from = uniform_point(draw, 2), to = uniform_point(draw, 1.45) * Point3(1, 1, 0.31);
    rays.push_back(through(from, to));
  }
  return rays;
}

}  // namespace tribunal::bench
