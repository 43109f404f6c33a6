// A register of numbers as a number type, for tests that were published for vector registers: the same source runs on a
// number, on an exact number, and on four floats or two doubles at once.
//
// Comparisons give masks, which are combined by & and |, never by && and ||, and `select` stands for ?:. On a single
// number a mask is a bool. Each lane computes as a number alone does, so both forms answer alike, to the last bit.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "core/longest_axis.h"
#include "core/rivals/rival.h"

namespace tribunal::published {

template <class N>
class Lanes;

namespace lanes_detail {

/// Registers of 16 bytes, which every x86-64 has, and which the published forms used.
template <class N>
struct Registers;

template <>
struct Registers<float> {
  typedef float Numbers __attribute__((vector_size(16)));
  typedef std::int32_t Masks __attribute__((vector_size(16)));
};

template <>
struct Registers<double> {
  typedef double Numbers __attribute__((vector_size(16)));
  typedef std::int64_t Masks __attribute__((vector_size(16)));
};

}  // namespace lanes_detail

/// A truth value a lane.
template <class N>
class LaneMask {
 public:
  using Register = typename lanes_detail::Registers<N>::Masks;

  LaneMask() = default;
  explicit LaneMask(Register bits) : bits_(bits) {}

  bool operator[](std::size_t lane) const { return bits_[lane] != 0; }
  Register bits() const { return bits_; }

  friend LaneMask operator&(LaneMask a, LaneMask b) { return LaneMask(a.bits_ & b.bits_); }
  friend LaneMask operator|(LaneMask a, LaneMask b) { return LaneMask(a.bits_ | b.bits_); }
  friend LaneMask operator==(LaneMask a, LaneMask b) { return LaneMask(~(a.bits_ ^ b.bits_)); }

 private:
  Register bits_{};  ///< of a lane all or none
};

/// A number a lane.
template <class N>
class Lanes {
 public:
  using Mask = LaneMask<N>;
  using Register = typename lanes_detail::Registers<N>::Numbers;
  static constexpr std::size_t count = sizeof(Register) / sizeof(N);

  Lanes() = default;
  /// A number is a register that holds it in every lane.
  Lanes(N all) {
    for (std::size_t i = 0; i < count; ++i) set(i, all);
  }
  explicit Lanes(Register numbers) : numbers_(numbers) {}

  N operator[](std::size_t lane) const { return numbers_[lane]; }
  void set(std::size_t lane, N number) { numbers_[lane] = number; }

  friend Lanes operator-(Lanes a) { return Lanes(-a.numbers_); }
  friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.numbers_ + b.numbers_); }
  friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.numbers_ - b.numbers_); }
  friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.numbers_ * b.numbers_); }
  friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.numbers_ / b.numbers_); }
  friend Mask operator<(Lanes a, Lanes b) { return Mask(a.numbers_ < b.numbers_); }
  friend Mask operator<=(Lanes a, Lanes b) { return Mask(a.numbers_ <= b.numbers_); }
  friend Mask operator>=(Lanes a, Lanes b) { return Mask(a.numbers_ >= b.numbers_); }
  friend Mask operator==(Lanes a, Lanes b) { return Mask(a.numbers_ == b.numbers_); }
  friend Mask operator!=(Lanes a, Lanes b) { return Mask(a.numbers_ != b.numbers_); }

  friend Lanes select(Mask mask, Lanes yes, Lanes no) { return Lanes(mask.bits() ? yes.numbers_ : no.numbers_); }
  /// As `sign_bit` of a number: a NaN counts as positive.
  friend Mask sign_bit(Lanes a) { return Mask((typename Mask::Register(a.numbers_) < 0) & (a.numbers_ <= 0)); }
  friend Lanes absolute(Lanes a) { return select(a < 0, -a, a); }

 private:
  Register numbers_{};
};

/// An axis a lane; z where it is neither x nor y.
template <class N>
struct LaneAxis {
  LaneMask<N> x, y;
};

namespace lanes_detail {

template <class N>
struct Of {
  using Mask = bool;
  using Axis = tribunal::Axis;
};

template <class N>
struct Of<Lanes<N>> {
  using Mask = LaneMask<N>;
  using Axis = LaneAxis<N>;
};

}  // namespace lanes_detail

/// What a comparison of N gives, and which axis of a Vec3<N> is meant.
template <class N>
using MaskOf = typename lanes_detail::Of<N>::Mask;
template <class N>
using AxisOf = typename lanes_detail::Of<N>::Axis;

template <class N>
const N& select(bool mask, const N& yes, const N& no) {
  return mask ? yes : no;
}

inline bool none(bool mask) { return !mask; }

template <class N>
bool none(LaneMask<N> mask) {
  bool any = false;
  for (std::size_t i = 0; i < Lanes<N>::count; ++i) any |= mask[i];
  return !any;
}

template <class N>
LaneAxis<N> longest_axis(const Vec3<Lanes<N>>& v) {
  const Lanes<N> x = absolute(v.x), y = absolute(v.y), z = absolute(v.z);
  return {(x >= y) & (x >= z), y >= z};
}

template <class N>
Lanes<N> coordinate(const Vec3<Lanes<N>>& w, const LaneAxis<N>& axis) {
  return select(axis.x, w.x, select(axis.y, w.y, w.z));
}

template <class N>
Vec2<Lanes<N>> project(const Vec3<Lanes<N>>& w, const LaneAxis<N>& dropped) {
  return {select(dropped.x, w.y, select(dropped.y, w.z, w.x)), select(dropped.x, w.z, select(dropped.y, w.x, w.y))};
}

/// What a test that runs on lanes finds: where `hit`, the parameter and the weights of a hit; elsewhere they mean
/// nothing.
template <class N>
struct Found {
  MaskOf<N> hit{};
  N t{};
  Weights<N> weights{};
};

/// Whether `meet` gives a Found for all t.
template <template <class> class Rival, class N>
inline constexpr bool finds_on_lines = requires(Vec3<N> v, typename Rival<N>::Prepared t) {
  { Rival<N>::meet(v, v, t) } -> std::same_as<Found<N>>;
};

/// The same up to a largest t.
template <template <class> class Rival, class N>
inline constexpr bool finds_within = requires(Vec3<N> v, N t_max, typename Rival<N>::Prepared t) {
  { Rival<N>::meet(v, v, t_max, t) } -> std::same_as<Found<N>>;
};

/// Whether R was published for registers: its `meet` gives a Found.
template <class R>
inline constexpr bool runs_on_lanes = false;

template <template <class> class Rival, class N>
inline constexpr bool runs_on_lanes<Rival<N>> = finds_on_lines<Rival, N> || finds_within<Rival, N>;

}  // namespace tribunal::published
