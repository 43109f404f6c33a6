// The signs of the five volumes that decide about a probe and a triangle.
#pragma once

#include <array>

#include "core/kernel.h"
#include "core/query.h"

namespace tribunal {

/// Of a probe from p to q, a ray's q being its direction: abcp, abcq, pqab, pqbc, pqca.
template <Kernel K>
std::array<Sign, 5> five_signs(const Query& query, const K& k) {
  const Triangle& t = query.triangle();
  const auto signs = [&](const auto& probe) {
    const Point3& p = source(probe);
    const auto& q = target(probe);
    return std::array<Sign, 5>{k.orient3d(t.a, t.b, t.c, p), k.orient3d(t.a, t.b, t.c, q), k.orient3d(p, t.a, t.b, q),
                               k.orient3d(p, t.b, t.c, q), k.orient3d(p, t.c, t.a, q)};
  };
  return std::visit(signs, query.probe);
}

/// Their names in files, in that order.
inline constexpr std::array<const char*, 5> five_sign_names = {"abcp", "abcq", "pqab", "pqbc", "pqca"};

}  // namespace tribunal
