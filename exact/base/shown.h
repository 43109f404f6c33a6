// Text from elsewhere, as people are shown it: names, ids and messages may hold what steers a terminal, forges a line
// or becomes markup.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tribunal {

/// The text on one line, with an escape for each character that does not show as itself: "\u001b" for control
/// characters (C0, DEL, C1; line feeds and tabs too), line separators, marks and overrides of direction, and the
/// byte-order mark; "\xff" for each byte that is not UTF-8. Laws: the result is UTF-8 and its own image; a JSON text
/// keeps its value, where it has one.
std::string shown(std::string_view text);

/// The same for a text of several lines, in which line feeds and tabs stand as they are.
std::string shown_lines(std::string_view text);

/// How many bytes of a text that is to go on hold whole characters: all, but for the beginning of a last one.
std::size_t whole_characters(std::string_view text);

/// As `shown`, on one line of at most about `most` bytes, without its middle if it is longer.
std::string shown_shortly(std::string_view text, std::size_t most);

/// Whether every character shows as itself.
bool shows_as_it_is(std::string_view text);

/// For a line of Markdown, in a cell of a table too: as `shown`, and without a meaning in Markdown or HTML.
std::string in_markdown(std::string_view text);

/// The rule for names from elsewhere, of methods above all: 1 to 32 of a-z A-Z 0-9 . _ -, a letter first.
bool is_name(std::string_view text);
inline constexpr const char* name_rule = "1 to 32 of a-z A-Z 0-9 . _ -, a letter first";

}  // namespace tribunal
