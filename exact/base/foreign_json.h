// What JSON from elsewhere may hold beside finite numbers, and its texts.
#pragma once

#include <string>
#include <string_view>

#include "core/format.h"
#include "core/vec3.h"
#include "exact/base/json_fwd.h"

namespace tribunal {

/// A number as cases have them: one as `to_number` reads it, or one that is not finite. That is a string "nan", "inf"
/// or "infinity", in small letters or capitals and with a sign or without, or a number, decimal or hex, that rounds to
/// infinity in binary64. `hex_float` writes them so that they are read back.
double to_any_number(const Json& value, Format format, const Where& where);

Point3 to_any_point(const Json& value, Format format, const Where& where);

/// As `parse_json`, which refuses a number like 1e999, beyond binary64: it is infinite.
Json parse_json_beyond(std::string_view text, const Where& where);

/// The value with every string in it, keys too, made another one.
Json with_strings(const Json& value, std::string (*made)(std::string_view));

/// The member, a name by the rule for names from elsewhere (shown.h); fails if it is missing or another text.
std::string name_at(const Json& object, std::string_view key, const Where& where);

}  // namespace tribunal
