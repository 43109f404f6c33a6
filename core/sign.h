// The three-valued sign that every decision in this project is made from.
#pragma once

namespace tribunal {

/// Sign of a real number. `zero` means exactly zero; "cannot tell" is std::nullopt, never `zero`.
enum class Sign : signed char { negative = -1, zero = 0, positive = 1 };

constexpr int value(Sign s) { return static_cast<int>(s); }

constexpr Sign operator-(Sign s) { return static_cast<Sign>(-value(s)); }

constexpr Sign operator*(Sign a, Sign b) { return static_cast<Sign>(value(a) * value(b)); }

/// Sign of any ordered number type that can be compared with 0. A floating-point NaN compares false
/// with everything and so reads as `zero`: a naive kernel that overflows is wrong, not undefined.
template <class N>
constexpr Sign sign_of(const N& x) {
  return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero;
}

}  // namespace tribunal
