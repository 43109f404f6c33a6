// The two floating-point formats, and rounding to them so that the compiler cannot lose it.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/vec3.h"

namespace tribunal {

/// The coordinates a method computes with. A binary32 method is judged only on operands exact in binary32.
enum class Format : std::uint8_t { binary32, binary64 };

constexpr std::string_view name_of(Format f) { return f == Format::binary32 ? "binary32" : "binary64"; }

/// x rounded to the nearest binary32 number, as a double; infinite beyond its range.
/// The volatile is not for show: at -O2, g++ 12.2 merges two neighbouring conversions double → float → double into
/// vector conversions and then drops them as if they were the identity. A test asks for three at once.
inline double to_binary32(double x) {
  const volatile float rounded = static_cast<float>(x);
  return static_cast<double>(rounded);
}

inline double in_format(double x, Format format) { return format == Format::binary32 ? to_binary32(x) : x; }

inline Point3 in_format(const Point3& p, Format format) {
  return {in_format(p.x, format), in_format(p.y, format), in_format(p.z, format)};
}

inline bool is_exact_in(double x, Format format) { return in_format(x, format) == x; }

inline bool is_exact_in(const Point3& p, Format format) { return in_format(p, format) == p; }

}  // namespace tribunal
