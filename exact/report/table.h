// Many rows of one shape, as a report's JSON holds them: {"columns": […], "words": {…}, "rows": [[…], …]}.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "exact/base/json.h"

namespace tribunal {

/// A column of texts is stored as indices into its list of words; numbers and nulls stand as they are. So a table of
/// 26,000 counts takes a tenth of what as many objects take.
class Table {
 public:
  explicit Table(std::vector<std::string> columns) : columns_(std::move(columns)), words_(columns_.size()) {}

  /// As many cells as there are columns: texts, numbers, booleans or nulls.
  void add(std::vector<Json> cells);

  std::size_t size() const { return rows_.size(); }

  /// With `cut`, zeros at the end of a row are left out: a missing cell is then 0.
  Json json(bool cut = false) const;

 private:
  struct Words {
    std::map<std::string, std::size_t> index{};
    std::vector<std::string> list{};
  };
  std::vector<std::string> columns_;
  std::vector<Words> words_;
  std::vector<std::vector<Json>> rows_;
};

/// The objects as a table: columns are the keys of all of them in order of appearance, those of nested objects as
/// "outer.inner"; a key that an object lacks is null there. Arrays are no cells: they are left out.
Table table_of(const Json& objects);

}  // namespace tribunal
