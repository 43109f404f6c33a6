#include "exact/base/json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "exact/base/failure.h"
#include "exact/base/foreign_json.h"
#include "exact/base/scan.h"
#include "exact/base/shown.h"
#include "exact/base/suggestion.h"

namespace tribunal {
namespace {

constexpr int max_depth = 64;

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Beyond any power of ten that matters.
constexpr long max_power = 1'000'000'000'000;

/// Nesting depth outside strings, so that a depth bomb is refused before the parser allocates for it.
int depth_of(std::string_view text) {
  int depth = 0, deepest = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      if (c == '"') in_string = false;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      deepest = std::max(deepest, ++depth);
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return deepest;
}

/// What becomes of a number like 1e999, beyond binary64: the text is refused, or the number is infinite.
enum class Beyond { refused, infinite };

// --- what the parser would misread --------------------------------------------------------------------------------

/// How numbers are written.
struct Notation {
  const char* digits;  ///< without 0
  const char* marks;   ///< what an exponent begins with
  long powers;         ///< a digit further to the left is worth so many powers of the exponent's base
};
constexpr Notation decimal = {"123456789", "eE", 1};
constexpr Notation hexadecimal = {"123456789abcdefABCDEF", "pP", 4};

/// The power of the exponent's base of the first digit that is not 0, of a number other than 0 without a sign.
long magnitude(std::string_view number, const Notation& notation) {
  const std::size_t e = std::min(number.find_first_of(notation.marks), number.size());
  const std::string_view digits = number.substr(0, e);
  const auto point = static_cast<long>(std::min(digits.find('.'), digits.size()));
  const auto first = static_cast<long>(digits.find_first_of(notation.digits));
  long exponent = 0;
  if (e < number.size()) {
    std::string_view power = number.substr(e + 1);
    if (power.starts_with('+')) power.remove_prefix(1);
    const auto [end, error] = std::from_chars(power.data(), power.data() + power.size(), exponent);
    if (error == std::errc::result_out_of_range) exponent = power.starts_with('-') ? -max_power : max_power;
  }
  const long places = first < point ? point - first - 1 : point - first;
  return std::clamp(exponent, -max_power, max_power) + notation.powers * places;
}

/// Whether a JSON number rounds to infinity in binary64.
bool is_beyond_binary64(std::string_view number) {
  if (number.starts_with('-')) number.remove_prefix(1);
  if (number.size() < 300 && number.find_first_of("eE") == std::string_view::npos) return false;
  double x = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), x);
  return error == std::errc::result_out_of_range && magnitude(number, decimal) > 0;
}

/// A JSON text in which no number is one that the parser misreads.
struct Readable {
  std::string text{};
  std::map<std::size_t, double> infinite{};  ///< by their place among the numbers: those that stand as 0 in the text
};

/// The parser reads -0 as the integer 0; -0.0 keeps its sign. At a number beyond binary64 it stops: where such numbers
/// are infinite, they are written as zeros of the same length.
Readable readable(std::string_view text, Beyond beyond) {
  constexpr std::string_view in_numbers = "+-.0123456789Ee";
  Readable result;
  bool in_string = false;
  std::size_t numbers = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    const bool number = !in_string && (c == '-' || (c >= '0' && c <= '9'));
    const std::size_t end = number                   ? std::min(text.find_first_not_of(in_numbers, i), text.size())
                            : in_string && c == '\\' ? std::min(i + 2, text.size())
                                                     : i + 1;
    const std::string_view word = text.substr(i, end - i);
    i = end;
    if (c == '"') in_string = !in_string;
    if (number && beyond == Beyond::infinite && is_beyond_binary64(word)) {
      const double infinity = std::numeric_limits<double>::infinity();
      result.infinite[numbers] = c == '-' ? -infinity : infinity;
      result.text += '0';
      result.text.append(word.size() - 1, ' ');
    } else {
      result.text += word;
      if (word == "-0") result.text += ".0";
    }
    numbers += number ? 1 : 0;
  }
  return result;
}

