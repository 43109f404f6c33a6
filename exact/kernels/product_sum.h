// The exact sign of a sum of products of doubles, whatever their exponents, without numbers of any length.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/kernel.h"

namespace tribunal {

/// Up to 48 products of three doubles each: what det(u, v, w) comes to if each coordinate is a sum of two doubles.
class ProductSum {
 public:
  /// Adds x·y·z, or takes it away. All must be finite.
  void add(double x, double y, double z, bool negative);

  /// Of the sum, exactly. Sorts the products: ask once.
  ///
  /// Each product is an integer below 2¹⁵⁹ times a power of two, its unit. They are added up by descending units, in
  /// four machine words, which hold the sum so far in the unit of the next product. If that sum is 2¹⁶⁸ or more, all
  /// that is to come, less than 48·2¹⁵⁹ < 2¹⁶⁵, cannot change its sign: so it is the answer. If not, it fits the words
  /// with room for all that is to come.
  Sign sign();

 private:
  static constexpr std::size_t most = 48;

  struct Product {
    int unit;
    bool negative;
    std::array<std::uint64_t, 3> magnitude;  ///< lowest first
  };

  std::array<Product, most> products_;  // those from count_ on are never read
  std::size_t count_ = 0;
};

/// Signs by ProductSum, and by an error bound where it is certain. Exact for all finite binary64 coordinates, in
/// round-to-nearest with subnormal numbers, and never far from half a microsecond. The order of hits, of degree six, is
/// the reference kernel's.
struct ProductSumKernel {
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& x) const;
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const Direction& x) const;
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const Point3& x) const;
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const Direction& x) const;
  Sign compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const;

  /// By the bound, or the reference kernel's.
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const RayPoint& x) const;
  Sign orient2d(Axis dropped, const Point3& a, const Point3& b, const RayPoint& x) const;
  Sign compare(Axis axis, const Point3& a, const RayPoint& x) const;

  /// The sign of one rounded difference is exact.
  template <class X>
  Sign compare(Axis axis, const Point3& a, const X& x) const {
    return FormulaKernel<double>{}.compare(axis, a, x);
  }
};

static_assert(BoundsKernel<ProductSumKernel>);

}  // namespace tribunal
