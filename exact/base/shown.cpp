#include "exact/base/shown.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>

namespace tribunal {
namespace {

constexpr std::size_t longest_name = 32;

/// One character of a text, or one byte that begins none.
struct Character {
  std::uint32_t code;
  std::size_t bytes;  ///< 0 if it is no UTF-8
};

constexpr bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// The first character of a text that is not empty. Longer forms than needed, surrogates and what is beyond U+10FFFF
/// are no UTF-8.
Character first_of(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead < 0xc2 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 0;
  if (bytes == 0 || text.size() < bytes) return {lead, 0};
  constexpr std::uint32_t lead_bits[] = {0, 0, 0x1f, 0x0f, 0x07}, least[] = {0, 0, 0x80, 0x800, 0x10000};
  std::uint32_t code = lead & lead_bits[bytes];
  for (std::size_t i = 1; i < bytes; ++i) {
    if (!continues(text[i])) return {lead, 0};
    code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3fU);
  }
  const bool surrogate = code >= 0xd800 && code < 0xe000;
  return code < least[bytes] || surrogate || code > 0x10ffff ? Character{lead, 0} : Character{code, bytes};
}

/// What steers, and what shows as nothing: controls, separators of lines, the characters of format (Cf) and those with
/// Default_Ignorable_Code_Point (Unicode Standard Annex #44, version 15.0), private use, and what is no character.
bool is_hidden(std::uint32_t code) {
  constexpr struct {
    std::uint32_t from, to;
  } hidden[] = {{0x0, 0x1f},        {0x7f, 0x9f},       {0xad, 0xad},       {0x34f, 0x34f},     {0x600, 0x605},
                {0x61c, 0x61c},     {0x6dd, 0x6dd},     {0x70f, 0x70f},     {0x890, 0x891},     {0x8e2, 0x8e2},
                {0x115f, 0x1160},   {0x17b4, 0x17b5},   {0x180b, 0x180f},   {0x200b, 0x200f},   {0x2028, 0x202e},
                {0x2060, 0x206f},   {0x3164, 0x3164},   {0xe000, 0xf8ff},   {0xfdd0, 0xfdef},   {0xfe00, 0xfe0f},
                {0xfeff, 0xfeff},   {0xffa0, 0xffa0},   {0xfff0, 0xfffb},   {0x110bd, 0x110bd}, {0x110cd, 0x110cd},
                {0x13430, 0x1343f}, {0x1bca0, 0x1bca3}, {0x1d173, 0x1d17a}, {0xe0000, 0xe0fff}, {0xf0000, 0x10ffff}};
  const bool no_character = (code & 0xfffe) == 0xfffe;
  return no_character ||
         std::ranges::any_of(hidden, [&](const auto& range) { return code >= range.from && code <= range.to; });
}

void add_escape(std::string& text, const char* format, std::uint32_t code) {
  char escape[16];
  std::snprintf(escape, sizeof escape, format, static_cast<unsigned>(code));
  text += escape;
}

constexpr bool is_plain_ascii(char c) { return c >= 0x20 && c < 0x7f; }

std::string shown_but(std::string_view text, std::string_view kept) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && (is_plain_ascii(text[end]) || kept.find(text[end]) != kept.npos)) ++end;
    result += text.substr(i, end - i);
    i = end;
    if (i == text.size()) break;
    const Character c = first_of(text.substr(i));
    if (c.bytes == 0) {
      add_escape(result, "\\x%02x", c.code);
    } else if (is_hidden(c.code)) {
      add_escape(result, c.code < 0x10000 ? "\\u%04x" : "\\U%08x", c.code);
    } else {
      result += text.substr(i, c.bytes);
    }
    i += std::max<std::size_t>(c.bytes, 1);
  }
  return result;
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool fits_a_name(char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-'; }

}  // namespace

std::string shown(std::string_view text) { return shown_but(text, ""); }

std::string shown_lines(std::string_view text) { return shown_but(text, "\n\t"); }

std::size_t whole_characters(std::string_view text) {
  for (std::size_t back = 1; back <= std::min<std::size_t>(3, text.size()); ++back) {
    const char c = text[text.size() - back];
    if (continues(c)) continue;
    const auto lead = static_cast<unsigned char>(c);
    const std::size_t bytes = lead < 0xc2 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 1;
    return bytes > back ? text.size() - back : text.size();
  }
  return text.size();
}

std::string shown_shortly(std::string_view text, std::size_t most) {
  const std::string whole = shown(text);
  if (whole.size() <= most) return whole;
  std::size_t head = most * 3 / 4, tail = whole.size() - most / 4;
  while (head > 0 && continues(whole[head])) --head;
  while (tail < whole.size() && continues(whole[tail])) ++tail;
  return whole.substr(0, head) + " [...] " + whole.substr(tail);
}

bool shows_as_it_is(std::string_view text) { return shown(text) == text; }

std::string in_markdown(std::string_view text) {
  std::string result;
  const std::string line = shown(text);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const bool in_word = i > 0 && i + 1 < line.size() && fits_a_name(line[i - 1]) && fits_a_name(line[i + 1]);
    if (c == '<') {
      result += "&lt;";
    } else if (c == '>') {
      result += "&gt;";
    } else if (c == '&') {
      result += "&amp;";
    } else {
      if (std::string_view("\\`*[]|~").find(c) != std::string_view::npos || (c == '_' && !in_word)) result += '\\';
      result += c;
    }
  }
  return result;
}

bool is_name(std::string_view text) {
  return !text.empty() && text.size() <= longest_name && is_letter(text[0]) && std::ranges::all_of(text, fits_a_name);
}

}  // namespace tribunal
