#include "tracer/leak/paint.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>

namespace tribunal::leak {
namespace {

constexpr FaceColour untouched{226, 226, 226};
constexpr FaceColour leak_ramp[] = {{255, 222, 173}, {236, 128, 44}, {112, 0, 16}};
constexpr FaceColour error_ramp[] = {{196, 218, 240}, {84, 142, 200}};

/// The ramp at 0 ≤ x ≤ 1: its colours stand at equal distances, and between them it is linear.
FaceColour at(std::span<const FaceColour> ramp, double x) {
  const double place = x * static_cast<double>(ramp.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), ramp.size() - 2);
  const double share = place - static_cast<double>(i);
  FaceColour colour{};
  for (std::size_t c = 0; c < colour.size(); ++c) {
    colour[c] = static_cast<std::uint8_t>(std::lround(ramp[i][c] + share * (ramp[i + 1][c] - ramp[i][c])));
  }
  return colour;
}

double root_share(std::uint64_t n, std::uint64_t most) {
  return std::sqrt(static_cast<double>(n) / static_cast<double>(most));
}

}  // namespace

FaceColour colour_of(std::uint64_t leaks, std::uint64_t most_leaks, std::uint64_t errors, std::uint64_t most_errors) {
  if (leaks > 0) return at(leak_ramp, root_share(leaks, most_leaks));
  if (errors > 0) return at(error_ramp, root_share(errors, most_errors));
  return untouched;
}

std::string painted(const Surface& surface, const SubjectReport& report) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(surface.vertices().size()) +
                     "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                     std::to_string(surface.face_count()) +
                     "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
                     "property uchar blue\nend_header\n";
  char line[200];
  for (const Point3& p : surface.vertices()) {
    std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", p.x, p.y, p.z);
    text += line;
  }
  const auto most_leaks = *std::ranges::max_element(report.leaks_at);
  const auto most_errors = *std::ranges::max_element(report.errors_at);
  for (std::uint32_t f = 0; f < surface.face_count(); ++f) {
    const auto& c = surface.corners(f);
    const auto [red, green, blue] = colour_of(report.leaks_at[f], most_leaks, report.errors_at[f], most_errors);
    std::snprintf(line, sizeof line, "3 %u %u %u %d %d %d\n", c[0], c[1], c[2], red, green, blue);
    text += line;
  }
  return text;
}

}  // namespace tribunal::leak