/// A parser callback that fails on the second key of one name in an object, of which the parser itself keeps the last,
/// and makes those numbers infinite.
Json::parser_callback_t callback(const Where& where, const std::map<std::size_t, double>& infinite) {
  return [&where, &infinite, numbers = std::size_t{0}, open = std::vector<std::set<std::string>>()](
             int, Json::parse_event_t event, Json& parsed) mutable {
    if (event == Json::parse_event_t::object_start) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key && !open.back().insert(parsed.get<std::string>()).second) {
      where.fail("key \"" + parsed.get<std::string>() + "\" twice in one object");
    }
    if (event == Json::parse_event_t::value && parsed.is_number()) {
      if (const auto found = infinite.find(numbers++); found != infinite.end()) parsed = found->second;
    }
    return true;
  };
}

/// What the parser says, without its tag "[json.exception.…] ".
std::string after_tag(const std::string& what) {
  const std::size_t tag_end = what.find("] ");
  return tag_end == std::string::npos ? what : what.substr(tag_end + 2);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string shorten(std::string text) { return text.size() > 60 ? text.substr(0, 57) + "..." : text; }

/// A value for a message, shortened.
std::string found(const Json& value) {
  const bool infinite = value.is_number_float() && !std::isfinite(value.get<double>());
  return infinite ? "a number beyond binary64" : shorten(value.dump());
}

/// "NaN", "-inf", "Infinity" and the like.
std::optional<double> not_finite(std::string text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.erase(0, 1);
  std::ranges::transform(text, text.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  if (text == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (text != "inf" && text != "infinity") return std::nullopt;
  return negative ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
}

/// The number that a value stands for by itself, finite or not; a string other than a hex float is none.
double number_in(const Json& value, const Where& where) {
  double x = 0;
  if (value.is_number()) return value.get<double>();
  // An integer too long for a double would be rounded by the conversion exactly as strtod rounds it.
  if (value.is_string() && parse_hex_float(value.get_ref<const std::string&>(), x)) return x;
  where.fail("expected a number or a hex-float string like \"0x1.8p+1\", found " + found(value));
}

double exact_in(double x, const Json& value, Format format, const Where& where) {
  if (is_exact_in(x, format)) return x;
  where.fail("expected a number that is exact in binary32, found " + found(value));
}

template <class Read>
Point3 three_numbers(const Json& value, Format format, const Where& where, const Read& read) {
  if (!value.is_array() || value.size() != 3) where.fail("expected three numbers, found " + found(value));
  return {read(value[0], format, where.index(0)), read(value[1], format, where.index(1)),
          read(value[2], format, where.index(2))};
}

Json parsed(std::string_view given, const Where& where, Beyond beyond) {
  if (given.starts_with(byte_order_mark)) {
    if (where.line > 1) where.fail("a byte-order mark, expected none but at the start of the file");
    given.remove_prefix(byte_order_mark.size());
  }
  // The parser skips a mark of its own, and takes a byte 0 for the end of the text.
  if (given.starts_with(byte_order_mark)) where.fail("not valid JSON: a second byte-order mark");
  if (given.find('\0') != given.npos) where.fail("not valid JSON: a byte 0");
  const auto [text, infinite] = readable(given, beyond);
  if (depth_of(text) > max_depth) where.fail("nested deeper than " + std::to_string(max_depth) + " levels");
  try {
    return Json::parse(text, callback(where, infinite));
  } catch (const nlohmann::json::parse_error& e) {
    Where at = where;
    if (at.line == 0)
      at.line =
          1 + static_cast<std::size_t>(std::count(text.begin(), text.begin() + std::min(e.byte, text.size()), '\n'));
    at.fail(std::string("not valid JSON: ") + after_tag(e.what()));
  } catch (const nlohmann::json::exception& e) {
    where.fail(std::string("not valid JSON: ") + after_tag(e.what()));
  }
}

}  // namespace

Where Where::key(std::string_view name) const {
  return {file, line, path.empty() ? std::string(name) : path + "." + std::string(name)};
}

Where Where::index(std::size_t i) const { return {file, line, path + "[" + std::to_string(i) + "]"}; }

void Where::fail(const std::string& what) const {
  throw bad_input(file, line, shown(path.empty() ? what : path + ": " + what));
}

std::string hex_float(double x) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x < 0 ? "-inf" : "inf";
  char digits[40];
  const char* const end = std::to_chars(digits, digits + sizeof digits, std::fabs(x), std::chars_format::hex).ptr;
  return (std::signbit(x) ? "-0x" : "0x") + std::string(digits, static_cast<std::size_t>(end - digits));
}

/// std::from_chars, which does not depend on the locale, takes no "0x", so sign and prefix are read here.
bool parse_hex_float(std::string_view text, double& x) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (!text.starts_with("0x") && !text.starts_with("0X")) return false;
  text.remove_prefix(2);
  if (text.empty() || text.front() == '-') return false;
  if (text.find("+-") != text.npos) return false;  // which from_chars of libstdc++ 12 takes for "-"
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x, std::chars_format::hex);
  if (end != text.data() + text.size()) return false;
  if (error == std::errc::result_out_of_range)
    x = magnitude(text, hexadecimal) < 0 ? 0 : std::numeric_limits<double>::infinity();
  if (negative) x = -x;
  return error == std::errc{} || error == std::errc::result_out_of_range;
}

