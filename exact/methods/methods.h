// The table of methods: one row each.
#pragma once

#include <cstdint>
#include <deque>
#include <string_view>
#include <vector>

#include "core/capability.h"
#include "core/method.h"

namespace tribunal {

/// What a method is asked for by the program itself. Code looks a role up; which method holds it is said in the table
/// and nowhere else.
enum class Role : std::uint8_t {
  reference,       ///< judges the others
  second_opinion,  ///< is asked beside the reference where its contract holds, and must agree with it
  calibration,     ///< is naive, and must be wrong somewhere on a sample that is to have teeth
  flagship,        ///< is exact, fast and certified: the one to use
  charted,         ///< stands for the inexact ones on charts, where all of them could not be read
  yardstick        ///< is what times are divided by, so that machines can be compared
};

std::string_view name_of(Role role);

/// Whose test a method is: the paper's on some kernel, a published rival's, a library's own, or one that was added for
/// this run.
enum class Maker : std::uint8_t { segura_feito, published, library, added };

constexpr std::string_view name_of(Maker maker) {
  constexpr std::string_view names[] = {"segura-feito", "published", "library", "plugin"};
  return names[static_cast<int>(maker)];
}

/// Every method that the program knows, in the order that `tribunal methods` prints.
const std::deque<Method>& all_methods();

/// Adds a row for the rest of the run, without a role: a plugin, or a bug planted by a test. Before any thread starts.
/// Fails with Exit::usage if the name is taken.
void add_method(Method method);

/// The method of that name, or nullptr. For names that come from the command line or from a file.
const Method* find_method(std::string_view name);

/// The one method of the role.
const Method& method_with(Role role);

/// All of the role, in the table's order.
std::vector<Method> methods_with(Role role);

/// All that have the capability, in the table's order.
std::vector<const Method*> methods_with(Capability capability);

/// The roles of a method of the table; any other has none.
std::vector<Role> roles_of(const Method& method);
bool has_role(const Method& method, Role role);

Maker maker_of(const Method& method);

inline const Method& reference_method() { return method_with(Role::reference); }
inline const Method& flagship_method() { return method_with(Role::flagship); }
inline const Method& yardstick_method() { return method_with(Role::yardstick); }

}  // namespace tribunal
