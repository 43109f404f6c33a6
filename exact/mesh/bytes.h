// Reads binary mesh formats number by number, and knows the place of each for error messages.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>

#include "exact/base/failure.h"

namespace tribunal {

/// Reads numbers of a given byte order. The file's name and its bytes must outlive it.
class Bytes {
 public:
  /// The bytes of the whole file, of which those from `at` on are read.
  Bytes(const std::string& file, std::string_view bytes, std::size_t at, std::endian order)
      : file_(file), bytes_(bytes), at_(at), swapped_(order != std::endian::native) {}

  std::size_t left() const { return bytes_.size() - at_; }

  /// The next number, or an error if the file ends before its end.
  template <class Number>
  Number next() {
    char raw[sizeof(Number)];
    require(sizeof raw);
    std::memcpy(raw, bytes_.data() + at_, sizeof raw);
    if (swapped_) std::reverse(raw, raw + sizeof raw);
    read(sizeof raw);
    Number x;
    std::memcpy(&x, raw, sizeof x);
    return x;
  }

  template <class Float>
  Float coordinate() {
    const Float x = next<Float>();
    if (!std::isfinite(x)) throw error("a coordinate is not finite");
    return x;
  }

  void skip(std::size_t n) {
    require(n);
    read(n);
  }

  /// An error at the number that was read last.
  Failure error(const std::string& what) const {
    return bad_input(file_, 0, "byte " + std::to_string(last_) + ": " + what);
  }

  /// An error at the next byte.
  Failure error_here(const std::string& what) const {
    return bad_input(file_, 0, "byte " + std::to_string(at_) + ": " + what);
  }

 private:
  void require(std::size_t n) const {
    if (left() < n) throw error_here("file ends early, expected " + std::to_string(n) + " more bytes");
  }

  void read(std::size_t n) {
    last_ = at_;
    at_ += n;
  }

  const std::string& file_;
  std::string_view bytes_;
  std::size_t at_;        ///< of the next number
  std::size_t last_ = 0;  ///< of the number that was read last
  bool swapped_;
};

}  // namespace tribunal
