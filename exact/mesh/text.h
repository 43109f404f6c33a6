// Reads text mesh formats line by line and token by token, and knows the place of each token for error messages.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "exact/base/failure.h"
#include "exact/mesh/numbers.h"

namespace tribunal {

/// For messages: the token in quotes, shortened, with escapes for what does not show.
std::string in_quotes(std::string_view token);

/// Fails with the line of the first NUL byte: text formats have none.
void require_text(const std::string& file, std::string_view bytes);

/// In what the text formats differ.
struct TextStyle {
  char comment = '#';      ///< this and the rest of the line are skipped; '\0' for a format without comments
  bool continued = false;  ///< a backslash at the very end of a line joins the next line to it
};

/// Walks over a text line by line, and over each line token by token. Blanks, tabs and carriage returns separate
/// tokens; lines without tokens are skipped, and so is a byte-order mark before the first. The file's name and the text
/// must outlive it.
class Text {
 public:
  Text(const std::string& file, std::string_view text, TextStyle style = {})
      : file_(file), text_(text), style_(style), next_(mark_at(text)) {}

  /// Moves to the next line that has tokens, whatever is left of the current one; false at the end of the text.
  bool next_line();
  /// The same, but the end of the text is an error that says what was expected.
  void require_line(const char* expected);

  /// Whether the line has another token.
  bool has_token();
  /// The next token of the line, empty at its end.
  std::string_view token();
  /// The next token of the text, on this line or a later one; an error at the end of the text.
  std::string_view token_of_any_line(const char* expected);
  /// An error if the line has another token.
  void require_line_end(const char* expected);

  /// The token, which must be the one read last, as a finite number or an integer; or an error at its place.
  template <class Float>
  Float to_coordinate(std::string_view token) const;
  long long to_integer(std::string_view token, const char* expected) const;
  /// An error unless the token read last is a number, which may overflow or be no finite one.
  void check_number(std::string_view token, const char* expected) const;

  double coordinate() { return to_coordinate<double>(token()); }
  long long integer(const char* expected) { return to_integer(token(), expected); }

  std::size_t line() const { return line_; }  ///< from 1: the current one
  std::size_t size() const { return text_.size(); }
  std::size_t offset() const { return std::min(next_, text_.size()); }  ///< of the first byte after the current line
  std::size_t left() const { return text_.size() - at_; }               ///< bytes after the token that was read last
  const std::string& file() const { return file_; }

  /// An error at the token that was read last, or at the end of the line if there was none.
  Failure error(const std::string& what) const;
  /// An error at the end of the text.
  Failure early_end(const std::string& expected) const;

 private:
  static std::size_t mark_at(std::string_view text) { return text.starts_with("\xEF\xBB\xBF") ? 3 : 0; }
  bool open_line();
  void mark(std::size_t offset);

  const std::string& file_;
  std::string_view text_;
  TextStyle style_;
  std::size_t start_ = 0, end_ = 0;  ///< the current line, without its comment or backslash
  std::size_t at_ = 0;               ///< how far it has been read
  std::size_t next_ = 0;             ///< where the next line starts
  bool joined_ = false;              ///< the next line belongs to this one
  std::size_t line_ = 0;
  std::size_t marked_line_ = 0, marked_column_ = 0;  ///< from 1, of the token that was read last
};

}  // namespace tribunal
