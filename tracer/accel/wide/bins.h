// Where to cut a set of boxes in two: the surface area heuristic over bins.
// Source: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies", RT 2007.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>

namespace tribunal {

/// Three binary32 numbers and a fourth that nobody looks at, in one register.
using Float4 = float __attribute__((vector_size(16)));

inline Float4 least(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 greatest(Float4 a, Float4 b) { return a > b ? a : b; }

/// A box in the frame of a tree; empty until something is added.
struct FrameBox {
  static constexpr float infinity = std::numeric_limits<float>::infinity();
  Float4 lo{infinity, infinity, infinity, infinity};
  Float4 hi{-infinity, -infinity, -infinity, -infinity};

  void add(const FrameBox& b) {
    lo = least(lo, b.lo);
    hi = greatest(hi, b.hi);
  }
  void add(Float4 p) {
    lo = least(lo, p);
    hi = greatest(hi, p);
  }

  /// Half of the surface; 0 if empty.
  float area() const {
    const Float4 d = hi - lo;
    return d[0] >= 0 ? d[0] * d[1] + d[1] * d[2] + d[2] * d[0] : 0;
  }
};

/// A primitive while the tree is built.
struct BuildRef {
  FrameBox box;
  std::uint32_t id;
  bool is_triangle;

  /// Twice the centre of its box.
  Float4 centre() const { return box.lo + box.hi; }
};

/// The bounding box of a set of primitives, and that of their centres, times two.
struct BinExtent {
  FrameBox box, centres;

  void add(const BuildRef& r) {
    box.add(r.box);
    centres.add(r.centre());
  }
  void add(const BinExtent& e) {
    box.add(e.box);
    centres.add(e.centres);
  }
};

/// A plane between two bins; those whose bin is below `bin` go left.
struct Cut {
  int axis = -1;  ///< −1: all centres are equal
  int bin = 0;
};

inline constexpr int bin_count = 16;

/// Sorts centres into bins on each axis.
class Binning {
 public:
  explicit Binning(const FrameBox& centres) : origin_(centres.lo) {
    const Float4 size = centres.hi - centres.lo;
    for (int i = 0; i < 3; ++i) scale_[i] = size[i] > 0x1p-100F ? bin_count * (1 - 0x1p-20F) / size[i] : 0;
  }

  bool splits(int axis) const { return scale_[axis] > 0; }

  /// The bin of a primitive on this axis: never negative, and below bin_count, since rounding cannot lift the product
  /// to it.
  int bin(const BuildRef& r, int axis) const {
    return static_cast<int>((r.centre()[axis] - origin_[axis]) * scale_[axis]);
  }

 private:
  Float4 origin_, scale_{};
};

/// For each bin of each axis: the bounding box and the number of its primitives.
struct Bins {
  std::array<std::array<FrameBox, bin_count>, 3> box;
  std::array<std::array<std::uint32_t, bin_count>, 3> count{};

  void add(std::span<const BuildRef> refs, const Binning& binning);
  void add(const Bins& other);

  /// The cheapest cut; among equal costs, that of the lowest axis and bin. The cost is the sum over both sides of the
  /// area of the box times the number of leaves that its primitives fill.
  Cut best(const Binning& binning) const;
};

}  // namespace tribunal
