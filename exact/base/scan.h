// A scanner for lines of JSON as programs write them: it reads a part of JSON, quickly, and knows where it cannot.
//
// Whoever scans a line gives up at the first thing that is not plain, and has the line read by parse_json: it alone
// says what is legal, and what is wrong with what is not. So a scanner need not be complete, and has no messages; what
// it does read must be what parse_json reads. tests/exact/scan_test.cpp holds the two against each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/vec3.h"

namespace tribunal {

/// The number that a C99 hex float is, rounded correctly; infinite beyond the largest. False if the text is none. The
/// reading does not depend on the locale.
bool parse_hex_float(std::string_view text, double& x);

/// Reads one value after the other from a text. All functions but `peek` return false, and the place is then of no use,
/// where the next thing is not what they are named for, or is not plain.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

  /// The next character that is not white, or 0 at the end.
  char peek() {
    while (at_ < end_ && (*at_ == ' ' || *at_ == '\t' || *at_ == '\r')) ++at_;
    return at_ < end_ ? *at_ : '\0';
  }

  /// This character.
  bool take(char c) {
    if (peek() != c || at_ >= end_) return false;
    ++at_;
    return true;
  }

  bool at_end() { return peek() == '\0' && at_ >= end_; }

  /// A string of printable ASCII without escapes; views the scanned text.
  bool text(std::string_view& value) {
    if (!take('"')) return false;
    const char* const begin = at_;
    while (at_ < end_ && is_plain(*at_)) ++at_;
    value = {begin, static_cast<std::size_t>(at_ - begin)};
    return at_ < end_ && *at_++ == '"';
  }

  /// The digit 0 or 1, with nothing of a number behind it.
  bool bit(bool& value) {
    const char c = peek();
    if (c != '0' && c != '1') return false;
    value = c == '1';
    ++at_;
    return at_ == end_ || *at_ == ',' || *at_ == '}' || *at_ == ' ';
  }

  /// `true` or `false`.
  bool truth_value(bool& value) {
    value = peek() == 't';
    const std::string_view word = value ? "true" : "false";
    if (static_cast<std::size_t>(end_ - at_) < word.size() || std::string_view(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }

  /// A finite number as to_number reads it: a JSON number, or a hex float in a string.
  bool number(double& value) { return peek() == '"' ? hex_float(value) : decimal(value); }

  bool point(Point3& p) {
    return take('[') && number(p.x) && take(',') && number(p.y) && take(',') && number(p.z) && take(']');
  }

  /// An object with a member at least and none twice: key_named(name) is a bit of the member, or 0, and value(key)
  /// reads it. The bits of those that are there are added to `seen`.
  template <class KeyNamed, class Value>
  bool object(unsigned& seen, const KeyNamed& key_named, const Value& value) {
    if (!take('{')) return false;
    do {
      std::string_view name;
      if (!text(name) || !take(':')) return false;
      const unsigned key = key_named(name);
      if (key == 0 || (seen & key) != 0 || !value(key)) return false;
      seen |= key;
    } while (take(','));
    return take('}');
  }

  /// Where the next character stands, to come back to.
  const char* place() const { return at_; }
  void return_to(const char* place) { at_ = place; }

 private:
  static bool is_plain(char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; }
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  char here() const { return at_ < end_ ? *at_ : '\0'; }

  bool usual_hex_float(double& value);
  bool hex_float(double& value);
  bool decimal(double& value);

  const char* at_;
  const char* end_;
};

}  // namespace tribunal
