// Reads the data of a PLY file number by number. Text and binary differ only here.
#pragma once

#include <cstdint>
#include <string>

#include "exact/mesh/bytes.h"
#include "exact/mesh/ply_header.h"
#include "exact/mesh/text.h"

namespace tribunal {

/// Numbers separated by blanks or line ends.
class PlyText {
 public:
  /// Continues after the header, which has been read from `in`.
  explicit PlyText(Text& in) : in_(in) {}

  /// A property of type float has the binary32 number nearest to the numeral, so that the file means what its binary
  /// form would.
  double coordinate(const PlyType& type) {
    if (!type.floating) return static_cast<double>(integer(type));
    const std::string_view token = next();
    return type.bytes == 4 ? in_.to_coordinate<float>(token) : in_.to_coordinate<double>(token);
  }

  long long integer(const PlyType& type) {
    const std::string_view token = next();
    const long long n = in_.to_integer(token, "an integer");
    if (!type.holds(n)) throw in_.error(in_quotes(token) + " is out of range of its property's type");
    return n;
  }

  void skip(const PlyType&, std::size_t n = 1) {
    for (std::size_t i = 0; i < n; ++i) in_.check_number(next(), "a number");
  }

  /// How many numbers there can be in the rest of the file.
  std::size_t room(const PlyType&) const { return (in_.left() + 1) / 2; }

  /// An error if anything is left.
  void finish() {
    if (in_.has_token() || in_.next_line()) in_.require_line_end("the end of the file after the last element");
  }

  Failure error(const std::string& what) const { return in_.error(what); }

 private:
  std::string_view next() { return in_.token_of_any_line("another number"); }

  Text& in_;
};

/// Numbers as their bytes.
class PlyBytes {
 public:
  explicit PlyBytes(const Bytes& in) : in_(in) {}

  double coordinate(const PlyType& type) {
    if (!type.floating) return static_cast<double>(integer(type));
    return type.bytes == 4 ? in_.coordinate<float>() : in_.coordinate<double>();
  }

  long long integer(const PlyType& type) {
    switch (type.bytes) {
      case 1:
        return type.is_signed ? in_.next<std::int8_t>() : in_.next<std::uint8_t>();
      case 2:
        return type.is_signed ? in_.next<std::int16_t>() : in_.next<std::uint16_t>();
      default:
        return type.is_signed ? in_.next<std::int32_t>() : static_cast<long long>(in_.next<std::uint32_t>());
    }
  }

  /// Skips n numbers, of which there must be no more than room(type).
  void skip(const PlyType& type, std::size_t n = 1) { in_.skip(n * type.bytes); }

  std::size_t room(const PlyType& type) const { return in_.left() / type.bytes; }

  void finish() {
    if (in_.left() > 0) throw in_.error_here("trailing data, expected the end of the file after the last element");
  }

  Failure error(const std::string& what) const { return in_.error(what); }

 private:
  Bytes in_;
};

}  // namespace tribunal
