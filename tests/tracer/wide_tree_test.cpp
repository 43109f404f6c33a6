// The tree of eight boxes a node: its size and what it is made of.
#include <tbb/global_control.h>

#include <cmath>
#include <cstring>

#include "tests/tracer/box_support.h"
#include "tests/tracer/tree_support.h"

namespace tribunal {
namespace {

using testing::box_between;
using testing::offered;
using testing::tree_over;

/// A bumpy sphere of 2·n² triangles or so.
Mesh bumpy_sphere(std::uint32_t n) {
  Mesh mesh;
  for (std::uint32_t j = 0; j <= n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const double polar = 3.14 * (j + 0.5) / (n + 1), turn = 6.28 * i / n;
      const double r = 1 + 0.1 * std::sin(9 * turn) * std::sin(7 * polar);
      mesh.vertices.push_back(
          r * Point3(std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn), std::cos(polar)));
    }
  }
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * n + i, b = j * n + (i + 1) % n;
      mesh.triangles.push_back({a, b, a + n});
      mesh.triangles.push_back({b, b + n, a + n});
    }
  }
  return mesh;
}

std::vector<Triangle> triangles_of(const Mesh& mesh) {
  std::vector<Triangle> list;
  for (const auto& t : mesh.triangles) list.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  return list;
}

TEST(WideTree, DoesNotDependOnTheNumberOfThreads) {
  const std::vector<Triangle> triangles = triangles_of(bumpy_sphere(200));
  const auto build = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return WideTree(static_cast<std::uint32_t>(triangles.size()), [&](std::uint32_t i) {
      return Primitive{box_of(triangles[i]), triangles[i]};
    });
  };
  const auto ids = [](const WideTree& tree) {
    std::vector<std::uint32_t> list;
    tree.for_each_place([&](Place p) { list.push_back(tree.id(p)); });
    return list;
  };
  const WideTree one = build(1);
  for (const std::size_t threads : {2u, 3u, 7u}) {
    const WideTree other = build(threads);
    ASSERT_EQ(one.node_count(), other.node_count());
    EXPECT_EQ(std::memcmp(one.nodes(), other.nodes(), one.node_count() * sizeof(WideNode)), 0);
    EXPECT_EQ(ids(one), ids(other));
  }
  EXPECT_EQ(ids(one).size(), triangles.size());
}

TEST(WideTree, KeepsTrianglesBitForBit) {
  const std::vector<Triangle> triangles = triangles_of(bumpy_sphere(20));
  const WideTree tree(static_cast<std::uint32_t>(triangles.size()), [&](std::uint32_t i) {
    return Primitive{box_of(triangles[i]), triangles[i]};
  });
  tree.for_each_place([&](Place p) {
    const Triangle kept = tree.triangle(p);
    EXPECT_EQ(std::memcmp(&kept, &triangles[tree.id(p)], sizeof kept), 0);
  });
}

/// The whole world: tree, triangles, ids, solids, and the scene's mesh that it was made of.
TEST(WideTree, TakesAtMost160BytesATriangle) {
  Scene scene;
  scene.solids.push_back({"", bumpy_sphere(224), {}});
  const World world = make_world(scene, Format::binary64, Accel::bvh);
  const Mesh& mesh = scene.solids[0].mesh;
  const double count = static_cast<double>(mesh.triangles.size());
  const std::size_t bytes = world.triangles.bytes() + world.solid_of.capacity() * sizeof world.solid_of[0] +
                            world.polygon_of.capacity() * sizeof world.polygon_of[0] +
                            mesh.vertices.size() * sizeof(Point3) + mesh.triangles.size() * sizeof mesh.triangles[0];
  RecordProperty("bytes_per_triangle", std::to_string(static_cast<double>(bytes) / count));
  EXPECT_GT(count, 100000);
  EXPECT_LE(static_cast<double>(bytes) / count, 160);
  EXPECT_LE(static_cast<double>(TriangleTree(triangles_of(mesh)).bytes()) / count, 100);
}

/// A mesh about its own middle has planes at 0, whose outward neighbours are subnormal: those cost half of the speed.
TEST(WideTree, HasNoSubnormalPlanes) {
  const WideTree tree = tree_over({box_between(Point3(-1), Point3(0)), box_between(Point3(0), Point3(1)),
                                   box_between(Point3(-1, 0, -0.0), Point3(0, 1, 0x1p-1074)),
                                   box_between(Point3(-0x1p-1060), Point3(0)), box_between(Point3(0), Point3(0, 1, 1)),
                                   box_between(Point3(0), Point3(0)), box_between(Point3(0, 0, -1), Point3(1, 0, 0)),
                                   box_between(Point3(0), Point3(0x1p-1022)), box_between(Point3(0), Point3(1, 0, 1))});
  ASSERT_GT(tree.node_count(), 0u);
  for (std::size_t node = 0; node < tree.node_count(); ++node) {
    for (const auto& planes : tree.nodes()[node].plane) {
      for (const float x : planes) EXPECT_TRUE(x == 0 || std::fabs(x) >= 0x1p-100F) << x;
    }
  }
}

/// Equal boxes cannot be separated by cost; all primitives are found nevertheless.
TEST(WideTree, HandlesEqualBoxes) {
  const std::vector<Box> boxes(5000, box_between(Point3(0), Point3(1)));
  const WideTree tree = tree_over(boxes);
  const WideProbe probe(Ray{{0.5, 0.5, -1}, {{0, 0, 1}}}, tree.frame());
  EXPECT_EQ(offered(tree, probe, WideProbe::far_away).size(), boxes.size());
}

/// The greatest size of the traversal stack below a node or leaf, for a walk that meets every box; the popped node is
/// not counted.
std::size_t waiting_below(const WideTree& tree, NodeRef at) {
  if (at.is_leaf()) return 0;
  const WideNode& node = tree.nodes()[at.index()];
  std::size_t children = 0, deepest = 0;
  for (; children < node_width && !node.is_empty(children); ++children) {
    deepest = std::max(deepest, waiting_below(tree, node.child[children]));
  }
  return std::max(children, children - 1 + deepest);
}

/// Boxes whose sizes halve towards a corner, `copies` of each: the cheapest cut takes off the largest ones, again and
/// again, so that trees are as deep as the range of binary32 makes them.
std::vector<Box> halving_boxes(int sizes, int copies, const Point3& stretch) {
  std::vector<Box> boxes;
  for (int i = 0; i < sizes; ++i) {
    for (int k = 0; k < copies; ++k) {
      const double size = std::ldexp(1.0, -i);
      boxes.push_back(box_between(Point3(size), size * (Point3(1) + stretch)));
    }
  }
  return boxes;
}

/// Traversal stacks have room for all waiting nodes of any tree; tried on the deepest trees.
TEST(WideTree, NoMoreNodesWaitThanStacksHaveRoomFor) {
  std::size_t most = 0;
  for (const int sizes : {1, 30, 60, 120}) {
    for (const int copies : {1, 9, 200, 5000}) {
      for (const Point3& stretch : {Point3(0.5), Point3(1, 0, 0)}) {
        const WideTree tree = tree_over(halving_boxes(sizes, copies, stretch));
        const std::size_t waiting = waiting_below(tree, tree.root());
        EXPECT_LE(waiting, most_waiting) << sizes << " sizes, " << copies << " boxes of each";
        most = std::max(most, waiting);
      }
    }
  }
  EXPECT_GT(most, 100U) << "no deep tree was built";
  RecordProperty("most_waiting", static_cast<int>(most));
}

}  // namespace
}  // namespace tribunal
