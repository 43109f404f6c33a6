// The chirotope of five points: all orientation signs of their affine hull, packed into one number.
#pragma once

#include <cstdint>

#include "core/coplanar.h"
#include "core/kernel.h"

namespace tribunal {

/// Signs of the five points a, b, c, p, q in the dimension that they span, read in lexicographic order of subsets:
/// rank 4: five tetrahedra; rank 3: ten triangles in a one-to-one projection; rank 2: ten pairs on the line;
/// rank 1: nothing. Affine maps preserve it up to a global sign, and two configurations with the same chirotope
/// have the same intersection: which points of which lie where is a function of it.
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

template <Kernel K>
ChirotopeCode tetrahedra(const Point3 (&v)[5], const K& k) {
  ChirotopeCode code;
  for (int left_out = 4; left_out >= 0; --left_out) {
    const Point3* s[4];
    for (int i = 0, n = 0; i < 5; ++i) {
      if (i != left_out) s[n++] = &v[i];
    }
    code.append(k.orient3d(*s[0], *s[1], *s[2], *s[3]));
  }
  return code;
}

template <Kernel K>
ChirotopeCode triangles(Axis dropped, const Point3 (&v)[5], const K& k) {
  ChirotopeCode code;
  for (int i = 0; i < 5; ++i) {
    for (int j = i + 1; j < 5; ++j) {
      for (int l = j + 1; l < 5; ++l) code.append(k.orient2d(dropped, v[i], v[j], v[l]));
    }
  }
  return code;
}

template <Kernel K>
ChirotopeCode pairs(const Point3 (&v)[5], const K& k) {
  ChirotopeCode code;
  for (int i = 0; i < 5; ++i) {
    for (int j = i + 1; j < 5; ++j) code.append(lexicographic(v[i], v[j], k));
  }
  return code;
}

/// Cost: 5 signs where the points span space, up to 45 where they do not.
template <Kernel K>
Chirotope chirotope(const Segment& s, const Triangle& t, const K& k) {
  const Point3 v[5] = {t.a, t.b, t.c, s.p, s.q};
  if (const ChirotopeCode code = tetrahedra(v, k); code.any()) return code.of_rank(4);
  for (const Axis dropped : all_axes) {
    if (const ChirotopeCode code = triangles(dropped, v, k); code.any()) return code.of_rank(3);
  }
  if (const ChirotopeCode code = pairs(v, k); code.any()) return code.of_rank(2);
  return {};
}

}  // namespace tribunal
