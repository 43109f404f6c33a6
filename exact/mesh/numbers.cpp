#include "exact/mesh/numbers.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace tribunal {
namespace {

/// std::from_chars takes no "+"; "+-1" stays malformed.
std::string_view without_plus(std::string_view token) {
  const bool plus = token.size() > 1 && token[0] == '+' && token[1] != '-';
  return plus ? token.substr(1) : token;
}

template <class Number>
NumberFault parse_whole(std::string_view digits, Number& x) {
  if (digits.empty()) return NumberFault::missing;
  const char* const last = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), last, x);
  if (error == std::errc::invalid_argument || end != last) return NumberFault::malformed;
  return error == std::errc() ? NumberFault::none : NumberFault::out_of_range;
}

/// The exponent of a numeral that std::from_chars has read to its end, 0 if it has none. Beyond ±2^60 it is ±2^60; no
/// numeral has so many digits that this matters.
long long exponent_of(std::string_view numeral) {
  constexpr long long huge = 1LL << 60;
  const std::size_t e = numeral.find_first_of("eE");
  if (e == numeral.npos) return 0;
  const std::string_view digits = without_plus(numeral.substr(e + 1));
  long long exponent = 0;
  if (parse_whole(digits, exponent) != NumberFault::none) exponent = digits[0] == '-' ? -huge : huge;
  return std::clamp(exponent, -huge, huge);
}

/// Whether a numeral out of range is too small: its first digit that is not 0 stands for tenths or less. A numeral out
/// of range is beyond 1e38 or below 1e-37, so there is no doubtful case between.
bool is_tiny(std::string_view numeral) {
  const std::string_view mantissa = numeral.substr(0, numeral.find_first_of("eE"));
  const auto point = static_cast<long long>(std::min(mantissa.find('.'), mantissa.size()));
  const auto first = static_cast<long long>(mantissa.find_first_of("123456789"));
  return point - first + exponent_of(numeral) <= 0;
}

}  // namespace

template <class Float>
NumberFault parse_number(std::string_view token, Float& x) {
  const std::string_view numeral = without_plus(token);
  const NumberFault fault = parse_whole(numeral, x);
  if (fault == NumberFault::none) return std::isfinite(x) ? fault : NumberFault::not_finite;
  if (fault != NumberFault::out_of_range || !is_tiny(numeral)) return fault;
  x = numeral[0] == '-' ? -Float(0) : Float(0);
  return NumberFault::none;
}

template NumberFault parse_number(std::string_view, float&);
template NumberFault parse_number(std::string_view, double&);

NumberFault parse_number(std::string_view token, long long& n) { return parse_whole(without_plus(token), n); }

}  // namespace tribunal
