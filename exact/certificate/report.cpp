// How a certificate is written: for programs, for people, for the terminal.
#include <algorithm>
#include <cstdio>
#include <map>

#include "exact/certificate/bounds.h"
#include "exact/certificate/certify.h"
#include "exact/classes/class_table.h"
#include "exact/harness/environment.h"

namespace tribunal {
namespace {

const char* name_of(Verdict v) {
  constexpr const char* names[] = {"not refuted", "refuted", "incomplete"};
  return names[static_cast<int>(v)];
}

std::string hex(std::uint64_t x) {
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(x));
  return text;
}

std::string percent(double rate) {
  char text[32];
  std::snprintf(text, sizeof text, rate == 0 || rate >= 0.001 ? "%.3g %%" : "%.2e %%", 100 * rate);
  return text;
}

std::string rate_of(const Count& c) {
  if (c.judged() == 0) return "-";
  return percent(static_cast<double>(c.wrong) / static_cast<double>(c.judged()));
}

Json to_json(const Count& c) { return {{"asked", c.asked}, {"wrong", c.wrong}, {"unsupported", c.unsupported}}; }

Json to_json(const ScopeResult& s) {
  return {{"set", s.name},          {"size", s.size},
          {"classes", s.classes},   {"answers_hash", hex(s.answers_hash)},
          {"complete", s.complete}, {"count", to_json(s.count)}};
}

/// Bounds hold for one stratum; the simultaneous ones for all at once (Bonferroni).
double simultaneous_alpha(const Certificate& c) { return confidence_alpha / static_cast<double>(c.strata.size()); }

Json to_json(const Certificate& c, const SampledStratum& s) {
  const Stream& stream = c.sample_plan.streams[s.stream];
  Json row;
  row["class"] = class_name(s.class_id);
  row["family"] = stream.family->name;
  row["fmt"] = name_of(stream.format);
  row["n"] = s.count.judged();
  row["k"] = s.count.wrong;
  row["unsupported"] = s.count.unsupported;
  row["judged_by"] = oracle_of(*stream.family);
  row["upper_95"] = upper_bound(s.count.wrong, s.count.judged(), confidence_alpha);
  row["upper_95_simultaneous"] = upper_bound(s.count.wrong, s.count.judged(), simultaneous_alpha(c));
  return row;
}

Json proved_json(const Certificate& c) {
  Json rows = Json::array();
  for (const ScopeResult& s : c.proved) rows.push_back(to_json(s));
  return rows;
}

Json sampled_json(const Certificate& c) {
  Json rows = Json::array();
  for (const SampledStratum& s : c.strata) {
    if (s.count.judged() > 0) rows.push_back(to_json(c, s));
  }
  return rows;
}

Json gaps_json(const Certificate& c) {
  Json rows = Json::array();
  for (const Gap& g : c.gaps) rows.push_back({{"what", g.what}, {"reason", g.reason}, {"explained", g.explained}});
  return rows;
}

Json calibration_json(const Certificate& c) {
  Json rows;
  for (std::size_t m = 1; m < c.sample_plan.methods.size(); ++m) {
    rows[c.sample_plan.methods[m].name] = to_json(total_of(c.sampled, m));
  }
  return rows;
}

/// Counts of the method under trial, by stream, and in the stream by level of its stress axis.
std::map<std::pair<std::size_t, std::size_t>, Count> by_level(const Certificate& c, std::size_t method) {
  std::map<std::pair<std::size_t, std::size_t>, Count> rows;
  c.sampled.counts.for_each([&](const Cell& cell, const Count& count) {
    if (cell.method == method && count.asked > 0) rows[{cell.stream, cell.level}] += count;
  });
  return rows;
}

std::string proved_table(const Certificate& c) {
  std::string text =
      "| set | cases | classes | wrong | outside the contract | hash of the answers |\n|---|---|---|---|---|---|\n";
  for (const ScopeResult& s : c.proved) {
    text += "| " + s.name + " | " + std::to_string(s.size) + " | " + std::to_string(s.classes) + " | " +
            std::to_string(s.count.wrong) + " | " + std::to_string(s.count.unsupported) + " | " + hex(s.answers_hash) +
            " |\n";
  }
  return text;
}

std::string sampled_table(const Certificate& c) {
  std::string text =
      "| family | format | stress | cases | wrong | rate | 95 % upper bound |\n|---|---|---|---|---|---|---|\n";
  for (const auto& [key, count] : by_level(c, 0)) {
    const Stream& stream = c.sample_plan.streams[key.first];
    const int level = stream.family->levels(stream.format)[key.second];
    text += "| " + std::string(stream.family->name) + " | " + std::string(tribunal::name_of(stream.format)) + " | " +
            std::to_string(level) + " " + std::string(stream.family->axis) + " | " + std::to_string(count.judged()) +
            " | " + std::to_string(count.wrong) + " | " + rate_of(count) + " | " +
            percent(upper_bound(count.wrong, count.judged(), confidence_alpha)) + " |\n";
  }
  return text;
}

std::string worst_classes(const Certificate& c) {
  std::vector<SampledStratum> worst;
  std::ranges::copy_if(c.strata, std::back_inserter(worst), [](const SampledStratum& s) { return s.count.wrong > 0; });
  if (worst.empty()) return "No class had a wrong answer.\n";
  std::ranges::stable_sort(worst, std::greater{}, [](const SampledStratum& s) { return s.count.wrong; });
  if (worst.size() > 20) worst.resize(20);
  std::string text = "| class | what it is | family | cases | wrong |\n|---|---|---|---|---|\n";
  for (const SampledStratum& s : worst) {
    const ClassRow& row = class_row(s.class_id);
    text += "| " + class_name(s.class_id) + " | triangle " + row.triangle + ", segment " + row.segment +
            ", meet: " + row.intersection + " " + (row.hit() ? row.touches : "") + " | " +
            tribunal::name_of(c.sample_plan.streams[s.stream]) + " | " + std::to_string(s.count.judged()) + " | " +
            std::to_string(s.count.wrong) + " |\n";
  }
  return text;
}

/// Gaps with the same reason share a line.
std::string gaps_list(const Certificate& c) {
  std::map<std::string, std::vector<std::string>> by_reason;
  for (const Gap& g : c.gaps) by_reason[(g.explained ? "" : "UNEXPLAINED: ") + g.reason].push_back(g.what);
  std::string text;
  for (const auto& [reason, what] : by_reason) {
    text += "- " + reason + " (" + std::to_string(what.size()) + "): " + what.front();
    for (std::size_t i = 1; i < std::min<std::size_t>(what.size(), 6); ++i) text += ", " + what[i];
    text += what.size() > 6 ? ", ... (all in certificate.json)\n" : "\n";
  }
  return text +
         "- Rays (unless among your own cases), polygons, and every input that is not drawn from the populations "
         "above.\n";
}

std::string calibration_list(const Certificate& c) {
  std::string text;
  for (std::size_t m = 1; m < c.sample_plan.methods.size(); ++m) {
    const Count count = total_of(c.sampled, m);
    text += "- " + c.sample_plan.methods[m].name + ": " + std::to_string(count.wrong) + " wrong of " +
            std::to_string(count.judged()) + " (" + rate_of(count) + ")\n";
  }
  return text;
}

std::string environment_list() {
  const Json made_with = environment();
  std::string text;
  for (const auto& item : made_with.items()) text += "- " + item.key() + ": " + item.value().get<std::string>() + "\n";
  return text;
}

}  // namespace