double to_number(const Json& value, Format format, const Where& where) {
  const double x = number_in(value, where);
  if (!std::isfinite(x)) where.fail("expected a finite number, found " + found(value));
  return exact_in(x, value, format, where);
}

double to_any_number(const Json& value, Format format, const Where& where) {
  if (value.is_string()) {
    if (const auto x = not_finite(value.get<std::string>())) return *x;
  }
  const double x = number_in(value, where);
  return std::isfinite(x) ? exact_in(x, value, format, where) : x;
}

Point3 to_point(const Json& value, Format format, const Where& where) {
  return three_numbers(value, format, where, to_number);
}

Point3 to_any_point(const Json& value, Format format, const Where& where) {
  return three_numbers(value, format, where, to_any_number);
}

Json from_point(const Point3& p) { return Json::array({hex_float(p.x), hex_float(p.y), hex_float(p.z)}); }

Json parse_json(std::string_view text, const Where& where) { return parsed(text, where, Beyond::refused); }

Json parse_json_beyond(std::string_view text, const Where& where) { return parsed(text, where, Beyond::infinite); }

Json with_strings(const Json& value, std::string (*made)(std::string_view)) {
  if (value.is_string()) return made(value.get_ref<const std::string&>());
  if (!value.is_structured()) return value;
  Json result = value.is_array() ? Json::array() : Json::object();
  for (const auto& item : value.items()) {
    if (value.is_array()) {
      result.push_back(with_strings(item.value(), made));
    } else {
      result[made(item.key())] = with_strings(item.value(), made);
    }
  }
  return result;
}

const Json& require(const Json& object, std::string_view key, const Where& where) {
  const auto found = object.find(std::string(key));
  if (found == object.end()) where.fail("missing \"" + std::string(key) + "\"");
  return *found;
}

std::string name_at(const Json& object, std::string_view key, const Where& where) {
  const Json& value = require(object, key, where);
  if (value.is_string() && is_name(value.get_ref<const std::string&>())) return value.get<std::string>();
  where.key(key).fail(std::string("expected ") + name_rule + ", found " + found(value));
}

void require_keys(const Json& object, std::initializer_list<std::string_view> known, const Where& where) {
  if (!object.is_object()) where.fail("expected an object, found " + found(object));
  const std::vector<std::string> names(known.begin(), known.end());
  for (const auto& item : object.items()) {
    if (std::ranges::find(names, item.key()) == names.end()) {
      where.fail("unknown key \"" + shorten(item.key()) + "\"" +
                 suggestion(item.key(), names, "one of " + listed(names)));
    }
  }
}

}  // namespace tribunal
