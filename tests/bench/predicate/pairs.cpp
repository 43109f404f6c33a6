#include "tests/bench/predicate/pairs.h"

#include <utility>

namespace tribunal::bench {

PairTable::PairTable(std::vector<SegmentPair> pairs) : pairs_(std::move(pairs)) {
  for (const SegmentPair& p : pairs_) {
    std::size_t c = 0;
    for (const Point3& v : {p.segment.p, p.segment.q, p.triangle.a, p.triangle.b, p.triangle.c}) {
      for (int axis = 0; axis < 3; ++axis) columns_[c++].push_back(v[axis]);
    }
  }
}

std::array<const double*, 15> PairTable::columns() const {
  std::array<const double*, 15> pointers;
  for (std::size_t c = 0; c < pointers.size(); ++c) pointers[c] = columns_[c].data();
  return pointers;
}

}  // namespace tribunal::bench
