#include "exact/methods.h"

#include <algorithm>
#include <vector>

#include "core/rivals.h"
#include "exact/kernels/exact_methods.h"
#include "exact/kernels/naive.h"

namespace tribunal {

std::span<const Method> all_methods() {
  static const std::vector<Method> table = {
      sf_float(),   sf_double(),   sf_double_eps(),          sf_epick(),
      sf_epeck(),   sf_rational(), moeller_trumbore_float(), moeller_trumbore_double(),
      cgal_epick(), cgal_epeck(),
  };
  return table;
}

const Method* find_method(std::string_view name) {
  const auto methods = all_methods();
  const auto found = std::ranges::find(methods, name, &Method::name);
  return found == methods.end() ? nullptr : &*found;
}

const Method& reference_method() {
  static const Method reference = sf_rational();
  return reference;
}

}  // namespace tribunal
