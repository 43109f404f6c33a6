// What summary.json and relations.json of `fuzz` must look like.
#include <map>
#include <string>
#include <tuple>

#include "exact/report/shapes.h"

namespace tribunal {
namespace {

using namespace shape;

Check data() { return object({needed("family", text()), needed("file", text()), if_there("sha256", text())}); }

Check row() {
  return [part = object({needed("method", name()), needed("family", text()), needed("fmt", format()),
                         if_there("class", text()), if_there("case", text())}),
          figures = answers()](const Record& r) {
    part(r);
    figures(r);
  };
}

Check errors_of_rows() {
  return object(
      {if_there("one_case_in", count(1'000'000)),
       needed("counts", list(errors({needed("method", name()), needed("family", text()), needed("fmt", format())})))});
}

Check fault() {
  return object({needed("method", name()), needed("fault", text()), if_there("findings", count()),
                 if_there("family", text()), if_there("fmt", text()), if_there("case", count())});
}

using Key = std::tuple<std::string, std::string, std::string>;

Key key_of(const Record& row) { return {row.text("method"), row.text("family"), row.text("fmt")}; }

/// Errors are of hits, hits of cases that were asked, and so are faults.
void require_within_counts(const Record& r) {
  std::map<Key, std::uint64_t> asked;
  for (const Record& row : r.items("counts")) {
    std::uint64_t& sum = asked[key_of(row)];
    require_part(row, row.count("asked"), Record::most_count - sum, "asked in all");
    sum += row.count("asked");
  }
  if (const auto errors = r.find("errors")) {
    for (const Record& row : errors->items("counts")) require_part(row, row.count("hits"), asked[key_of(row)], "hits");
  }
  if (!r.has("cases")) return;
  const std::uint64_t cases = r.count("cases");
  require_part(r, r.count_or("audited", 0), cases, "audited");
  for (const Record& row : r.items_or_none("faults")) {
    for (const char* key : {"findings", "case"}) require_part(row, row.count_or(key, 0), cases, key);
  }
}

Check relation() {
  return object({needed("method", name()), needed("relation", text()), needed("fmt", format()),
                 if_there("probes", text()), needed("asked", count()), needed("broken", count())},
                [](const Record& r) { require_part(r, r.count("broken"), r.count("asked"), "broken"); });
}

}  // namespace

void require_fuzz_record(const Record& record) {
  static const Check coverage = named(text());
  static const Check shape = object(
      {needed("counts", list(row())), if_there("methods", list(method())), if_there("seed", whole()),
       if_there("cases", count()), if_there("families", list(text())), if_there("data", list(data())),
       if_there("until_first", truth()), if_there("classes_judged", coverage), if_there("polygons_judged", coverage),
       if_there("judged_by", text()), if_there("audited", count()), if_there("errors", errors_of_rows()),
       if_there("faults", list(fault())), if_there("environment", environment())},
      require_within_counts);
  shape(record);
}

void require_relations_record(const Record& record) {
  static const Check shape =
      object({needed("relations", list(relation())), if_there("seed", whole()), if_there("cases", count()),
              if_there("families", list(text())), if_there("data", list(data())), if_there("until_first", truth()),
              if_there("environment", environment())},
             [](const Record& r) {
               if (!r.has("cases")) return;
               for (const Record& row : r.items("relations"))
                 require_part(row, row.count("asked"), r.count("cases"), "asked");
             });
  shape(record);
}

}  // namespace tribunal
