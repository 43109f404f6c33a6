// What `sweep` wrote: sweep.json and witnesses.jsonl, compilers.json, map-NAME.json.
#include <algorithm>
#include <map>

#include "exact/report/gathering.h"
#include "exact/report/table.h"

namespace tribunal {
namespace {

std::uint64_t number_in(const Json& row, const char* key) { return row.value(key, std::uint64_t{0}); }

/// A row with what was wrong as members of its own: outcomes keep their names, severities theirs.
Json flat(Json row) {
  const Json outcomes = row.value("outcomes", Json::object());
  row.erase("outcomes");
  row.update(outcomes);
  return row;
}

/// What was judged and wrong of one method in one format, over all axes.
Json sum_of(const Json& rows, const std::string& method, const std::string& fmt) {
  std::map<std::string, std::uint64_t> sum;
  for (const Json& row : rows) {
    if (row.at("method") != method || row.at("fmt") != fmt) continue;
    sum["judged"] += number_in(row, "judged");
    sum["wrong"] += number_in(row.at("wrong"), "k");
    for (const char* key : {"plain", "boundary", "extreme"}) sum[key] += number_in(row, key);
  }
  return sum;
}

Json names_of(const Json& objects) {
  Json names = Json::array();
  for (const Json& o : objects) names.push_back(o.at("name"));
  return names;
}

/// A failure map is made of segments around one contact: what is wrong there is wrong on a boundary.
Line map_line(std::size_t run, const Json& panel, const std::string& map) {
  const Json counts = panel.value("counts", Json::object());
  const auto count = [&](const char* key) { return number_in(counts, key); };
  const std::uint64_t wrong = count("false hit") + count("false miss") + count("wrong contact") + count("fault");
  const std::uint64_t judged = wrong + count("right");
  const std::string method = panel.at("method");
  return {.run = run,
          .method = method,
          .level = wrong > 0 ? Level::boundary : Level::nothing,
          .fmt = panel.value("fmt", ""),
          .text = method + ": wrong on " + share_in_words(wrong, judged) + " pixels of the map " + map,
          .detail = "each pixel is a case, some units in the last place from a contact",
          .wrong = wrong,
          .judged = judged};
}

}  // namespace

void gather_sweep(Run& run, Gathering& g) {
  Json r = run.record;
  run.page["methods"] = names_of(r.at("methods"));
  run.page["command"] = command_of({"sweep", "--method", joined(run.page["methods"]), "--axis",
                                    joined(names_of(r.at("axes"))), "--seed", std::to_string(number_in(r, "seed")),
                                    "--count", std::to_string(number_in(r, "cases")), "--out", run.directory});
  for (const Json& m : r["methods"]) {
    const std::string method = g.add_method(m);
    for (const char* fmt : {"binary64", "binary32"}) {
      const Json sum = sum_of(r.at("rows"), method, fmt);
      if (number_in(sum, "judged") > 0) g.add(line_of(run.number, method, fmt, sum));
    }
  }
  Json rows = Json::array();
  for (const Json& row : r["rows"]) rows.push_back(flat(row));
  r["rows"] = table_of(rows).json();
  for (Json& threshold : r.at("thresholds")) {
    const auto number = g.book.number_of(run.number, threshold.value("witness", ""));
    threshold["case"] = number ? Json(*number) : Json();
  }
  r.erase("environment");
  run.page["record"] = std::move(r);
}

void gather_compilers(Run& run, Gathering& g) {
  Json r = run.record;
  Json names = Json::array();
  for (const Json& row : r.at("rows")) {
    if (std::ranges::find(names, row.at("method")) == names.end()) names.push_back(row["method"]);
  }
  for (const Json& name : names) g.add_method({{"name", name}});
  run.page["methods"] = names;
  run.page["command"] =
      command_of({"sweep", "--axis", "compiler", "--seed", std::to_string(number_in(r, "seed")), "--count",
                  std::to_string(number_in(r, "cases_of_each_format")), "--out", run.directory});
  r.erase("environment");
  run.page["record"] = std::move(r);
}

void gather_map(Run& run, Gathering& g) {
  Json r = run.record;
  const std::string map = r.at("map");
  run.page["title"] = "map " + map;
  run.page["methods"] = Json::array();
  for (const Json& panel : r.at("panels")) {
    run.page["methods"].push_back(g.add_method({{"name", panel.at("method")}, {"fmt", panel.value("fmt", "")}}));
    g.add(map_line(run.number, panel, map));
  }
  std::vector<std::string> words{"sweep", "--map", map};
  if (r.value("probe", "segment") == "ray") words.insert(words.end(), {"--probe", "ray"});
  words.insert(words.end(), {"--map-size", std::to_string(number_in(r, "size")), "--method",
                             joined(run.page["methods"]), "--out", run.directory});
  run.page["command"] = command_of(words);
  for (const char* key : {"base", "unit"}) {
    if (!r.contains(key)) r[key] = Json();
  }
  r.erase("environment");
  run.page["record"] = std::move(r);
}

}  // namespace tribunal
