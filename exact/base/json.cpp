#include "exact/base/json.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>

#include "exact/base/failure.h"
#include "exact/base/scan.h"
#include "exact/base/suggestion.h"

namespace tribunal {
namespace {

constexpr int max_depth = 64;

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

/// Whether a hex float out of range is too small rather than too large: its exponent says so.
bool is_tiny(std::string_view hex_float) {
  const std::size_t p = hex_float.find_first_of("pP");
  return p != std::string_view::npos && hex_float.substr(p + 1).starts_with('-');
}

/// A parser callback that fails on the second key of one name in an object; the parser itself keeps the last.
Json::parser_callback_t refuse_duplicates(const Where& where) {
  return [where, open = std::vector<std::set<std::string>>()](int, Json::parse_event_t event, Json& parsed) mutable {
    if (event == Json::parse_event_t::object_start) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key && !open.back().insert(parsed.get<std::string>()).second) {
      where.fail("key \"" + parsed.get<std::string>() + "\" twice in one object");
    }
    return true;
  };
}

/// The parser reads -0 as the integer 0; -0.0 keeps its sign.
std::string with_signed_zeros(std::string_view text) {
  std::string result;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    result += text[i];
    if (in_string && text[i] == '\\' && i + 1 < text.size()) result += text[++i];
    if (text[i] == '"') in_string = !in_string;
    const bool minus_zero = !in_string && text[i] == '0' && i > 0 && text[i - 1] == '-' &&
                            (i < 2 || std::string_view("[,: \t\r\n").find(text[i - 2]) != std::string_view::npos);
    if (minus_zero &&
        (i + 1 == text.size() || std::string_view(".eE0123456789").find(text[i + 1]) == std::string_view::npos)) {
      result += ".0";
    }
  }
  return result;
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

}  // namespace

Where Where::key(std::string_view name) const {
  return {file, line, path.empty() ? std::string(name) : path + "." + std::string(name)};
}

Where Where::index(std::size_t i) const { return {file, line, path + "[" + std::to_string(i) + "]"}; }

void Where::fail(const std::string& what) const {
  throw bad_input(file, line, path.empty() ? what : path + ": " + what);
}

std::string hex_float(double x) {
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
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x, std::chars_format::hex);
  if (end != text.data() + text.size()) return false;
  if (error == std::errc::result_out_of_range) x = is_tiny(text) ? 0 : std::numeric_limits<double>::infinity();
  if (negative) x = -x;
  return error == std::errc{} || error == std::errc::result_out_of_range;
}

double to_number(const Json& value, Format format, const Where& where) {
  double x = 0;
  if (value.is_number()) {
    x = value.get<double>();
    // An integer too long for a double would be rounded by the conversion exactly as strtod rounds it.
  } else if (!value.is_string() || !parse_hex_float(value.get_ref<const std::string&>(), x)) {
    where.fail("expected a number or a hex-float string like \"0x1.8p+1\", found " + shorten(value.dump()));
  }
  if (!std::isfinite(x)) where.fail("expected a finite number, found " + shorten(value.dump()));
  if (!is_exact_in(x, format)) {
    where.fail("expected a number that is exact in binary32, found " + shorten(value.dump()));
  }
  return x;
}

Point3 to_point(const Json& value, Format format, const Where& where) {
  if (!value.is_array() || value.size() != 3) where.fail("expected three numbers, found " + shorten(value.dump()));
  return {to_number(value[0], format, where.index(0)), to_number(value[1], format, where.index(1)),
          to_number(value[2], format, where.index(2))};
}

Json from_point(const Point3& p) { return Json::array({hex_float(p.x), hex_float(p.y), hex_float(p.z)}); }

Json parse_json(std::string_view given, const Where& where) {
  const std::string text = with_signed_zeros(given);
  if (depth_of(text) > max_depth) where.fail("nested deeper than " + std::to_string(max_depth) + " levels");
  try {
    return Json::parse(text, refuse_duplicates(where));
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

const Json& require(const Json& object, std::string_view key, const Where& where) {
  const auto found = object.find(std::string(key));
  if (found == object.end()) where.fail("missing \"" + std::string(key) + "\"");
  return *found;
}

void require_keys(const Json& object, std::initializer_list<std::string_view> known, const Where& where) {
  if (!object.is_object()) where.fail("expected an object, found " + shorten(object.dump()));
  const std::vector<std::string> names(known.begin(), known.end());
  for (const auto& item : object.items()) {
    if (std::ranges::find(names, item.key()) == names.end()) {
      where.fail("unknown key \"" + shorten(item.key()) + "\"" +
                 suggestion(item.key(), names, "one of " + listed(names)));
    }
  }
}

}  // namespace tribunal
