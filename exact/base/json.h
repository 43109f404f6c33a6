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

/// "0x1.8p+1". Every finite double has one; −0 is "-0x0p+0".
std::string hex_float(double x);

/// A number, exactly: a C99 hex-float string, or a JSON number (rounded correctly). Must be finite and, for
/// binary32, exact in binary32. The reading does not depend on the locale.
double to_number(const Json& value, Format format, const Where& where);

Point3 to_point(const Json& value, Format format, const Where& where);

Json from_point(const Point3& p);

/// One JSON text, with nothing after it. Refuses nesting deeper than 64 before parsing.
Json parse_json(std::string_view text, const Where& where);

/// The member; fails if it is missing.
const Json& require(const Json& object, std::string_view key, const Where& where);

/// Fails if the value is no object or has a key that is not in the list. The message names the known key that it
/// resembles, or all known keys.
void require_keys(const Json& object, std::initializer_list<std::string_view> known, const Where& where);

}  // namespace tribunal
