#include "exact/methods/methods.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "core/polygon_rivals.h"
#include "exact/base/failure.h"
#include "exact/methods/exact_methods.h"
#include "exact/methods/filtered_method.h"
#include "exact/methods/naive.h"
#include "exact/methods/rivals.h"
#include "exact/methods/shelf.h"

namespace tribunal {

namespace {

/// A method's name stands here and nowhere else in the program.
struct Row {
  std::string name;
  Method (*make)();
  std::vector<Role> roles{};
  Maker maker = Maker::segura_feito;
};

/// A rival in both formats.
template <template <class> class Rival>
void add_rows(const published::ShelfRow<Rival>& row, std::vector<Row>& table) {
  std::vector<Role> roles = row.charted ? std::vector{Role::charted} : std::vector<Role>{};
  table.push_back({row.name + std::string("-float"), rival<Rival, float>, roles, Maker::published});
  if (row.yardstick) roles.push_back(Role::yardstick);
  table.push_back({row.name + std::string("-double"), rival<Rival, double>, roles, Maker::published});
}

std::vector<Row> all_rows() {
  std::vector<Row> table = {
      {"sf-float", sf_float, {Role::calibration, Role::charted}},
      {"sf-double", sf_double, {Role::calibration, Role::charted}},
      {"sf-double-eps", sf_double_eps},
      {"sf-filtered", sf_filtered, {Role::flagship}},
      {"sf-epick", sf_epick},
      {"sf-epeck", sf_epeck},
      {"sf-expansion", sf_expansion},
      {"sf-rational", sf_rational, {Role::reference}},
  };
  published::visit_shelf([&](const auto& row) { add_rows(row, table); });
  const std::vector<Row> others = {
      {"haines-float", haines_float, {}, Maker::published},
      {"haines-double", haines_double, {}, Maker::published},
      {"feito-float", feito_float, {}, Maker::published},
      {"feito-double", feito_double, {}, Maker::published},
      {"cgal-epick", cgal_epick, {Role::second_opinion}, Maker::library},
      {"cgal-epeck", cgal_epeck, {}, Maker::library},
  };
  table.insert(table.end(), others.begin(), others.end());
  return table;
}

const std::vector<Row>& rows() {
  static const std::vector<Row> table = all_rows();
  return table;
}

/// A deque: a method keeps its address when others are added.
std::deque<Method> made() {
  std::deque<Method> methods;
  for (const Row& row : rows()) {
    methods.push_back(row.make());
    methods.back().name = row.name;
  }
  return methods;
}

std::deque<Method>& table() {
  static std::deque<Method> methods = made();
  return methods;
}

bool holds(const Row& row, Role role) { return std::ranges::find(row.roles, role) != row.roles.end(); }

}  // namespace

std::string_view name_of(Role role) {
  constexpr std::array<std::string_view, 6> names = {"reference", "second opinion", "calibration",
                                                     "flagship",  "charted",        "yardstick"};
  return names[static_cast<std::size_t>(role)];
}

const std::deque<Method>& all_methods() { return table(); }

void add_method(Method method) {
  if (find_method(method.name) != nullptr) throw Failure(Exit::usage, "two methods are called " + method.name);
  table().push_back(std::move(method));
}

const Method* find_method(std::string_view name) {
  const std::deque<Method>& methods = all_methods();
  const auto found = std::ranges::find(methods, name, &Method::name);
  return found == methods.end() ? nullptr : &*found;
}

const Method& method_with(Role role) {
  for (std::size_t i = 0; i < rows().size(); ++i) {
    if (holds(rows()[i], role)) return table()[i];
  }
  throw std::logic_error("no method has the role: " + std::string(name_of(role)));
}

std::vector<Method> methods_with(Role role) {
  std::vector<Method> methods;
  for (std::size_t i = 0; i < rows().size(); ++i) {
    if (holds(rows()[i], role)) methods.push_back(table()[i]);
  }
  return methods;
}

std::vector<const Method*> methods_with(Capability capability) {
  std::vector<const Method*> methods;
  for (const Method& m : all_methods()) {
    if (has(m, capability)) methods.push_back(&m);
  }
  return methods;
}

std::vector<Role> roles_of(const Method& method) {
  const auto row = std::ranges::find(rows(), method.name, &Row::name);
  return row == rows().end() ? std::vector<Role>{} : row->roles;
}

bool has_role(const Method& method, Role role) {
  const std::vector<Role> roles = roles_of(method);
  return std::ranges::find(roles, role) != roles.end();
}

Maker maker_of(const Method& method) {
  const auto row = std::ranges::find(rows(), method.name, &Row::name);
  return row == rows().end() ? Maker::added : row->maker;
}

}  // namespace tribunal
