// The table of methods: one row each.
#pragma once

#include <span>
#include <string_view>

#include "core/method.h"

namespace tribunal {

/// Every method that the program knows, in the order that `tribunal methods` prints.
std::span<const Method> all_methods();

/// The method of that name, or nullptr.
const Method* find_method(std::string_view name);

/// The reference that judges the others: sf-rational.
const Method& reference_method();

}  // namespace tribunal
