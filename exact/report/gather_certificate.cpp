// What `certify` and `judge` wrote: certificate.json and counterexamples.jsonl.
#include <algorithm>
#include <map>

#include "exact/certificate/rate.h"
#include "exact/report/gathering.h"
#include "exact/report/table.h"

namespace tribunal {
namespace {

constexpr std::size_t most_texts = 40;

/// Gaps with one reason are one entry: unexplained ones first, and of each reason the first few strata by name.
Json grouped(const Json& gaps) {
  Json groups = Json::array();
  std::map<std::pair<bool, std::string>, std::size_t> index;
  for (const bool explained : {false, true}) {
    for (const Json& gap : gaps) {
      if (gap.value("explained", false) != explained) continue;
      const std::string reason = gap.value("reason", "");
      const auto [at, is_new] = index.emplace(std::pair(explained, reason), groups.size());
      if (is_new) {
        groups.push_back({{"reason", reason}, {"explained", explained}, {"strata", 0}, {"what", Json::array()}});
      }
      Json& group = groups[at->second];
      group["strata"] = group["strata"].get<std::size_t>() + 1;
      if (group["what"].size() < most_texts) group["what"].push_back(gap.value("what", ""));
    }
  }
  return groups;
}

/// Of the sampled rows, or of the user's own cases: what was judged and wrong in each format. The two are never added
/// up: nothing can be estimated from cases that somebody chose.
Json sums_of(const Json& rows) {
  std::map<std::string, std::map<std::string, std::uint64_t>> sums;
  for (const Json& row : rows) {
    auto& sum = sums[row.at("fmt").get<std::string>()];
    sum["judged"] += row.value("n", std::uint64_t{0});
    sum["wrong"] += row.value("k", std::uint64_t{0});
    for (const char* severity : {"plain", "boundary", "extreme"}) {
      sum[severity] += row.value("severity", Json::object()).value(severity, std::uint64_t{0});
    }
  }
  Json all = Json::array();
  for (auto& [fmt, sum] : sums) {
    const Rate rate = rate_of(sum["wrong"], sum["judged"]);
    all.push_back({{"fmt", fmt},
                   {"judged", rate.judged},
                   {"wrong", rate.wrong},
                   {"share", rate.share},
                   {"lower", rate.lower},
                   {"upper", rate.upper},
                   {"plain", sum["plain"]},
                   {"boundary", sum["boundary"]},
                   {"extreme", sum["extreme"]}});
  }
  return all;
}

/// Cases or a mesh of the user's own, whose files the record does not name.
bool has_own_files(const Json& r) {
  const auto is_own = [](const Json& stream) { return stream.value("family", "").starts_with("own-"); };
  return r.contains("own_cases") || std::ranges::any_of(r.value("streams", Json::array()), is_own);
}

/// The worst that the certificate says: of samples, own cases and whole sets. Wrong on a whole set of small integers,
/// and nothing said of how bad, is a boundary at worst: the sets are degenerate in every way.
Level level_of(const Json& r, const std::vector<Json>& sums) {
  if (r.value("verdict", "") == "incomplete") return Level::incomplete;
  if (r.value("verdict", "") != "refuted") return Level::nothing;
  Json counts = {{"plain", 0}, {"boundary", 0}, {"extreme", 0}};
  const auto add = [&](const char* key, std::uint64_t n) { counts[key] = counts[key].get<std::uint64_t>() + n; };
  for (const Json& sum : sums) {
    for (const char* key : {"plain", "boundary", "extreme"}) add(key, sum[key].get<std::uint64_t>());
  }
  for (const Json& set : r.value("proved", Json::array())) {
    const Json count = set.value("count", Json::object());
    const Json severity = count.value("severity", Json::object());
    for (const char* key : {"plain", "boundary", "extreme"}) add(key, severity.value(key, std::uint64_t{0}));
    if (severity.empty()) add("boundary", count.value("wrong", std::uint64_t{0}));
  }
  const Level level = worst_level(counts);
  return level == Level::nothing ? Level::relations : level;
}

/// The verdict, with the figures of the format that did worst, in the sample or on the user's own cases.
Line line_of(std::size_t run, const std::string& method, const Json& r, const Json& of_sample, const Json& of_own) {
  std::vector<Json> sums(of_sample.begin(), of_sample.end());
  sums.insert(sums.end(), of_own.begin(), of_own.end());
  Line line{.run = run, .method = method, .level = level_of(r, sums)};
  line.text = method + ": " + r.value("verdict", "");
  line.detail = r.value("worst", "");
  if (sums.empty()) return line;
  const auto worst = std::ranges::max_element(sums, {}, [](const Json& s) { return s["share"].get<double>(); });
  line.fmt = (*worst)["fmt"].get<std::string>();
  line.wrong = (*worst)["wrong"].get<std::uint64_t>();
  line.judged = (*worst)["judged"].get<std::uint64_t>();
  for (const Json& sum : of_own) {
    const auto wrong = sum["wrong"].get<std::uint64_t>();
    if (of_sample.empty() || wrong == 0 || r.contains("worst")) continue;  // that says it of all
    line.detail += (line.detail.empty() ? "" : "; ") + std::string("on your own ") + sum["fmt"].get<std::string>() +
                   " cases wrong in " + share_in_words(wrong, sum["judged"].get<std::uint64_t>());
  }
  return line;
}

}  // namespace

void gather_certificate(Run& run, Gathering& g) {
  Json r = run.record;
  r["name"] = r.at("method");
  r["fmt"] = r.value("terms", Json::object()).value("fmt", "");
  r["exact"] = r.value("terms", Json::object()).value("exact", false);
  const std::string method = g.add_method(r);
  run.page["methods"] = {method};
  run.page["title"] = method;
  const bool judged = r.value("budget", "") == "the cases of a file";
  run.page["judged"] = judged;
  if (judged) run.page["seed"] = Json();
  if (!judged && !has_own_files(r)) {
    std::vector<std::string> words{"certify", "--method", method, "--budget", r.value("budget", "")};
    if (r.contains("polygons_judged")) words.push_back("--polygons");
    words.insert(words.end(), {"--seed", std::to_string(r.value("seed", std::uint64_t{0})), "--out", run.directory});
    run.page["command"] = command_of(words);
  }
  const Json own = r.value("own_cases", Json::array()), sampled = r.value("sampled", Json::array());
  const Json of_sample = sums_of(sampled), of_own = sums_of(own);
  run.page["sums"] = sampled.empty() ? of_own : of_sample;
  g.add(line_of(run.number, method, r, of_sample, of_own));
  for (const char* key : {"name", "fmt", "exact", "environment"}) r.erase(key);
  r["sampled"] = table_of(sampled).json();
  if (r.contains("own_cases")) r["own_cases"] = table_of(own).json();
  r["not_covered"] = grouped(r.value("not_covered", Json::array()));
  run.page["record"] = std::move(r);
}

}  // namespace tribunal
