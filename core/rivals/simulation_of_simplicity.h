// Five orientations, each of points that are moved infinitely little, so that none of them is zero: a probe through
// an edge or a vertex hits exactly one of the faces around it.
// Source: Edelsbrunner & Mücke, "Simulation of Simplicity: A Technique to Cope with Degenerate Cases in Geometric
// Algorithms", ACM Transactions on Graphics 9(1), 1990, doi:10.1145/77635.77639: coordinate j of point i is moved by
// ε to the power 2^(3i − j), and the first coefficient of the determinant that is not zero has its sign.
#pragma once

#include <algorithm>
#include <array>

#include "core/rivals/order.h"
#include "core/rivals/rival.h"
#include "core/sign.h"

namespace tribunal::published {

namespace simplicity {

/// A row of the determinant: a point (w = 1) or a direction (w = 0).
template <class N>
struct Row {
  Vec3<N> v;
  int w;
  int rank;  ///< its place in the order of perturbations; the first is moved farthest
};

template <class N>
using Rows = std::array<Row<N>, 4>;

template <class N>
N minor(const Row<N>& f, const Row<N>& g) {
  return f.v.x * g.v.y - f.v.y * g.v.x;
}

template <class N>
N depth(const Row<N>& f, const Row<N>& g) {
  return f.v.z * N(g.w) - g.v.z * N(f.w);
}

/// The determinant of the rows (x, y, z, w), by the first two columns and the last two.
template <class N>
N determinant(const Rows<N>& r) {
  return minor(r[0], r[1]) * depth(r[2], r[3]) - minor(r[0], r[2]) * depth(r[1], r[3]) +
         minor(r[0], r[3]) * depth(r[1], r[2]) + minor(r[1], r[2]) * depth(r[0], r[3]) -
         minor(r[1], r[3]) * depth(r[0], r[2]) + minor(r[2], r[3]) * depth(r[0], r[1]);
}

/// Whether a set of perturbations occurs as a product in the determinant. Bit 3·i + 2 − j stands for that of coordinate
/// j of row i; the determinant's products have at most one factor of each row and of each coordinate.
constexpr bool is_product(int bits) {
  int points = 0, axes = 0;
  for (int bit = 0; bit < 12; ++bit) {
    if ((bits >> bit & 1) == 0) continue;
    const int point = 1 << bit / 3, axis = 1 << bit % 3;
    if ((points & point) != 0 || (axes & axis) != 0) return false;
    points |= point;
    axes |= axis;
  }
  return true;
}

/// All such products of one, two or three factors (12 + 36 + 24), in ascending order of their powers of ε.
constexpr std::array<int, 72> all_products() {
  std::array<int, 72> products{};
  std::size_t n = 0;
  for (int bits = 1; bits < 1 << 12; ++bits) {
    if (is_product(bits)) products[n++] = bits;
  }
  return products;
}

inline constexpr std::array<int, 72> products = all_products();

/// The rows with those that `bits` names replaced by unit vectors: their determinant is the coefficient of the product.
template <class N>
Rows<N> with_units(Rows<N> r, int bits) {
  for (int bit = 0; bit < 12; ++bit) {
    if ((bits >> bit & 1) == 0) continue;
    const int axis = 2 - bit % 3;
    r[bit / 3].v = {N(axis == 0), N(axis == 1), N(axis == 2)};
    r[bit / 3].w = 0;
  }
  return r;
}

/// Sorts by rank and says whether that took an odd number of swaps.
template <class N>
bool sort_by_rank(Rows<N>& r) {
  bool odd = false;
  for (std::size_t i = 1; i < r.size(); ++i) {
    for (std::size_t k = i; k > 0 && r[k].rank < r[k - 1].rank; --k, odd = !odd) std::swap(r[k], r[k - 1]);
  }
  return odd;
}

/// The determinant of the rows without perturbation, by differences to the first row, which must be a point.
template <class N>
N unperturbed(const Rows<N>& r) {
  const auto from_first = [&](const Row<N>& row) { return row.w == 1 ? row.v - r[0].v : row.v; };
  return -dot(from_first(r[1]), cross(from_first(r[2]), from_first(r[3])));
}

/// The sign of the determinant of four perturbed rows: never zero in exact arithmetic.
template <class N>
Sign orientation(Rows<N> r) {
  const bool odd = sort_by_rank(r);
  Sign sign = sign_of(unperturbed(r));
  for (std::size_t i = 0; sign == Sign::zero && i < products.size(); ++i) {
    sign = sign_of(determinant(with_units(r, products[i])));
  }
  return odd ? -sign : sign;
}

}  // namespace simplicity

template <class N>
struct SimulationOfSimplicity {
  using Number = N;
  using Prepared = Corners<N>;
  static constexpr RivalCard card{"five orientations of perturbed points: none is zero", "Edelsbrunner & Mücke 1990"};
  /// Proper operands only: the perturbation gives a ray without direction one, and the ray might hit what is far away.
  static constexpr Contract contract{.triangles = Triangles::proper,
                                     .convention = Convention::unspecified,
                                     .boundary = Boundary::half_open,
                                     .ends = Ends::unspecified};

  static std::optional<RivalHit<N>> meet_segment(const Vec3<N>& p, const Vec3<N>& q, const Prepared& t) {
    return meet_rows({p, 1, 3}, {q, 1, 4}, q - p, t);
  }

  static std::optional<RivalHit<N>> meet(const Vec3<N>& o, const Vec3<N>& d, const N&, const Prepared& t) {
    return meet_rows({o, 1, 3}, {d, 0, 4}, d, t);
  }

 private:
  using Row = simplicity::Row<N>;

  /// Vertices rank by their coordinates, before the ends of the probe: so neighbours agree on those that they share.
  static std::array<Row, 3> ranked(const Corners<N>& t) {
    const int b_first = precedes(t.b, t.a), c_first = precedes(t.c, t.a), c_before_b = precedes(t.c, t.b);
    return {Row{t.a, 1, b_first + c_first}, Row{t.b, 1, 1 - b_first + c_before_b},
            Row{t.c, 1, 2 - c_first - c_before_b}};
  }

  static std::optional<RivalHit<N>> meet_rows(const Row& p, const Row& q, const Vec3<N>& d, const Corners<N>& t) {
    using simplicity::orientation;
    const auto [a, b, c] = ranked(t);
    const Sign source = orientation<N>({a, b, c, p});
    if (source == orientation<N>({a, b, c, q})) return std::nullopt;
    if (orientation<N>({p, q, a, b}) == source || orientation<N>({p, q, b, c}) == source ||
        orientation<N>({p, q, c, a}) == source) {
      return std::nullopt;
    }
    const Vec3<N> normal = plane_of(t).normal;
    return RivalHit<N>{dot(normal, t.a - p.v) / dot(normal, d)};
  }
};

}  // namespace tribunal::published
