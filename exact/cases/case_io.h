// Case and answer files: JSON Lines, one object a line, as docs/formats.md describes them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/method.h"
#include "exact/base/json.h"

namespace tribunal {

/// A query with a name, as case files hold it.
struct Case {
  std::string id{};
  Format format = Format::binary64;
  Query query{};
  std::optional<bool> expect{};  ///< whether the closed sets meet, if the file says so
  ClassId class_id = 0;          ///< of a triangle case; 0 if the file does not say
  std::string source{};
  Json finding{};  ///< what a counterexample adds: passed on, not interpreted
};

/// One case, with "tri" or "rings". A key that the format does not have is an error.
Case to_case(const Json& object, const Where& where);

Json from_case(const Case& c);

/// Calls `visit` with the object on every line that is not blank, in order. A line may have 1 MiB.
void for_each_line(const std::string& path, const std::function<void(const Json& object, const Where& where)>& visit);

/// The same for the text of a file of this name.
void for_each_line_in(std::string_view text, const std::string& path,
                      const std::function<void(const Json& object, const Where& where)>& visit);

/// Every line of a case file that is not blank, in order. An empty file is an error.
std::vector<Case> read_cases(const std::string& path);
std::vector<Case> cases_in(std::string_view text, const std::string& path);

/// The method's answer to the case; for a polygon with "planar".
Json from_answer(const Case& c, const Method& method, const Answer& answer);

}  // namespace tribunal
