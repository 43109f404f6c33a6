// The chirotope of a probe and a triangle: all orientation signs of their span, packed into one number.
#pragma once

#include <cstdint>
#include <type_traits>

#include "core/coplanar.h"
#include "core/kernel.h"

namespace tribunal {

/// Signs of the five points a, b, c, p, q in the dimension that they span, read in lexicographic order of subsets:
/// rank 4: five tetrahedra; rank 3: ten triangles in a one-to-one projection; rank 2: ten pairs on the line;
/// rank 1: nothing. Affine maps preserve it up to a global sign, and two configurations with the same chirotope
/// have the same intersection: which part of the probe meets which part of the triangle is a function of it.
///
/// Of a ray the fifth element is the direction d, a point at infinity: the five are the vectors (a,1), (b,1), (c,1),
/// (o,1), (d,0), and the signs are those of their determinants. The ray meets the triangle, or a face of it, iff there
/// are α, β, γ, t ≥ 0, zero outside that face, with α·(a,1) + β·(b,1) + γ·(c,1) = (o,1) + t·(d,0); the last row says
/// α + β + γ = 1. That asks for a linear dependency with given signs, and which signs dependencies have is a function
/// of the chirotope up to its global sign (Björner, Las Vergnas, Sturmfels, White & Ziegler, "Oriented Matroids", 1999,
/// §3.5). So it decides here too. d = 0 makes all signs vanish that d takes part in.
struct Chirotope {
  int rank = 1;
  std::uint16_t code = 0;  ///< the signs + 1 as base-3 digits, first sign most significant

  friend bool operator==(const Chirotope&, const Chirotope&) = default;
};

/// Appends signs to a code and remembers whether any was nonzero.
class ChirotopeCode {
 public:
  void append(Sign s) {
    code_ = static_cast<std::uint16_t>(3 * code_ + value(s) + 1);
    any_ |= s != Sign::zero;
  }
  bool any() const { return any_; }
  Chirotope of_rank(int rank) const { return {rank, code_}; }

 private:
  std::uint16_t code_ = 0;
  bool any_ = false;
};

/// Calls sign(i, j, …) for every subset of `count` of the five elements, and appends what it returns.
template <int count, class SignOf>
ChirotopeCode code_of(const SignOf& sign) {
  ChirotopeCode code;
  int subset[count];
  const auto extend = [&](const auto& self, int size, int next) -> void {
    if (size == count) {
      code.append(sign(subset));
      return;
    }
    for (int i = next; i < 5; ++i) {
      subset[size] = i;
      self(self, size + 1, i + 1);
    }
  };
  extend(extend, 0, 0);
  return code;
}

/// The five elements: a, b, c and the probe's source are points; its target is a point or a direction, and always comes
/// last in a subset.
template <class X>
struct FiveElements {
  const X* last;
  const Point3* points[4];

  /// Calls ask(x) with element i, which is a point or, for i = 4, the probe's target.
  template <class Ask>
  Sign with(int i, const Ask& ask) const {
    return i == 4 ? ask(*last) : ask(*points[i]);
  }
};

template <Kernel K, class X>
ChirotopeCode tetrahedra(const FiveElements<X>& v, const K& k) {
  return code_of<4>([&](const int(&s)[4]) {
    return v.with(s[3],
                  [&](const auto& x) { return k.orient3d(*v.points[s[0]], *v.points[s[1]], *v.points[s[2]], x); });
  });
}

template <Kernel K, class X>
ChirotopeCode triangles(Axis dropped, const FiveElements<X>& v, const K& k) {
  return code_of<3>([&](const int(&s)[3]) {
    return v.with(s[2], [&](const auto& x) { return k.orient2d(dropped, *v.points[s[0]], *v.points[s[1]], x); });
  });
}

template <Kernel K, class X>
ChirotopeCode pairs(const FiveElements<X>& v, const K& k) {
  return code_of<2>([&](const int(&s)[2]) {
    return v.with(s[1], [&](const auto& x) { return detail::lexicographic(*v.points[s[0]], x, k); });
  });
}

/// The chirotope of the five elements. Cost: 5 signs where they span space, up to 45 where they do not.
template <Kernel K, class P>
Chirotope chirotope(const P& probe, const Triangle& t, const K& k) {
  const auto& last = target(probe);
  const FiveElements<std::remove_cvref_t<decltype(last)>> v{&last, {&t.a, &t.b, &t.c, &source(probe)}};
  if (const ChirotopeCode code = tetrahedra(v, k); code.any()) return code.of_rank(4);
  for (const Axis dropped : all_axes) {
    if (const ChirotopeCode code = triangles(dropped, v, k); code.any()) return code.of_rank(3);
  }
  if (const ChirotopeCode code = pairs(v, k); code.any()) return code.of_rank(2);
  return {};
}

}  // namespace tribunal
