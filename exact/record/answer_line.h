// One line of an answer file, computed elsewhere.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "core/method.h"
#include "exact/base/json_fwd.h"

namespace tribunal {

/// What a method answered to the case of this id. Only `hit`, `status` and, of a hit that says it, the contact and the
/// side are set. `numbers`: of a hit that says it, t and the weights of b and c.
struct GivenAnswer {
  std::string id{}, method{};
  Answer answer{};
  std::optional<HitAt> numbers{};
};

/// Reads it from an object. Answers without a method belong to one called "answers". Fails with Exit::bad_input.
GivenAnswer to_given_answer(const Json& object, const Where& where);

/// Reads it from the line of a file, as to_given_answer does, but quicker where the line is as programs write it.
void read_answer(std::string_view line, const std::string& path, std::size_t number, GivenAnswer& given);

/// The quick way alone: false, with anything in `given`, for every line that is not of the usual kind, legal or not.
bool scan_answer(std::string_view line, GivenAnswer& given);

}  // namespace tribunal
