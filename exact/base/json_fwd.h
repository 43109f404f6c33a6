// The names of JSON values and of places in files, for headers that only pass them on.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace tribunal {

/// Keeps keys in the order of writing: files are read by people too.
using Json = nlohmann::ordered_json;

/// Where a value stands, for messages: file, line (0: unknown) and path inside the object.
struct Where {
  std::string file;
  std::size_t line = 0;
  std::string path{};

  Where key(std::string_view name) const;
  Where index(std::size_t i) const;
  /// Throws Failure(bad_input): `file:line: path: what`.
  [[noreturn]] void fail(const std::string& what) const;
};

}  // namespace tribunal
