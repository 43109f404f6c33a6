#include "exact/base/scan.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <system_error>

namespace tribunal {
namespace {

constexpr std::uint64_t largest_whole = std::uint64_t{1} << 53;  // up to it all whole numbers are doubles
constexpr int largest_power = 22;                                // 10^22 = 2^22·5^22, and 5^22 < 2^53

constexpr std::array<double, largest_power + 1> powers_of_ten() {
  std::array<double, largest_power + 1> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = powers[i - 1] * 10;
  return powers;
}

constexpr auto powers = powers_of_ten();

/// The value of a hex digit, or 16.
constexpr std::array<unsigned char, 256> hex_values() {
  std::array<unsigned char, 256> values{};
  for (auto& v : values) v = 16;
  for (unsigned char i = 0; i < 10; ++i) values[static_cast<unsigned char>('0' + i)] = i;
  for (unsigned char i = 0; i < 6; ++i) {
    values[static_cast<unsigned char>('a' + i)] = values[static_cast<unsigned char>('A' + i)] =
        static_cast<unsigned char>(10 + i);
  }
  return values;
}

constexpr auto hex_value = hex_values();

}  // namespace

/// [-]0x1.hhh…p[+-]e" with up to 13 digits, of a normal number, is assembled from its bits; zero too.
bool Scanner::usual_hex_float(double& value) {
  const std::uint64_t sign = here() == '-' ? std::uint64_t{1} << 63 : 0;
  at_ += sign != 0;
  if (end_ - at_ < 4 || at_[0] != '0' || at_[1] != 'x' || (at_[2] != '0' && at_[2] != '1')) return false;
  const bool one = at_[2] == '1';
  at_ += 3;
  std::uint64_t digits = 0;
  int count = 0;
  if (*at_ == '.') {
    ++at_;
    for (unsigned v; (v = hex_value[static_cast<unsigned char>(here())]) < 16 && count < 13; ++at_, ++count) {
      digits = digits << 4 | v;
    }
    if (count == 0) return false;
  }
  if (here() != 'p') return false;
  ++at_;
  const bool negative = here() == '-';
  if (negative || here() == '+') ++at_;
  const char* const first = at_;
  int exponent = 0;
  for (; at_ - first < 4 && is_digit(here()); ++at_) exponent = 10 * exponent + (*at_ - '0');
  if (at_ == first || here() != '"') return false;
  ++at_;
  if (negative) exponent = -exponent;
  if (!one) {
    value = sign != 0 ? -0.0 : 0.0;
    return digits == 0;
  }
  const auto biased = static_cast<std::uint64_t>(exponent + 1023);
  value = std::bit_cast<double>(sign | biased << 52 | digits << (52 - 4 * count));
  return exponent >= -1022 && exponent <= 1023;
}

/// All strings that are not of the usual form go to the reader of hex floats.
bool Scanner::hex_float(double& value) {
  const char* const begin = ++at_;  // behind the quote
  if (usual_hex_float(value)) return true;
  for (at_ = begin; at_ < end_ && is_plain(*at_);) ++at_;
  const bool read = parse_hex_float({begin, static_cast<std::size_t>(at_ - begin)}, value) && std::isfinite(value);
  return read && at_ < end_ && *at_++ == '"';
}

/// A number by the grammar of JSON. m·10^e with m ≤ 2^53 and |e| ≤ 22 is one product or quotient of two doubles that
/// are exact, and so is rounded once, correctly (W. D. Clinger, "How to read floating point numbers accurately", 1990,
/// doi:10.1145/93542.93557); std::from_chars, which rounds correctly too, reads all others. What it finds out of range
/// is not for this scanner.
bool Scanner::decimal(double& value) {
  const char* const begin = at_;
  const bool negative = here() == '-';
  at_ += negative;
  std::uint64_t digits = 0;
  int count = 0, scale = 0;
  const auto take_digits = [&] {
    const char* const first = at_;
    for (; is_digit(here()); ++at_) {
      digits = 10 * digits + static_cast<std::uint64_t>(*at_ - '0');  // may overflow: then `count` is above 19
      count += count > 0 || *at_ != '0';
    }
    return static_cast<int>(at_ - first);
  };
  if (here() == '0') {
    ++at_;
  } else if (take_digits() == 0) {
    return false;
  }
  if (here() == '.') {
    ++at_;
    const int fraction = take_digits();
    if (fraction == 0) return false;
    scale = -fraction;
  }
  if (here() == 'e' || here() == 'E') {
    ++at_;
    const bool down = here() == '-';
    if (down || here() == '+') ++at_;
    if (!is_digit(here())) return false;
    int exponent = 0;
    for (; is_digit(here()); ++at_) exponent = exponent < 10'000 ? 10 * exponent + (*at_ - '0') : exponent;
    scale += down ? -exponent : exponent;
  }
  if (count <= 19 && digits <= largest_whole && scale >= -largest_power && scale <= largest_power) {
    const auto whole = static_cast<double>(digits);
    value =
        scale < 0 ? whole / powers[static_cast<std::size_t>(-scale)] : whole * powers[static_cast<std::size_t>(scale)];
    if (negative) value = -value;
    return true;
  }
  const auto [end, error] = std::from_chars(begin, at_, value);
  return error == std::errc{} && end == at_;
}

}  // namespace tribunal
