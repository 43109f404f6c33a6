#include "exact/mesh/text.h"

#include <algorithm>

#include "exact/base/shown.h"

namespace tribunal {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v'; }

const char* reason(NumberFault fault) {
  switch (fault) {
    case NumberFault::out_of_range:
      return " is out of range";
    case NumberFault::not_finite:
      return " is not finite";
    default:
      return " is not a decimal number";
  }
}

std::string describe(NumberFault fault, std::string_view token) {
  return fault == NumberFault::missing ? "the line ends" : in_quotes(token) + reason(fault);
}

}  // namespace

std::string in_quotes(std::string_view token) {
  return "\"" + shown(token.substr(0, 32)) + (token.size() > 32 ? "…\"" : "\"");
}

void require_text(const std::string& file, std::string_view bytes) {
  const std::size_t nul = bytes.find('\0');
  if (nul == bytes.npos) return;
  const auto lines = std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
  throw bad_input(file, static_cast<std::size_t>(lines) + 1, "has a NUL byte, expected text");
}

/// Opens the next line of the text, blank or not. A backslash at the end of a comment does not join the next line.
bool Text::open_line() {
  joined_ = false;
  at_ = end_ = std::min(next_, text_.size());
  if (next_ >= text_.size()) return false;
  start_ = next_;
  const std::size_t whole = std::min(text_.find('\n', start_), text_.size());
  next_ = whole + 1;
  ++line_;
  const std::string_view line = text_.substr(start_, whole - start_);
  const std::size_t comment = style_.comment == '\0' ? line.npos : line.find(style_.comment);
  end_ = start_ + std::min(comment, line.size());
  if (!style_.continued || comment != line.npos) return true;
  const std::size_t last = end_ - (end_ > start_ && text_[end_ - 1] == '\r');
  joined_ = last > start_ && text_[last - 1] == '\\';
  if (joined_) end_ = last - 1;
  return true;
}

bool Text::next_line() {
  while (joined_) open_line();
  while (open_line()) {
    if (has_token()) return true;
  }
  return false;
}

void Text::require_line(const char* expected) {
  if (!next_line()) throw early_end(expected);
}

bool Text::has_token() {
  do {
    while (at_ < end_ && is_blank(text_[at_])) ++at_;
    if (at_ < end_) return true;
  } while (joined_ && open_line());
  return false;
}

void Text::mark(std::size_t offset) {
  marked_line_ = line_;
  marked_column_ = offset - std::min(start_, offset) + 1;
}

std::string_view Text::token() {
  const bool found = has_token();
  mark(at_);
  if (!found) return {};
  const std::size_t first = at_;
  while (at_ < end_ && !is_blank(text_[at_])) ++at_;
  return text_.substr(first, at_ - first);
}

std::string_view Text::token_of_any_line(const char* expected) {
  if (!has_token()) require_line(expected);
  return token();
}

void Text::require_line_end(const char* expected) {
  if (!has_token()) return;
  const std::string_view extra = token();
  throw error(in_quotes(extra) + ", expected " + expected);
}

template <class Float>
Float Text::to_coordinate(std::string_view token) const {
  Float x = 0;
  const NumberFault fault = parse_number(token, x);
  if (fault != NumberFault::none) throw error(describe(fault, token) + ", expected a finite decimal coordinate");
  return x;
}

template float Text::to_coordinate(std::string_view) const;
template double Text::to_coordinate(std::string_view) const;

long long Text::to_integer(std::string_view token, const char* expected) const {
  long long n = 0;
  const NumberFault fault = parse_number(token, n);
  if (fault == NumberFault::malformed) throw error(in_quotes(token) + ", expected " + expected);
  if (fault != NumberFault::none) throw error(describe(fault, token) + ", expected " + expected);
  return n;
}

void Text::check_number(std::string_view token, const char* expected) const {
  double x = 0;
  const NumberFault fault = parse_number(token, x);
  const bool number = fault != NumberFault::missing && fault != NumberFault::malformed;
  if (!number) throw error(describe(fault, token) + ", expected " + expected);
}

Failure Text::error(const std::string& what) const {
  return bad_input(file_, marked_line_, what + ", at column " + std::to_string(marked_column_));
}

Failure Text::early_end(const std::string& expected) const {
  return bad_input(file_, line_, "file ends early, expected " + expected);
}

}  // namespace tribunal
