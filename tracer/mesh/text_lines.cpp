#include "tracer/mesh/text_lines.h"

#include <charconv>
#include <cmath>

namespace tribunal {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";

void split(std::string_view text, std::vector<std::string_view>& tokens) {
  tokens.clear();
  for (std::size_t i = text.find_first_not_of(blanks); i < text.size(); i = text.find_first_not_of(blanks, i)) {
    const std::size_t end = std::min(text.find_first_of(blanks, i), text.size());
    tokens.push_back(text.substr(i, end - i));
    i = end;
  }
}

std::string_view without_plus(std::string_view token) {
  const bool plus = token.size() > 1 && token[0] == '+' && token[1] != '-';
  return plus ? token.substr(1) : token;
}

}  // namespace

std::string quoted(std::string_view token) {
  std::string text(token.substr(0, 32));
  for (char& c : text) c = static_cast<unsigned char>(c) < 32 || c == 127 ? '?' : c;
  return "\"" + text + (token.size() > 32 ? "…\"" : "\"");
}

double parse_coordinate(std::string_view token, const std::string& file, std::size_t line) {
  if (token.empty()) throw bad_input(file, line, "too few numbers, expected three coordinates");
  const std::string_view digits = without_plus(token);
  double x = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), x);
  if (error == std::errc::result_out_of_range) {
    throw bad_input(file, line, "number " + quoted(token) + " is out of range, expected a finite binary64 number");
  }
  if (error != std::errc() || end != digits.data() + digits.size()) {
    throw bad_input(file, line, quoted(token) + " is not a decimal number, expected a coordinate");
  }
  if (!std::isfinite(x)) throw bad_input(file, line, quoted(token) + " is not finite, expected a finite coordinate");
  return x;
}

long long parse_integer(std::string_view token, const std::string& file, std::size_t line, const char* expected) {
  const std::string_view digits = without_plus(token);
  long long n = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), n);
  if (token.empty() || error != std::errc() || end != digits.data() + digits.size()) {
    throw bad_input(file, line, (token.empty() ? "line ends" : quoted(token)) + ", expected " + expected);
  }
  return n;
}

bool TextLines::next() {
  while (at_ < text_.size()) {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::string_view whole = text_.substr(at_, end - at_);
    at_ = end + 1;
    ++line_;
    split(whole.substr(0, whole.find(comment_)), tokens_);
    if (!tokens_.empty()) return true;
  }
  tokens_.clear();
  return false;
}

void TextLines::require(const std::string& expected) {
  if (!next()) throw bad_input(file_, line_, "file ends early, expected " + expected);
}

}  // namespace tribunal
