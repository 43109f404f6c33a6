// What `fuzz` wrote: summary.json and counterexamples.jsonl, or relations.json and witnesses.jsonl.
#include <algorithm>
#include <array>
#include <map>

#include "exact/cases/family_table.h"
#include "exact/certificate/rate.h"
#include "exact/report/gathering.h"
#include "exact/report/table.h"

namespace tribunal {
namespace {

/// More rows than these make a page heavy: rows without a wrong answer are then added up.
constexpr std::size_t most_rows = 120'000;

/// A count as a row of the tables has it: the numbers of a row of summary.json, in this order.
constexpr std::array numbers = {"asked", "wrong", "unsupported", "refused", "false hit",  "false miss", "wrong contact",
                                "fault", "plain", "boundary",    "extreme", "twin asked", "logic",      "rounding"};
using Numbers = std::array<std::uint64_t, numbers.size()>;

Numbers numbers_of(const Json& row) {
  return {number_in(row, "asked"),
          number_in(row, "wrong"),
          number_in(row, "unsupported"),
          number_in(row, "refused"),
          number_in(row, "outcomes", "false hit"),
          number_in(row, "outcomes", "false miss"),
          number_in(row, "outcomes", "wrong contact"),
          number_in(row, "outcomes", "fault"),
          number_in(row, "severity", "plain"),
          number_in(row, "severity", "boundary"),
          number_in(row, "severity", "extreme"),
          number_in(row, "cause", "asked"),
          number_in(row, "cause", "logic"),
          number_in(row, "cause", "rounding")};
}

Numbers& operator+=(Numbers& sum, const Numbers& other) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += other[i];
  return sum;
}

Json named(const Numbers& n) {
  Json object;
  for (std::size_t i = 0; i < n.size(); ++i) object[numbers[i]] = n[i];
  object["judged"] = n[0] - n[2];
  return object;
}

/// Sums that keep the order in which their keys came up.
class Sums {
 public:
  void add(std::vector<std::string> key, const Numbers& n) {
    const auto [at, is_new] = index_.emplace(key, sums_.size());
    if (is_new) sums_.emplace_back(std::move(key), Numbers{});
    sums_[at->second].second += n;
  }
  const auto& all() const { return sums_; }

 private:
  std::map<std::vector<std::string>, std::size_t> index_;
  std::vector<std::pair<std::vector<std::string>, Numbers>> sums_;
};

Table counts_table(const Sums& counts) {
  std::vector<std::string> columns{"method", "family", "fmt", "slot"};
  columns.insert(columns.end(), numbers.begin(), numbers.end());
  Table table(columns);
  for (const auto& [key, n] : counts.all()) {
    std::vector<Json> cells(key.begin(), key.end());
    cells.insert(cells.end(), n.begin(), n.end());
    table.add(std::move(cells));
  }
  return table;
}

Table totals_table(const Sums& totals) {
  Table table({"method", "family", "fmt", "asked", "judged", "wrong", "share", "lower", "upper", "plain", "boundary",
               "extreme", "false hit", "false miss", "wrong contact", "fault", "logic", "rounding", "refused"});
  for (const auto& [key, n] : totals.all()) {
    const Rate rate = rate_of(n[1], n[0] - n[2]);
    table.add({key[0], key[1], key[2], n[0], rate.judged, n[1], rate.share, rate.lower, rate.upper, n[8], n[9], n[10],
               n[4], n[5], n[6], n[7], n[12], n[13], n[3]});
  }
  return table;
}

/// The methods of the rows, each once.
Json method_names_in(const Json& rows) {
  Json names = Json::array();
  for (const Json& row : rows) {
    if (std::ranges::find(names, row.at("method")) == names.end()) names.push_back(row.at("method"));
  }
  return names;
}

/// Methods in the order of the record, which older ones do not say: then that of their counts.
Json method_names(const Json& record) {
  if (!record.contains("methods")) return method_names_in(record.at("counts"));
  Json names = Json::array();
  for (const Json& m : record["methods"]) names.push_back(m.at("name"));
  return names;
}

Line relations_line(std::size_t run, const std::string& method, const std::string& fmt, std::uint64_t asked,
                    std::uint64_t broken) {
  return {.run = run,
          .method = method,
          .level = broken > 0 ? Level::relations : Level::nothing,
          .fmt = fmt,
          .text = method +
                  (broken > 0 ? ": breaks relations between answers, " : ": breaks no relation between answers, ") +
                  share_in_words(broken, asked) + " in " + fmt,
          .detail = "answers that must agree whatever is right: no oracle was asked",
          .wrong = broken,
          .judged = asked};
}

/// The families to name: none if they are those that are asked when none is named. Those of files have options of
/// their own.
Json families_to_name(const Json& families) {
  Json names = Json::array();
  for (const Json& n : families) {
    if (!n.get<std::string>().starts_with("own-")) names.push_back(n);
  }
  const bool usual = std::ranges::equal(names, families_of(Operands::triangles),
                                        [](const Json& n, const Family& f) { return n == f.name; });
  return usual ? Json::array() : names;
}

/// The command that writes the same record, but for plugins and threads, which it does not hold. Null if the record
/// does not say which families were asked, or they are of what came through a pipe.
Json command_for(const Run& run, bool relations) {
  const Json& r = run.record;
  if (!r.contains("families")) return Json();
  std::vector<std::string> words{"fuzz"};
  if (relations) words.push_back("--relations");
  words.insert(words.end(), {"--method", joined(run.page["methods"])});
  if (const Json names = families_to_name(r["families"]); !names.empty()) {
    words.insert(words.end(), {"--family", joined(names)});
  }
  for (const Json& file : r.value("data", Json::array())) {
    const std::string family = file.value("family", ""), name = file.value("file", "");
    if (name == "-") return Json();
    const char* option = family == "own-mesh" ? "--mesh" : family == "own-scene" ? "--scene" : "--cases";
    words.insert(words.end(), {option, name});
  }
  words.insert(words.end(),
               {"--seed", std::to_string(number_in(r, "seed")), "--count", std::to_string(number_in(r, "cases"))});
  if (r.value("until_first", false)) words.push_back("--until-first");
  words.insert(words.end(), {"--out", run.directory});
  return command_of(words);
}

}  // namespace

