// Bits of HTML, and numbers as people read them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tribunal {

/// Text with &, <, >, " and ' made harmless, for content and quoted attributes alike.
std::string escape(std::string_view text);

/// `<tag attributes>content</tag>`. Content and attributes are HTML already.
std::string element(std::string_view tag, std::string_view content, std::string_view attributes = "");

/// 14348907 → "14,348,907".
std::string grouped(std::uint64_t n);

/// 0.0606 → "6.06 %"; small shares keep two digits: "0.00041 %".
std::string percent(double share);

}  // namespace tribunal
