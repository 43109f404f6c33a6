// A user of the tree of triangles.
#include <iostream>
#include <vector>

#include "tracer/accel/triangle_tree.h"

int main() {
  using namespace tribunal;
  const TriangleTree tree(std::vector<Triangle>{{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, {{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}});
  const auto nearest = tree.closest(Ray{{1, 1, 3}, {{0, 0, -1}}});
  std::cout << nearest->id << " at " << nearest->t << "\n";
}
