#include "tracer/accel/wide/tree.h"

namespace tribunal {

Triangle WideTree::triangle(Place p) const {
  const double* column = columns(p.leaf) + p.lane;
  const std::size_t step = p.leaf.count();
  const auto vertex = [&](std::size_t k) {
    return Point3(column[3 * k * step], column[(3 * k + 1) * step], column[(3 * k + 2) * step]);
  };
  return {vertex(0), vertex(1), vertex(2)};
}

std::size_t WideTree::bytes() const {
  return nodes_.capacity() * sizeof(WideNode) + columns_.capacity() * sizeof(double);
}

}  // namespace tribunal
