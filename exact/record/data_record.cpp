#include "exact/record/data_record.h"

#include <algorithm>

#include "exact/base/json.h"

namespace tribunal {

Json data_of(const FuzzPlan& plan) {
  Json files = Json::array();
  const Family* last = nullptr;  // the formats of a family follow each other
  for (const Stream& s : plan.streams) {
    if (s.family == last || !s.family->data) continue;
    last = s.family;
    const DataFile& data = *s.family->data;
    Json file = {{"family", s.family->name},
                 {"file", data.file},
                 {"sha256", data.sha256},
                 {"numbers_sha256", data.numbers_sha256},
                 {"items", data.items}};
    if (!data.left_out.empty()) file["left_out"] = data.left_out;
    files.push_back(std::move(file));
  }
  return files;
}

Json family_names_of(const FuzzPlan& plan) {
  Json names = Json::array();
  for (const Stream& s : plan.streams) {
    if (std::ranges::find(names, Json(s.family->name)) == names.end()) names.push_back(s.family->name);
  }
  return names;
}

}  // namespace tribunal