Json to_json(const CertifyPlan& plan, const Certificate& c) {
  Json object;
  object["method"] = plan.method.name;
  object["convention"] = tribunal::name_of(plan.method.convention);
  object["contract"] = plan.method.contract;
  object["budget"] = plan.budget.name;
  object["seed"] = plan.seed;
  object["verdict"] = name_of(c.verdict);
  object["proved"] = proved_json(c);
  object["sampled"] = sampled_json(c);
  object["own_cases"] = to_json(c.own_cases);
  object["not_covered"] = gaps_json(c);
  object["calibration"] = calibration_json(c);
  object["counterexamples"] = c.counterexamples.size();
  object["environment"] = environment();
  return object;
}

std::string to_markdown(const CertifyPlan& plan, const Certificate& c) {
  std::string text = "# " + plan.method.name + ": " + name_of(c.verdict) + "\n\n";
  text += "Contract: " + plan.method.contract +
          ". Convention: " + std::string(tribunal::name_of(plan.method.convention)) + ". Budget " + plan.budget.name +
          ", seed " + std::to_string(plan.seed) + ".\n\n";
  text += "## Proved: sets run whole\n\n" + proved_table(c) + "\n";
  text +=
      "## Sampled\n\nThe bounds are one-sided Clopper-Pearson bounds and speak of cases of these generators only. "
      "Bounds for each class, pointwise and simultaneous, are in `certificate.json`.\n\n" +
      sampled_table(c) + "\nWhere it was wrong:\n\n" + worst_classes(c) + "\n";
  if (c.own_cases.asked > 0) {
    text += "## Your own cases\n\n" + std::to_string(c.own_cases.wrong) + " wrong of " +
            std::to_string(c.own_cases.judged()) + " judged; " + std::to_string(c.own_cases.unsupported) +
            " outside the contract.\n\n";
  }
  text += "## Not covered\n\n" + gaps_list(c) + "\n";
  text += "## Calibration\n\nThe same sample must make naive arithmetic fail:\n\n" + calibration_list(c) + "\n";
  text += "## Environment\n\n" + environment_list();
  return text;
}

std::string to_summary(const CertifyPlan& plan, const Certificate& c) {
  std::string text = plan.method.name + ": " + name_of(c.verdict) + "\n";
  for (const ScopeResult& s : c.proved) {
    text += "  proved   " + s.name + ": " + std::to_string(s.count.wrong) + " wrong of " +
            std::to_string(s.count.judged()) + ", " + std::to_string(s.classes) + " classes\n";
  }
  const Count sampled = total_of(c.sampled, 0);
  text += "  sampled  " + std::to_string(sampled.wrong) + " wrong of " + std::to_string(sampled.judged()) + " (" +
          rate_of(sampled) + "), 95 % upper bound " +
          percent(upper_bound(sampled.wrong, sampled.judged(), confidence_alpha)) + " on these generators\n";
  if (c.own_cases.asked > 0) {
    text +=
        "  own      " + std::to_string(c.own_cases.wrong) + " wrong of " + std::to_string(c.own_cases.judged()) + "\n";
  }
  for (const Gap& g : c.gaps) {
    if (!g.explained) text += "  HOLE     " + g.what + ": " + g.reason + "\n";
  }
  return text;
}

}  // namespace tribunal
