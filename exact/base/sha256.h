// The hash of bytes.
#pragma once

#include <string>
#include <string_view>

namespace tribunal {

/// SHA-256 (FIPS 180-4) of the bytes, in hex.
std::string sha256(std::string_view bytes);

}  // namespace tribunal
