// The errors of numbers that methods give with a hit, in units in the last place of the exact value.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "core/format.h"
#include "core/method.h"
#include "exact/trial/truth.h"

namespace tribunal {

struct ExactRatio;
struct ExactHit;

/// Errors of one kind of number, counted. An error is |computed − exact| / ulp(exact). For an exact value x ≠ 0 of a
/// format with p bits and the least normal number 2^emin, ulp(x) = 2^(max(⌊log₂|x|⌋, emin) − p + 1): the distance of
/// its neighbours, and below 2^emin the least subnormal number. At x = 0 there is no such distance: such values are
/// counted by themselves, right if the method gives 0. Values beyond the largest number of the format are counted and
/// not measured. A number may be far off because the problem is ill-conditioned; that is not divided out.
struct Ulps {
  /// Of the errors greater than 0: up to ½, 1, 2, 4 … 2⁶⁴, and beyond.
  static constexpr std::size_t bins = 67;

  std::uint64_t equal = 0;                    ///< error 0
  std::array<std::uint64_t, bins> up_to{};    ///< (0, ½], (½, 1], (1, 2] …
  std::uint64_t zeros = 0, zeros_missed = 0;  ///< exact value 0, and of these given as something else
  std::uint64_t not_finite = 0;               ///< a NaN or an infinity
  std::uint64_t beyond = 0;                   ///< the exact value is beyond the format
  double most = 0;                            ///< the largest error, rounded towards 0
  std::uint64_t most_at = ~std::uint64_t{0};  ///< the lowest number of a case that has it; all ones if there is none

  /// A number of case k, for an exact value.
  void add(double computed, const ExactRatio& exact, Format format, std::uint64_t k);

  Ulps& operator+=(const Ulps& other);

  /// How many errors there are in `equal` and `up_to`.
  std::uint64_t measured() const;
  std::uint64_t all() const { return measured() + zeros + not_finite + beyond; }

  /// 0, or the least of ½, 1, 2 … that so many of a hundred errors do not exceed; infinity beyond 2⁶⁴.
  double bound_of(int percent) const;

  friend bool operator==(const Ulps&, const Ulps&) = default;
};

/// The errors of one method on one population.
struct HitErrors {
  std::uint64_t hits = 0;      ///< right hits of rays, each at one point, about which the method was asked
  std::uint64_t withheld = 0;  ///< of these, without a number
  Ulps t{};
  Ulps weights{};  ///< those of the vertices b and c: two numbers a hit

  HitErrors& operator+=(const HitErrors& other);
  friend bool operator==(const HitErrors&, const HitErrors&) = default;
};

/// Whether a case has numbers: a ray meets a triangle at one point, and crosses its plane there.
bool has_numbers(const Query& query, const Truth& truth);

/// Whether the method gives any.
inline bool gives_numbers(const Method& method) { return method.hit != nullptr || method.parameter != nullptr; }

/// What it gives; a fault counts as nothing.
std::optional<HitAt> numbers_of(const Method& method, const Query& query);

/// Adds what a method gave to case k.
void add_numbers(HitErrors& errors, const std::optional<HitAt>& given, const ExactHit& exact, Format format,
                 std::uint64_t k);

/// Of the cases of `fuzz` and of a certificate's sample one in so many is measured, by a hash of its number: exact
/// fractions take a microsecond.
inline constexpr std::uint64_t measured_period = 16;
bool is_measured(std::uint64_t seed, std::uint64_t stream, std::uint64_t k);

/// "half within 0.5, 99 % within 4, at most 37.2 ulps (case 123), of 4567; 3 of 5 zeros missed"; empty if there is
/// nothing.
std::string in_words(const Ulps& ulps);

}  // namespace tribunal
