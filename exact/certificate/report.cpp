// Writes a certificate as Markdown.
#include <map>

#include "exact/base/shown.h"
#include "exact/certificate/bounds.h"
#include "exact/certificate/rate.h"
#include "exact/certificate/report_parts.h"

namespace tribunal {
namespace {

/// One more cell of a row of a table, which older logs have not: what the wrong answers are.
std::string outcomes_head(const Certificate& c) { return c.says_outcomes() ? " of the wrong |\n" : "\n"; }
std::string outcomes_rule(const Certificate& c) { return c.says_outcomes() ? "---|\n" : "\n"; }
std::string outcomes_cell(const Certificate& c, const Count& count) {
  return c.says_outcomes() ? " " + breakdown(count) + " |\n" : "\n";
}

std::string proved_table(const Certificate& c) {
  std::string text = "| set | probes | cases | " + std::string(classes_word(c)) +
                     " | wrong | outside the contract | hash of the answers | judged by |" + outcomes_head(c) +
                     "|---|---|---|---|---|---|---|---|" + outcomes_rule(c);
  for (const ProvedSet& s : c.proved) {
    text += "| " + s.name + " | " + probes_word(s.of_rays) + "s | " + std::to_string(s.size) + " | " +
            std::to_string(s.classes) + " | " + std::to_string(s.count.wrong) + " | " +
            std::to_string(s.count.not_owed()) + " | " + s.answers_hash + " | " + s.oracles + " |" +
            outcomes_cell(c, s.count);
  }
  return text;
}

/// For example "17 bits of the map's entries"; empty for a stream without a stress axis.
std::string stress_of(const Certificate& c, const SampleRow& row) {
  for (const SampledStream& s : c.streams) {
    if (s.family != row.family || s.format != row.format) continue;
    return s.axis == "(none)" || s.axis.empty() ? "" : std::to_string(row.stress) + " " + s.axis;
  }
  return "";
}

std::string sampled_table(const Certificate& c) {
  std::string text = "| family | format | probes | stress | cases | wrong | rate | 95 % upper bound |" +
                     outcomes_head(c) + "|---|---|---|---|---|---|---|---|" + outcomes_rule(c);
  for (const SampleRow& row : c.rows) {
    if (row.family == own_cases) continue;
    for (const bool rays : {false, true}) {
      const Count count = total_of(row, rays);
      if (count.asked == 0) continue;
      text += "| " + row.family + " | " + std::string(name_of(row.format)) + " | " + probes_word(rays) + "s | " +
              stress_of(c, row) + " | " + std::to_string(count.judged()) + " | " + std::to_string(count.wrong) + " | " +
              rate_in_words(count) + " | " + percent(upper_bound(count.wrong, count.judged(), confidence_alpha)) +
              " |" + outcomes_cell(c, count);
    }
  }
  return text;
}

/// Of the sampled strata, or of one's own cases.
std::string worst_classes(const Certificate& c, bool own) {
  const std::vector<Stratum> worst = worst_of(c, 20, [&](const Stratum& s) { return c.is_own(s) == own; });
  if (worst.empty()) return c.operands() == Operands::triangles ? "No class had a wrong answer.\n" : "Nowhere.\n";
  std::string text =
      "| class | what it is | family | cases | wrong |" + outcomes_head(c) + "|---|---|---|---|---|" + outcomes_rule(c);
  for (const Stratum& s : worst) {
    const SampledStream& stream = c.streams[s.stream];
    text += "| " + slot_name(s.slot) + " | " + slot_description(s.slot) + " | " + stream.family + " " +
            std::string(name_of(stream.format)) + " | " + std::to_string(s.count.judged()) + " | " +
            std::to_string(s.count.wrong) + " |" + outcomes_cell(c, s.count);
  }
  return text;
}

std::string stages_line(const Certificate& c, const std::string& title, const Count& total) {
  std::string text = title;
  for (const Stage stage : c.stages) {
    const double share =
        total.judged() == 0 ? 0 : static_cast<double>(total.at(stage)) / static_cast<double>(total.judged());
    text += " " + c.word_of(stage) + " " + std::to_string(total.at(stage)) + " (" + percent(share) + ")";
  }
  return text + ".\n\n";
}

std::string stages_table(const Certificate& c) {
  if (c.stages.empty()) return "";
  if (!c.says_outcomes()) return stages_line(c, "Answers by stage:", c.sampled());
  std::string text;
  for (const Format format : both_formats) {
    text += stages_line(c, "Answers by stage, " + std::string(name_of(format)) + ":", c.sampled(format));
  }
  return text;
}

std::string populations(const Certificate& c) {
  std::string text;
  for (const SampledStream& s : c.streams) {
    if (!s.taken || s.is_own()) continue;
    text += "- " + s.family + " " + std::string(name_of(s.format)) + ": " + std::to_string(s.cases) + " of " +
            s.population + "; judged by " + s.judged_by + "\n";
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
  return text + "- Every input that is not drawn from the populations above; " +
         (c.coverage.has(Operands::polygons) ? "triangles that are asked as such.\n"
                                             : "polygons with more than three vertices.\n");
}

std::string calibration_line(const std::string& what, const Count& count) {
  return "- " + what + ": " + std::to_string(count.wrong) + " wrong of " + std::to_string(count.judged()) + " (" +
         rate_in_words(count) + ")\n";
}

std::string calibration_list(const Certificate& c) {
  if (c.calibration.empty()) return "None: the cases are not ours.\n";
  std::string text = "The same sample must make naive arithmetic fail:\n\n";
  for (const auto& [method, counts] : c.calibration) {
    if (!c.says_outcomes()) text += calibration_line(method, counts.total());
    for (const Format format : both_formats) {
      if (!c.says_outcomes() || counts.of(format).asked == 0) continue;
      text += calibration_line(method + ", " + std::string(name_of(format)), counts.of(format));
    }
  }
  return text;
}

std::string environment_list(const Certificate& c) {
  std::string text;
  const Json made_with = environment_json(c);
  for (const auto& [key, value] : Record(made_with, {"log.jsonl"}).members())
    text += "- " + key + ": " + value.text() + "\n";
  return text;
}

std::string sampled_section(const Certificate& c) {
  return "## Sampled\n\nThe bounds are one-sided Clopper-Pearson bounds and speak of cases of these populations under "
         "this seed only. Bounds for each " +
         std::string(c.operands() == Operands::triangles ? "class" : "construction and outcome") +
         ", pointwise and simultaneous (Bonferroni over " + std::to_string(c.sampled_strata()) +
         " strata), are in `certificate.json`.\n\n" + stages_table(c) + sampled_table(c) + "\nWhere it was wrong:\n\n" +
         worst_classes(c, false) + "\nPopulations:\n\n" + populations(c) + "\n";
}

std::string own_section(const Certificate& c) {
  std::string text = "## Your own cases\n\nThey are themselves and no sample: no bound follows from them.\n\n";
  for (std::size_t i = 0; i < c.streams.size(); ++i) {
    const SampledStream& s = c.streams[i];
    if (!s.is_own()) continue;
    text += "- " + std::string(name_of(s.format)) + ": " +
            (c.says_outcomes() ? with_breakdown(total_of(c, i)) : wrong_of(total_of(c, i))) + "; judged by " +
            s.judged_by + "\n";
  }
  return text + "\nWhere it was wrong:\n\n" + worst_classes(c, true) + "\n";
}

std::string nonfinite_section(const Certificate& c) {
  std::string text =
      "## Your cases with numbers that are not finite\n\nThey have no answer, and are to be refused.\n\n";
  for (const NonfiniteRow& row : c.nonfinite) text += "- " + in_words(row) + "\n";
  return text + "\n";
}

const char* coverage_word(const Certificate& c) { return c.coverage.has(Operands::polygons) ? "Polygons" : "Classes"; }

std::string markdown_of(const Certificate& c) {
  std::string text =
      "# " + c.method() + ": " + name_of(c.verdict) + (c.says_outcomes() ? "; " + c.worst() : "") + "\n\n";
  text += "Contract: " + in_words(c.contract) + ". Convention: " + std::string(name_of(c.contract.convention)) +
          ". Budget " + Record(c.plan, {"log.jsonl"}).text("budget") + ", seed " + std::to_string(c.seed()) + ". " +
          coverage_word(c) + " judged: " + coverage_text(c) + ".\n\n";
  if (!c.faults.empty()) text += "It is no function of its input, or fails:\n\n" + fault_lines(c, "- ") + "\n";
  if (!c.proved.empty()) text += "## Proved: sets run whole\n\n" + proved_table(c) + "\n";
  if (!c.relations.empty()) text += relations_section(c);
  if (c.sampled_strata() > 0) text += sampled_section(c);
  if (!c.errors.empty()) text += errors_section(c);
  if (c.has_own()) text += own_section(c);
  if (!c.nonfinite.empty()) text += nonfinite_section(c);
  text += "## Not covered\n\n" + gaps_list(c) + "\n";
  text += "## Calibration\n\n" + calibration_list(c) + "\n";
  text += "## Environment\n\n" + environment_list(c);
  return text + "\nEvery number above follows from `log.jsonl` (sha256 of its chain: " + c.log_head +
         "); `tribunal verify` makes them again.\n";
}

}  // namespace

std::string to_markdown(const Certificate& c) { return markdown_of(with_texts(c, in_markdown)); }

}  // namespace tribunal
