// The symmetries of the cube.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/operands.h"

namespace tribunal {

/// One of the 48 signed axis permutations: exact on every coordinate, and it keeps the class.
struct AxisMap {
  std::array<int, 3> axis;
  int negatives;

  Point3 operator()(const Point3& p) const {
    Point3 r;
    for (int i = 0; i < 3; ++i) {
      const double x = p[axis[static_cast<std::size_t>(i)]];
      r[i] = (negatives >> i & 1) != 0 ? -x : x;
    }
    return r;
  }
  Segment operator()(const Segment& s) const { return {(*this)(s.p), (*this)(s.q)}; }
  Ray operator()(const Ray& r) const { return {(*this)(r.o), {(*this)(r.d.v)}}; }
  Triangle operator()(const Triangle& t) const { return {(*this)(t.a), (*this)(t.b), (*this)(t.c)}; }
};

/// All 48, permutations in lexicographic order, the identity first.
inline std::span<const AxisMap> axis_maps() {
  static const std::vector<AxisMap> maps = [] {
    std::vector<AxisMap> list;
    std::array<int, 3> axis{0, 1, 2};
    do {
      for (int negatives = 0; negatives < 8; ++negatives) list.push_back({axis, negatives});
    } while (std::next_permutation(axis.begin(), axis.end()));
    return list;
  }();
  return maps;
}

}  // namespace tribunal
