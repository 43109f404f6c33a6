// What `certify` and `judge` wrote: certificate.json and counterexamples.jsonl.
#include <algorithm>
#include <map>

#include "exact/certificate/rate.h"
#include "exact/report/gathering.h"
#include "exact/report/shapes.h"
#include "exact/report/table.h"

namespace tribunal {
namespace {

constexpr std::size_t most_texts = 40;

/// Gaps with one reason are one entry: unexplained ones first, and of each reason the first few strata by name.
Json grouped(const std::vector<Record>& gaps) {
  struct Group {
    std::size_t strata = 0;
    std::vector<std::string> what{};
  };
  std::map<std::pair<bool, std::string>, std::size_t> index;
  std::vector<Group> groups;
  for (const bool explained : {false, true}) {
    for (const Record& gap : gaps) {
      if (gap.truth_or("explained", false) != explained) continue;
      const auto [at, is_new] = index.emplace(std::pair(explained, gap.text_or("reason", "")), groups.size());
      if (is_new) groups.emplace_back();
      Group& group = groups[at->second];
      ++group.strata;
      if (group.what.size() < most_texts) group.what.push_back(gap.text_or("what", ""));
    }
  }
  std::vector<Json> rows(groups.size());
  for (const auto& [key, at] : index) {
    rows[at] = {
        {"reason", key.second}, {"explained", key.first}, {"strata", groups[at].strata}, {"what", groups[at].what}};
  }
  return rows;
}

/// What was judged and wrong in one format.
struct Sum {
  std::string fmt;
  Figures figures{};
};

/// Of the sampled rows, or of the user's own cases: the sum of each format. The two are never added up: nothing can be
/// estimated from cases that somebody chose.
std::vector<Sum> sums_of(const std::vector<Record>& rows) {
  std::map<std::string, Figures> sums;
  for (const Record& row : rows) {
    Figures& sum = sums[row.text("fmt")];
    const std::uint64_t n = number_in(row, "n"), k = number_in(row, "k");
    require_part(row, k, n, "k");
    require_part(row, n, Record::most_count - sum.judged, "n in all");
    sum.judged += n;
    sum.wrong += k;
    Figures severities;
    if (const auto severity = row.find("severity")) severities.add_severities(*severity);
    require_part(row, severities.plain + severities.boundary + severities.extreme, k, "severity");
    sum.plain += severities.plain;
    sum.boundary += severities.boundary;
    sum.extreme += severities.extreme;
  }
  std::vector<Sum> all;
  for (const auto& [fmt, figures] : sums) all.push_back({fmt, figures});
  return all;
}

Json to_json(const std::vector<Sum>& sums) {
  Json all = Json::array();
  for (const Sum& sum : sums) {
    const Rate rate = rate_of(sum.figures.wrong, sum.figures.judged);
    all.push_back({{"fmt", sum.fmt},
                   {"judged", rate.judged},
                   {"wrong", rate.wrong},
                   {"share", rate.share},
                   {"lower", rate.lower},
                   {"upper", rate.upper},
                   {"plain", sum.figures.plain},
                   {"boundary", sum.figures.boundary},
                   {"extreme", sum.figures.extreme}});
  }
  return all;
}

/// Cases or a mesh of the user's own, whose files the record does not name.
bool has_own_files(const Record& r) {
  const auto is_own = [](const Record& stream) { return stream.text_or("family", "").starts_with("own-"); };
  return r.has("own_cases") || std::ranges::any_of(r.items_or_none("streams"), is_own);
}

/// The worst that the certificate says: of samples, own cases and whole sets. Wrong on a whole set of small integers,
/// and nothing said of how bad, is a boundary at worst: the sets are degenerate in every way.
Level level_of(const Record& r, const std::vector<Sum>& sums) {
  if (r.text_or("verdict", "") == "incomplete") return Level::incomplete;
  if (r.text_or("verdict", "") != "refuted") return Level::nothing;
  Figures figures;
  for (const Sum& sum : sums) {
    figures.plain += sum.figures.plain;
    figures.boundary += sum.figures.boundary;
    figures.extreme += sum.figures.extreme;
  }
  for (const Record& set : r.items_or_none("proved")) {
    const auto count = set.find("count");
    if (!count) continue;
    const auto severity = count->find("severity");
    if (severity) {
      figures.add_severities(*severity);
    } else {
      figures.boundary += number_in(*count, "wrong");
    }
  }
  const Level level = worst_level(figures);
  return level == Level::nothing ? Level::relations : level;
}

/// The verdict, with the figures of the format that did worst, in the sample or on the user's own cases.
ReportLine line_of(std::size_t run, const std::string& method, const Record& r, const std::vector<Sum>& of_sample,
                   const std::vector<Sum>& of_own) {
  std::vector<Sum> sums = of_sample;
  sums.insert(sums.end(), of_own.begin(), of_own.end());
  ReportLine line{.run = run, .method = method, .level = level_of(r, sums)};
  line.text = method + ": " + r.text_or("verdict", "");
  line.detail = r.text_or("worst", "");
  if (sums.empty()) return line;
  const auto share = [](const Sum& s) { return rate_of(s.figures.wrong, s.figures.judged).share; };
  const auto worst = std::ranges::max_element(sums, {}, share);
  line.fmt = worst->fmt;
  line.wrong = worst->figures.wrong;
  line.judged = worst->figures.judged;
  for (const Sum& sum : of_own) {
    if (of_sample.empty() || sum.figures.wrong == 0 || r.has("worst")) continue;  // that says it of all
    line.detail += (line.detail.empty() ? "" : "; ") + std::string("on your own ") + sum.fmt + " cases wrong in " +
                   share_in_words(sum.figures.wrong, sum.figures.judged);
  }
  return line;
}

/// As `Gathering::add_method` wants it: what a certificate says of its method stands in its terms.
std::string add_method(Gathering& g, const Record& r) {
  Json row = {{"name", r.text("method")}, {"fmt", ""}, {"exact", false}};
  if (const auto terms = r.find("terms")) {
    row["fmt"] = terms->text_or("fmt", "");
    row["exact"] = terms->truth_or("exact", false);
  }
  for (const char* key : {"number", "convention", "contract", "reference"}) {
    if (r.has(key)) row[key] = r.text(key);
  }
  return g.add_method(Record(row, r.where()));
}

}  // namespace

void gather_certificate(Run& run, Gathering& g) {
  const Record r = run.all();
  require_certificate_record(r);
  const std::string method = add_method(g, r), budget = r.text_or("budget", "");
  run.page["methods"] = {method};
  run.page["title"] = method;
  const bool judged = budget == "the cases of a file";
  run.page["judged"] = judged;
  if (judged) {
    run.page["seed"] = Json();
    run.page["command"] = command_alone_in(run);  // one directory for each method, if the answers named several
  }
  if (!judged && !has_own_files(r)) {
    std::vector<std::string> words{"certify", "--method", method, "--budget", budget};
    if (r.has("polygons_judged")) words.push_back("--polygons");
    words.insert(words.end(), {"--seed", seed_in(r), "--out", run.directory});
    run.page["command"] = command_of(words);
  }
  const std::vector<Record> own = r.items_or_none("own_cases"), sampled = r.items_or_none("sampled");
  const std::vector<Sum> of_sample = sums_of(sampled), of_own = sums_of(own);
  run.page["sums"] = to_json(sampled.empty() ? of_own : of_sample);
  g.add(line_of(run.number, method, r, of_sample, of_own));
  Json record = run.record;
  record.erase("environment");
  record["sampled"] = r.has("sampled") ? table_of(run.record["sampled"]).json() : table_of(Json::array()).json();
  if (r.has("own_cases")) record["own_cases"] = table_of(run.record["own_cases"]).json();
  record["not_covered"] = grouped(r.items_or_none("not_covered"));
  run.page["record"] = std::move(record);
}

}  // namespace tribunal
