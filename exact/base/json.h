// Numbers and objects of the project's JSON files.
#pragma once

#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/format.h"
#include "core/vec3.h"
#include "exact/base/json_fwd.h"

namespace tribunal {

/// "0x1.8p+1". Every double has one: −0 is "-0x0p+0", what is not finite "nan", "inf" or "-inf".
std::string hex_float(double x);

/// A number, exactly: a C99 hex-float string, or a JSON number (rounded correctly). Must be finite and, for
/// binary32, exact in binary32. The reading does not depend on the locale.
double to_number(const Json& value, Format format, const Where& where);

Point3 to_point(const Json& value, Format format, const Where& where);

/// A number as cases have them: one as above, or one that is not finite. That is a string "nan", "inf" or "infinity",
/// in small letters or capitals and with a sign or without, or a number, decimal or hex, that rounds to infinity in
/// binary64.
double to_any_number(const Json& value, Format format, const Where& where);

Point3 to_any_point(const Json& value, Format format, const Where& where);

Json from_point(const Point3& p);

/// What becomes of a number like 1e999, beyond binary64: the text is refused, or the number is infinite.
enum class Beyond { refused, infinite };

/// One JSON text, with nothing after it. Refuses nesting deeper than 64 before parsing. A byte-order mark
/// at the start of a file is skipped.
Json parse_json(std::string_view text, const Where& where, Beyond beyond = Beyond::refused);

/// The value with every string in it, keys too, made another one.
Json with_strings(const Json& value, std::string (*made)(std::string_view));

/// The member; fails if it is missing.
const Json& require(const Json& object, std::string_view key, const Where& where);

/// The member, a name by the rule for names from elsewhere (shown.h); fails if it is missing or another text.
std::string name_at(const Json& object, std::string_view key, const Where& where);

/// Fails if the value is no object or has a key that is not in the list. The message names the known key that it
/// resembles, or all known keys.
void require_keys(const Json& object, std::initializer_list<std::string_view> known, const Where& where);

}  // namespace tribunal
