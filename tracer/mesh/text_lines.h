// Reading text mesh formats token by token, with the line number at hand for the error.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "exact/io/failure.h"

namespace tribunal {

/// The whole text as one finite decimal number, or throws bad_input(file, line, …). Hex floats, NaN, infinities
/// and numbers beyond binary64 are refused: CGAL's readers take the first for 0 and pass the others on.
double parse_coordinate(std::string_view token, const std::string& file, std::size_t line);

/// The whole text as an integer, or throws bad_input naming what was expected.
long long parse_integer(std::string_view token, const std::string& file, std::size_t line, const char* expected);

/// For messages: the token, shortened, with control characters replaced.
std::string quoted(std::string_view token);

/// Walks over the lines of a text, skipping blank ones and what follows `comment`.
class TextLines {
 public:
  TextLines(std::string_view text, const std::string& file, char comment = '#')
      : text_(text), file_(file), comment_(comment) {}

  /// Moves to the next line that has tokens; false at the end of the text.
  bool next();
  /// The same, but the end of the text is an error that says what was expected.
  void require(const std::string& expected);

  const std::vector<std::string_view>& tokens() const { return tokens_; }
  std::string_view token(std::size_t i) const { return i < tokens_.size() ? tokens_[i] : std::string_view(); }
  std::size_t line() const { return line_; }
  std::size_t offset() const { return at_; }  ///< of the first byte after the current line
  const std::string& file() const { return file_; }

  double coordinate(std::size_t i) const { return parse_coordinate(token(i), file_, line_); }
  long long integer(std::size_t i, const char* expected) const {
    return parse_integer(token(i), file_, line_, expected);
  }
  Failure error(const std::string& what) const { return bad_input(file_, line_, what); }

 private:
  std::string_view text_;
  const std::string& file_;
  char comment_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;
  std::vector<std::string_view> tokens_;
};

}  // namespace tribunal
