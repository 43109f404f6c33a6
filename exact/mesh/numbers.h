// Decimal numbers in mesh files: the same in every locale, and correctly rounded.
#pragma once

#include <string_view>

namespace tribunal {

/// Why a token is no number, for error messages; `none` if it is one.
enum class NumberFault { none, missing, malformed, out_of_range, not_finite };

/// The nearest binary64 or binary32 number to a decimal numeral such as "-1.5e3", ties to even; a leading "+" is
/// allowed, and a numeral too small for the format is a zero of its sign. "nan" and "inf" are faults, as are
/// hexadecimal numerals.
template <class Float>
NumberFault parse_number(std::string_view token, Float& x);

/// The whole token as a decimal integer.
NumberFault parse_number(std::string_view token, long long& n);

}  // namespace tribunal
