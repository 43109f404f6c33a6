// Files of lines, read in blocks of whole lines: constant memory, whatever the file's length.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "exact/base/spool.h"

namespace tribunal {

/// The longest line that is read, in bytes.
inline constexpr std::size_t max_line = std::size_t{1} << 20;

/// A line of nothing but blanks, which is no line of JSON Lines.
inline bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

/// Consecutive lines of a file.
struct LineBlock {
  std::string text{};
  std::size_t first_line = 1;  ///< the number of its first line in the file, from 1
  std::size_t lines = 0;       ///< how many of its lines are not blank
  bool too_long = false;       ///< after these lines comes one of more than max_line bytes, of which nothing is read

  /// Calls visit(line, number) for each line that is not blank, in order. Fails with Exit::bad_input where one is too
  /// long.
  template <class Visit>
  void for_each(const std::string& path, const Visit& visit) const {
    std::size_t number = first_line;
    for (std::size_t begin = 0; begin < text.size(); ++number) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const std::string_view line = std::string_view(text).substr(begin, end - begin);
      begin = end + 1;
      if (is_blank(line)) continue;
      if (line.size() > max_line) fail_too_long(path, number);
      visit(line, number);
    }
    if (too_long) fail_too_long(path, number);
  }

  [[noreturn]] static void fail_too_long(const std::string& path, std::size_t number);
};

/// The lines of a text, from its start to its end.
class LineReader {
 public:
  /// Fills the buffer with what comes next and says how much that is: 0 at the end of the text. Fails with
  /// Exit::bad_input where it cannot be read.
  using Source = std::function<std::size_t(char* buffer, std::size_t size)>;

  explicit LineReader(Source source) : source_(std::move(source)) {}

  /// The next lines: up to `most_lines` that are not blank, and no more once they have `enough_bytes`. False where
  /// there are none left.
  bool next(LineBlock& block, std::size_t most_lines, std::size_t enough_bytes);

 private:
  enum class Line { whole, ended, too_long };
  Line find_end(std::size_t& length);
  bool fill();

  Source source_;
  std::string buffer_{};
  std::size_t begin_ = 0;        ///< the buffer was given out before this
  std::size_t line_ = 1;         ///< the number of the line at begin_
  bool blanks_dropped_ = false;  ///< of the line that is being read more than max_line bytes were blank, and are gone
  bool at_end_ = false;
};

/// The bytes of a file, or of standard input for "-". Fails with Exit::bad_input if it is missing, a directory or
/// unreadable.
LineReader::Source bytes_of(const std::string& path);

/// The bytes of a text, which must live as long as this is used.
LineReader::Source bytes_in(std::string_view text);

/// The same of a spool, which must not be written to meanwhile.
LineReader::Source bytes_in(const Spool& text);

/// Calls `visit` with each line, of any length and blank ones too, without its end. A text without a last line feed has
/// one all the same.
void for_each_line_of(const LineReader::Source& source, const std::function<void(std::string_view line)>& visit);

/// A file that is read more than once, from its start each time. What cannot be read twice, such as standard input or a
/// pipe, is copied into a spool first.
class Rereadable {
 public:
  explicit Rereadable(const std::string& path);

  const std::string& path() const { return path_; }

  /// Readers are independent of each other, and must not outlive this.
  LineReader reader() const { return LineReader(bytes()); }
  LineReader::Source bytes() const;

 private:
  std::string path_;
  std::optional<Spool> copy_{};
};

}  // namespace tribunal
