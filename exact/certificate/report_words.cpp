// Counts and shares in words, as all writers of a certificate have them.
#include <algorithm>
#include <cstdio>
#include <iterator>

#include "exact/base/foreign_json.h"
#include "exact/certificate/rate.h"
#include "exact/certificate/report_parts.h"

namespace tribunal {

Certificate with_texts(const Certificate& c, std::string (*door)(std::string_view)) {
  Certificate shown = c;
  shown.plan = with_strings(c.plan, door);
  shown.environment = with_strings(c.environment, door);
  shown.log_head = door(c.log_head);
  for (ProvedSet& s : shown.proved) {
    for (std::string* text : {&s.name, &s.oracles, &s.answers_hash}) *text = door(*text);
  }
  for (RelationRow& r : shown.relations) {
    for (std::string* text : {&r.name, &r.statement}) *text = door(*text);
  }
  for (ErrorRow& e : shown.errors) e.family = door(e.family);
  for (NonfiniteRow& r : shown.nonfinite) r.first = door(r.first);
  for (SampledStream& s : shown.streams) {
    for (std::string* text : {&s.family, &s.axis, &s.population, &s.judged_by}) *text = door(*text);
  }
  for (SampleRow& r : shown.rows) {
    for (std::string* text : {&r.method, &r.family}) *text = door(*text);
  }
  for (Gap& g : shown.gaps) {
    for (std::string* text : {&g.what, &g.reason}) *text = door(*text);
  }
  shown.calibration.clear();
  for (const auto& [method, counts] : c.calibration) shown.calibration[door(method)] = counts;
  shown.faults.clear();
  for (const auto& [fault, n] : c.faults) shown.faults[door(fault)] += n;
  return shown;
}

std::string in_words(const NonfiniteRow& row) {
  const std::string answered =
      row.answered == 0 ? "" : "; " + std::to_string(row.answered) + " ANSWERED, the first is " + row.first;
  return std::string(name_of(row.format)) + ": " + std::to_string(row.refused) + " of " + std::to_string(row.asked) +
         " refused" + answered;
}

std::string rate_in_words(const Count& c) {
  if (c.judged() == 0) return "-";
  return percent(static_cast<double>(c.wrong) / static_cast<double>(c.judged()));
}

const char* classes_word(const Certificate& c) { return c.operands() == Operands::triangles ? "classes" : "outcomes"; }

std::string after_semicolon(const std::string& text) { return text.empty() ? "" : "; " + text; }

namespace {

std::string judged_of(const Count& count) {
  return std::to_string(count.wrong) + " wrong of " + std::to_string(count.judged()) + " (" + rate_in_words(count) +
         ")" + (count.not_owed() == 0 ? "" : "; " + std::to_string(count.not_owed()) + " outside the contract");
}

}  // namespace

std::string wrong_of(const Count& count) {
  return judged_of(count) + (count.refused == 0 ? "" : "; " + std::to_string(count.refused) + " refused");
}

std::string with_breakdown(const Count& count) { return judged_of(count) + after_semicolon(breakdown(count)); }

Count total_of(const Certificate& c, std::size_t stream) {
  Count total;
  for (const Stratum& s : c.strata) {
    if (s.stream == stream) total += s.count;
  }
  return total;
}

std::string coverage_text(const Certificate& c) {
  return c.coverage.to_text(c.stages, [&](Stage stage) { return c.word_of(stage); });
}

std::string fault_lines(const Certificate& c, const std::string& before) {
  std::string text;
  for (const auto& [fault, n] : c.faults) {
    text += before + fault + ", in " + std::to_string(n) + " of the counterexamples\n";
  }
  return text;
}

std::vector<Stratum> worst_of(const Certificate& c, std::size_t most,
                              const std::function<bool(const Stratum&)>& among) {
  std::vector<Stratum> worst;
  std::ranges::copy_if(c.strata, std::back_inserter(worst),
                       [&](const Stratum& s) { return s.count.wrong > 0 && among(s); });
  std::ranges::stable_sort(worst, std::greater{}, [](const Stratum& s) { return s.count.wrong; });
  if (worst.size() > most) worst.resize(most);
  return worst;
}

}  // namespace tribunal