void gather_fuzz(Run& run, Gathering& g) {
  const Json& r = run.record;
  for (const Json& m : r.value("methods", Json::array())) g.add_method(m);
  run.page["methods"] = method_names(r);
  for (const Json& name : run.page["methods"]) g.add_method({{"name", name}});
  run.page["command"] = command_for(run, false);
  const bool triangles = r.contains("classes_judged");
  Sums by_slot, by_family, by_format;
  for (const Json& row : r.at("counts")) {
    const std::string method = row.at("method"), family = row.at("family"), fmt = row.at("fmt");
    const std::string slot = row.at(triangles ? "class" : "case");
    const Numbers n = numbers_of(row);
    const bool together = r["counts"].size() > most_rows && n[1] == 0 && n[3] == 0;
    by_slot.add({method, family, fmt, together ? "all others" : slot}, n);
    by_family.add({method, family, fmt}, n);
    by_format.add({method, fmt}, n);
  }
  if (by_slot.all().size() < r["counts"].size()) {
    g.leave_out(run, "of " + std::to_string(r["counts"].size()) +
                         " counts those without a wrong answer are added up, as `all others` of each family");
  }
  for (const auto& [key, n] : by_format.all()) {
    if (n[0] > n[2]) g.add(line_of(run.number, key[0], key[1], named(n)));
  }
  run.page["cases_run"] = number_in(r, "cases");
  for (const char* key : {"judged_by", "audited", "families", "classes_judged", "polygons_judged", "data",
                          "until_first", "errors", "faults"}) {
    if (r.contains(key)) run.page[key] = r[key];
  }
  run.page["slots"] = triangles ? "class" : "case";
  run.page["totals"] = totals_table(by_family).json();
  run.page["counts"] = counts_table(by_slot).json(true);
}

void gather_relations(Run& run, Gathering& g) {
  const Json& r = run.record;
  run.page["methods"] = method_names_in(r.at("relations"));
  for (const Json& name : run.page["methods"]) {
    const std::string method = g.add_method({{"name", name}});
    for (const char* fmt : {"binary64", "binary32"}) {
      std::uint64_t asked = 0, broken = 0;
      for (const Json& row : r["relations"]) {
        if (row.at("method") != name || row.at("fmt") != fmt) continue;
        asked += number_in(row, "asked");
        broken += number_in(row, "broken");
      }
      if (asked > 0) g.add(relations_line(run.number, method, fmt, asked, broken));
    }
  }
  run.page["command"] = command_for(run, true);
  run.page["relations"] = r;
}

}  // namespace tribunal
