#include "exact/report/table.h"

#include <algorithm>

#include "exact/base/record.h"

namespace tribunal {
namespace {

bool is_zero(const Json& cell) { return cell.is_number() && cell == 0; }

/// Calls visit(key, cell) for every cell of the object, those of nested ones under "outer.inner".
template <class Visit>
void for_each_cell(const Json& object, const std::string& prefix, const Visit& visit) {
  for (const auto& [key, value] : object.items()) {
    if (value.is_object()) {
      for_each_cell(value, prefix + key + ".", visit);
    } else if (!value.is_array()) {
      visit(prefix + key, value);
    }
  }
}

}  // namespace

void Table::add(std::vector<Json> cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!cells[i].is_string()) continue;
    Words& words = words_[i];
    const auto [at, is_new] = words.index.emplace(Record(cells[i], {columns_[i]}).text(), words.list.size());
    if (is_new) words.list.push_back(at->first);
    cells[i] = at->second;
  }
  rows_.push_back(std::move(cells));
}

Json Table::json(bool cut) const {
  Json words = Json::object();
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (!words_[i].list.empty()) words[columns_[i]] = words_[i].list;
  }
  Json rows = Json::array();
  for (std::vector<Json> row : rows_) {
    while (cut && !row.empty() && words_[row.size() - 1].list.empty() && is_zero(row.back())) row.pop_back();
    rows.push_back(std::move(row));
  }
  return {{"columns", columns_}, {"words", words}, {"rows", std::move(rows)}};
}

Table table_of(const Json& objects) {
  std::vector<std::string> columns;
  std::map<std::string, std::size_t> column;
  for (const Json& object : objects) {
    for_each_cell(object, "", [&](const std::string& key, const Json&) {
      if (column.emplace(key, columns.size()).second) columns.push_back(key);
    });
  }
  Table table(columns);
  for (const Json& object : objects) {
    std::vector<Json> cells(columns.size());
    for_each_cell(object, "", [&](const std::string& key, const Json& value) { cells[column.at(key)] = value; });
    table.add(std::move(cells));
  }
  return table;
}

}  // namespace tribunal
