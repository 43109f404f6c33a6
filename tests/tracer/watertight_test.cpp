// Closed meshes, and rays aimed exactly at each vertex and edge midpoint: none may pass. The other methods' misses are
// printed as a table.
#include <cmath>
#include <cstdio>
#include <map>
#include <set>

#include "exact/mesh/read_mesh.h"
#include "exact/mesh/triangulate.h"
#include "tests/tracer/support.h"
#include "tracer/shading/visibility.h"

namespace tribunal {
namespace {

using testing::method;

const char* const closed_meshes[] = {"elephant", "knot1", "cow", "pinion", "sphere966", "hand", "3torus", "star"};

/// The mesh with its vertices rounded to a grid of 2²⁰ steps and moved by the offset: from an eye on the grid every
/// direction is exact.
Solid on_grid(const std::string& name, double offset) {
  const std::string path = "data/meshes/" + name + ".off";
  Solid solid{.name = name, .mesh = triangulated(read_mesh(path), path), .material = {}};
  double size = 0;
  for (const Point3& v : solid.mesh.vertices) size = std::max({size, std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  for (Point3& v : solid.mesh.vertices) {
    for (int i = 0; i < 3; ++i) v[i] = 2 * std::round(v[i] / size * 0x1p19) + offset;
  }
  return solid;
}

/// Whether every edge occurs equally often in either direction.
bool is_closed(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      a < b ? ++edges[{a, b}] : --edges[{b, a}];
    }
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second == 0; });
}

std::vector<Point3> targets_of(const Mesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::vector<Point3> targets;
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      if (edges.insert(std::minmax(t[i], t[(i + 1) % 3])).second) {
        const Point3 &a = mesh.vertices[t[i]], &b = mesh.vertices[t[(i + 1) % 3]];
        targets.push_back(a + 0.5 * (b - a));
      }
      targets.push_back(mesh.vertices[t[i]]);
    }
  }
  return targets;
}

struct Misses {
  std::uint64_t rays = 0, missed = 0;
};

Misses misses(const Method& m, double offset) {
  Misses count;
  for (const char* name : closed_meshes) {
    Scene scene;
    scene.solids = {on_grid(name, offset)};
    EXPECT_TRUE(is_closed(scene.solids[0].mesh)) << name;
    const World world = make_world(scene, m.contract.format, Accel::bvh);
    RayTally tally;
    Visibility eye(world, m, tally);
    const Point3 from = Point3(offset) + Point3(2621441, 1703937, 3145735);
    for (const Point3& target : targets_of(scene.solids[0].mesh)) {
      ++count.rays;
      count.missed +=
          !eye.first_hit({in_format(from, m.contract.format), {in_format(target - from, m.contract.format)}});
    }
  }
  return count;
}

TEST(Watertight, NoRayAimedAtAVertexOrAnEdgePasses) {
  std::printf("%-14s %10s %12s %12s\n", "method", "rays", "misses at 0", "at 2^40");
  std::uint64_t naive = 0;
  for (const char* name : {"sf-filtered", "sf-epick", "sf-double", "mt-double", "sf-float", "mt-float"}) {
    const Method& m = method(name);
    const bool wide = m.contract.format == Format::binary64;  // binary32 holds no such mesh at 2^40
    const Misses here = misses(m, 0), there = wide ? misses(m, 0x1p40) : Misses{};
    std::printf("%-14s %10llu %12llu %12s\n", name, static_cast<unsigned long long>(here.rays),
                static_cast<unsigned long long>(here.missed), wide ? std::to_string(there.missed).c_str() : "-");
    EXPECT_GT(here.rays, 100000u);
    const std::uint64_t missed = here.missed + there.missed;
    EXPECT_TRUE(!m.contract.exact || missed == 0) << name << " missed " << missed;
    if (!m.contract.exact) naive += missed;
  }
  EXPECT_GT(naive, 100u) << "the rays have no teeth";
}

}  // namespace
}  // namespace tribunal
