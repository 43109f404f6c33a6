// What `fuzz` wrote: summary.json and counterexamples.jsonl, or relations.json and witnesses.jsonl.
#include <algorithm>
#include <array>
#include <map>

#include "exact/cases/family_table.h"
#include "exact/certificate/rate.h"
#include "exact/report/gathering.h"
#include "exact/report/shapes.h"
#include "exact/report/table.h"

namespace tribunal {
namespace {

/// More rows than these make a page heavy: rows without a wrong answer are then added up.
constexpr std::size_t most_rows = 120'000;

/// A count as a row of the tables has it: the numbers of a row of summary.json, in this order.
constexpr std::array numbers = {"asked", "wrong", "unsupported", "refused", "false hit",  "false miss", "wrong contact",
                                "fault", "plain", "boundary",    "extreme", "twin asked", "logic",      "rounding"};
using Numbers = std::array<std::uint64_t, numbers.size()>;

Numbers numbers_of(const Record& row) {
  const Numbers n = {number_in(row, "asked"),
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
  require_part(row, n[2], n[0], "unsupported");
  require_part(row, n[1], n[0] - n[2], "wrong");
  require_part(row, n[3], n[2], "refused");
  require_part(row, n[4] + n[5] + n[6] + n[7], n[1], "outcomes");
  require_part(row, n[8] + n[9] + n[10], n[1], "severity");
  require_part(row, n[11], n[1], "cause");
  require_part(row, n[12] + n[13], n[11], "cause");
  return n;
}

Numbers& operator+=(Numbers& sum, const Numbers& other) {
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += other[i];
  return sum;
}

Figures figures_of(const Numbers& n) {
  return {.judged = n[0] - n[2], .wrong = n[1], .plain = n[8], .boundary = n[9], .extreme = n[10], .fault = n[7]};
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

/// Methods in the order of the record, which older ones do not say: then that of their counts.
std::vector<std::string> method_names(const Record& r) {
  return r.has("methods") ? names_in(r.items("methods"), "name") : names_in(r.items("counts"), "method");
}

ReportLine relations_line(std::size_t run, const std::string& method, const std::string& fmt, std::uint64_t asked,
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
std::vector<std::string> families_to_name(const std::vector<Record>& families) {
  std::vector<std::string> names;
  for (const Record& family : families) {
    if (const std::string name = family.text(); !name.starts_with("own-")) names.push_back(name);
  }
  const bool usual = std::ranges::equal(names, families_of(Operands::triangles),
                                        [](const std::string& n, const Family& f) { return n == f.name; });
  return usual ? std::vector<std::string>{} : names;
}

/// The command that writes the same record, but for plugins and threads, which it does not hold. Null if the record
/// does not say which families were asked, or they are of what came through a pipe.
Json command_for(const Run& run, const std::vector<std::string>& methods, bool relations) {
  const Record r = run.all();
  const std::vector<Record> files = r.items_or_none("data");
  if (!r.has("families")) return Json();
  std::vector<std::string> words{"fuzz"};
  if (relations) words.push_back("--relations");
  words.insert(words.end(), {"--method", joined(methods)});
  if (const std::vector<std::string> names = families_to_name(r.items("families")); !names.empty()) {
    words.insert(words.end(), {"--family", joined(names)});
  }
  for (const Record& file : files) {
    const std::string family = file.text("family"), name = file.text("file");
    if (name == "-") return Json();
    const char* option = family == "own-mesh" ? "--mesh" : family == "own-scene" ? "--scene" : "--cases";
    words.insert(words.end(), {option, name});
  }
  words.insert(words.end(), {"--seed", seed_in(r), "--count", std::to_string(number_in(r, "cases"))});
  if (r.truth_or("until_first", false)) words.push_back("--until-first");
  words.insert(words.end(), {"--out", run.directory});
  return command_of(words);
}

/// No more cases of a method than the run had: every row is about some of them.
void require_within_run(const Record& r, const std::map<std::string, std::uint64_t>& asked) {
  if (!r.has("cases")) return;
  for (const auto& [method, n] : asked) require_part(r, n, number_in(r, "cases"), (method + " was asked more").c_str());
}

}  // namespace

void gather_fuzz(Run& run, Gathering& g) {
  const Record r = run.all();
  require_fuzz_record(r);
  for (const Record& m : r.items_or_none("methods")) g.add_method(m);
  const std::vector<std::string> methods = method_names(r);
  for (const std::string& name : methods) g.add_method(name);
  run.page["methods"] = methods;
  run.page["command"] = command_for(run, methods, false);
  const bool triangles = r.has("classes_judged");
  const std::vector<Record> rows = r.items("counts");
  Sums by_slot, by_family, by_format;
  std::map<std::string, std::uint64_t> asked;
  for (const Record& row : rows) {
    const std::string method = row.text("method"), family = row.text("family"), fmt = row.text("fmt");
    const std::string slot = row.text(triangles ? "class" : "case");
    const Numbers n = numbers_of(row);
    require_part(row, n[0], Record::most_count - asked[method], "asked in all");
    asked[method] += n[0];
    const bool together = rows.size() > most_rows && n[1] == 0 && n[3] == 0;
    by_slot.add({method, family, fmt, together ? "all others" : slot}, n);
    by_family.add({method, family, fmt}, n);
    by_format.add({method, fmt}, n);
  }
  require_within_run(r, asked);
  if (by_slot.all().size() < rows.size()) {
    g.leave_out(run, "of " + std::to_string(rows.size()) +
                         " counts those without a wrong answer are added up, as `all others` of each family");
  }
  for (const auto& [key, n] : by_format.all()) {
    if (n[0] > n[2]) g.add(line_of(run.number, key[0], key[1], figures_of(n)));
  }
  run.page["cases_run"] = number_in(r, "cases");
  for (const Record& name : r.items_or_none("families")) name.text();
  for (const char* key : {"judged_by", "audited", "families", "classes_judged", "polygons_judged", "data",
                          "until_first", "errors", "faults"}) {
    if (r.has(key)) run.page[key] = r.json()[key];
  }
  run.page["slots"] = triangles ? "class" : "case";
  run.page["totals"] = totals_table(by_family).json();
  run.page["counts"] = counts_table(by_slot).json(true);
}

void gather_relations(Run& run, Gathering& g) {
  const Record r = run.all();
  require_relations_record(r);
  const std::vector<Record> rows = r.items("relations");
  const std::vector<std::string> methods = names_in(rows, "method");
  run.page["methods"] = methods;
  for (const std::string& method : methods) {
    g.add_method(method);
    for (const char* fmt : {"binary64", "binary32"}) {
      std::uint64_t asked = 0, broken = 0;
      for (const Record& row : rows) {
        if (row.text("method") != method || row.text("fmt") != fmt) continue;
        const std::uint64_t n = number_in(row, "asked"), k = number_in(row, "broken");
        require_part(row, k, n, "broken");
        require_part(row, n, Record::most_count - asked, "asked in all");
        asked += n;
        broken += k;
      }
      if (asked > 0) g.add(relations_line(run.number, method, fmt, asked, broken));
    }
  }
  run.page["command"] = command_for(run, methods, true);
  run.page["relations"] = run.record;
}

}  // namespace tribunal
