#include "exact/methods.h"

#include <algorithm>
#include <utility>

#include "core/polygon_rivals.h"
#include "core/rivals.h"
#include "exact/filtered/filtered_method.h"
#include "exact/io/failure.h"
#include "exact/kernels/exact_methods.h"
#include "exact/kernels/naive.h"

namespace tribunal {

namespace {

/// A deque: a row keeps its address when others are added.
std::deque<Method>& table() {
  static std::deque<Method> rows = {
      sf_float(),
      sf_double(),
      sf_double_eps(),
      sf_filtered(),
      sf_epick(),
      sf_epeck(),
      sf_rational(),
      moeller_trumbore_float(),
      moeller_trumbore_double(),
      haines_float(),
      haines_double(),
      feito_float(),
      feito_double(),
      cgal_epick(),
      cgal_epeck(),
  };
  return rows;
}

}  // namespace

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

const Method& reference_method() {
  static const Method reference = sf_rational();
  return reference;
}

}  // namespace tribunal
