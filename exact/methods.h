// The table of methods: one row each.
#pragma once

#include <deque>
#include <string_view>

#include "core/method.h"

namespace tribunal {

/// Every method that the program knows, in the order that `tribunal methods` prints.
const std::deque<Method>& all_methods();

/// Adds a row for the rest of the run: a plugin, or a bug planted by a test. Before any thread starts. Fails with
/// Exit::usage if the name is taken.
void add_method(Method method);

/// The method of that name, or nullptr.
const Method* find_method(std::string_view name);

/// The reference that judges the others: sf-rational.
const Method& reference_method();

}  // namespace tribunal
