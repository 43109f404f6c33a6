#include "exact/base/suggestion.h"

#include <algorithm>
#include <numeric>

namespace tribunal {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] != b[j]);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

bool resembles(std::string_view a, std::string_view b) {
  return 3 * edit_distance(a, b) <= std::max(a.size(), b.size()) + 1;
}

}  // namespace

std::string suggestion(std::string_view word, const std::vector<std::string>& known, const std::string& otherwise) {
  const auto nearest =
      std::ranges::min_element(known, {}, [&](const std::string& k) { return edit_distance(word, k); });
  if (nearest == known.end() || !resembles(word, *nearest)) return ", expected " + otherwise;
  return ", did you mean \"" + *nearest + "\"?";
}

}  // namespace tribunal
