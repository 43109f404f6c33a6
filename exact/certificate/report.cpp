// Writes a certificate as Markdown, and as a summary for the terminal.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>

#include "exact/cases/families/aimed.h"
#include "exact/certificate/bounds.h"
#include "exact/certificate/report_parts.h"

namespace tribunal {
namespace {

std::string percent(double rate) {
  char text[32];
  std::snprintf(text, sizeof text, rate == 0 || rate >= 0.001 ? "%.3g %%" : "%.2e %%", 100 * rate);
  return text;
}

std::string rate_of(const Count& c) {
  if (c.judged() == 0) return "-";
  return percent(static_cast<double>(c.wrong) / static_cast<double>(c.judged()));
}

/// One more cell of a row of a table, which older logs have not: what the wrong answers are.
std::string outcomes_head(const Certificate& c) { return c.says_outcomes() ? " of the wrong |\n" : "\n"; }
std::string outcomes_rule(const Certificate& c) { return c.says_outcomes() ? "---|\n" : "\n"; }
std::string outcomes_cell(const Certificate& c, const Count& count) {
  return c.says_outcomes() ? " " + breakdown(count) + " |\n" : "\n";
}

const char* classes_word(const Certificate& c) { return c.operands() == Operands::triangles ? "classes" : "outcomes"; }

std::string proved_table(const Certificate& c) {
  std::string text = "| set | probes | cases | " + std::string(classes_word(c)) +
                     " | wrong | outside the contract | hash of the answers | judged by |" + outcomes_head(c) +
                     "|---|---|---|---|---|---|---|---|" + outcomes_rule(c);
  for (const ProvedSet& s : c.proved) {
    text += "| " + s.name + " | " + probes_word(s.of_rays) + "s | " + std::to_string(s.size) + " | " +
            std::to_string(s.classes) + " | " + std::to_string(s.count.wrong) + " | " +
            std::to_string(s.count.unsupported) + " | " + s.answers_hash + " | " + s.oracles + " |" +
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
              rate_of(count) + " | " + percent(upper_bound(count.wrong, count.judged(), confidence_alpha)) + " |" +
              outcomes_cell(c, count);
    }
  }
  return text;
}

/// The strata with the most wrong answers.
std::vector<Stratum> worst_of(const Certificate& c, std::size_t most,
                              const std::function<bool(const Stratum&)>& among) {
  std::vector<Stratum> worst;
  std::ranges::copy_if(c.strata, std::back_inserter(worst),
                       [&](const Stratum& s) { return s.count.wrong > 0 && among(s); });
  std::ranges::stable_sort(worst, std::greater{}, [](const Stratum& s) { return s.count.wrong; });
  if (worst.size() > most) worst.resize(most);
  return worst;
}

std::string worst_line(const Certificate& c) {
  std::string text;
  for (const Stratum& s : worst_of(c, 5, [](const Stratum&) { return true; })) {
    text += (text.empty() ? "  most in  " : ", ") + slot_name(s.slot) + " " + c.streams[s.stream].family + " " +
            std::string(name_of(c.streams[s.stream].format)) + " " + std::to_string(s.count.wrong) + "/" +
            std::to_string(s.count.judged());
  }
  return text.empty() ? "" : text + "\n";
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

std::string coverage_text(const Certificate& c) {
  return c.coverage.to_text(c.stages, [&](Stage stage) { return c.word_of(stage); });
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
         rate_of(count) + ")\n";
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
  for (const auto& item : made_with.items()) text += "- " + item.key() + ": " + item.value().get<std::string>() + "\n";
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

std::string rate_of(const RelationRow& r) {
  return percent(static_cast<double>(r.broken) / static_cast<double>(r.asked));
}

std::string interval_of(const RelationRow& r) {
  return percent(lower_bound(r.broken, r.asked, confidence_alpha)) + " to " +
         percent(upper_bound(r.broken, r.asked, confidence_alpha));
}

/// "binary64, segments"
std::string population_of(const RelationRow& r) {
  return std::string(name_of(r.format)) + ", " + probes_word(r.of_rays) + "s";
}

/// The rows of which anything was asked, broken ones or the others.
std::vector<RelationRow> asked_relations(const Certificate& c, bool broken) {
  std::vector<RelationRow> rows;
  std::ranges::copy_if(c.relations, std::back_inserter(rows),
                       [&](const RelationRow& r) { return r.asked > 0 && (r.broken > 0) == broken; });
  return rows;
}

std::string broken_table(const Certificate& c) {
  std::string text =
      "| relation | what must hold | population | asked | broken | rate | 95 % bounds |\n"
      "|---|---|---|---|---|---|---|\n";
  for (const RelationRow& r : asked_relations(c, true)) {
    text += "| " + r.name + " | " + r.statement + " | " + population_of(r) + " | " + std::to_string(r.asked) + " | " +
            std::to_string(r.broken) + " | " + rate_of(r) + " | " + interval_of(r) + " |\n";
  }
  return text + "\n";
}

/// Those that held, one line each, with the number of instances of each population.
std::string kept_list(const Certificate& c) {
  std::map<std::string, std::string> lines;
  for (const RelationRow& r : asked_relations(c, false)) {
    std::string& line = lines[r.name];
    line += (line.empty() ? r.statement + ": held in all of " : "; ") + std::to_string(r.asked) + " (" +
            population_of(r) + ")";
  }
  std::string text;
  for (const auto& [name, line] : lines) text += "- " + name + ": " + line + "\n";
  return text + (lines.empty() ? "" : "\n");
}

std::string relations_section(const Certificate& c) {
  return "## Relations\n\nWhat must hold between answers, whatever they are; no oracle is asked. Checked on the first "
         "cases of each population below, and of triangles on the ray through each segment too. One relation broken "
         "refutes; the queries that show it are in `certificate.json`, and one of their answers, shrunk, is among the "
         "counterexamples. The bounds are one-sided, at 95 % each.\n\n" +
         (c.broken_relations().empty() ? "" : broken_table(c)) + kept_list(c);
}

/// One line for each relation broken, with the populations in which it was.
std::string broken_lines(const Certificate& c) {
  std::string text, last;
  for (const RelationRow& r : asked_relations(c, true)) {
    const std::string counts =
        population_of(r) + ": " + std::to_string(r.broken) + " of " + std::to_string(r.asked) + " (" + rate_of(r) + ")";
    text += r.name == last ? "; " + counts : (last.empty() ? "" : "\n") + ("  BROKEN   " + r.name + ", " + counts);
    last = r.name;
  }
  return text.empty() ? "" : text + "\n";
}

/// One line a population, and one for each relation broken.
std::string relation_lines(const Certificate& c) {
  std::map<std::string, std::pair<std::uint64_t, std::uint64_t>> totals;
  for (const RelationRow& r : asked_relations(c, false)) totals[population_of(r)].first += r.asked;
  for (const RelationRow& r : asked_relations(c, true)) {
    auto& [asked, broken] = totals[population_of(r)];
    asked += r.asked;
    broken += r.broken;
  }
  std::string text;
  for (const auto& [population, total] : totals) {
    text += "  related  " + population + ": " + std::to_string(total.second) + " of " + std::to_string(total.first) +
            " instances of relations broken\n";
  }
  return text + broken_lines(c);
}

std::string errors_row(const ErrorRow& e, const char* what, const Ulps& u) {
  if (u.all() == 0) return "";
  return "| " + e.family + " | " + std::string(name_of(e.format)) + " | " + what + " | " +
         std::to_string(e.errors.hits) + " | " + in_words(u) + " |\n";
}

std::string errors_section(const Certificate& c) {
  std::string text =
      "## Errors of t and of the weights\n\nOf right hits of rays at one point, against the exact value, in units in "
      "the last place of it in " +
      std::string(name_of(c.contract.format)) +
      ". How ill-conditioned the problem is, is not divided out. Of the sampled cases one in " +
      std::to_string(measured_period) +
      ", drawn by a hash.\n\n| family | cases | number | hits | errors |\n|---|---|---|---|---|\n";
  for (const ErrorRow& e : c.errors) {
    text += errors_row(e, "t", e.errors.t) + errors_row(e, "weights", e.errors.weights);
  }
  return text + "\n";
}

/// The errors of one number in all families of a format, and where the largest is.
std::string errors_line(const Certificate& c, Format format, const char* what, Ulps HitErrors::*number) {
  Ulps total;
  std::string worst;
  for (const ErrorRow& e : c.errors) {
    if (e.format != format) continue;
    const Ulps& u = e.errors.*number;
    if (u.most > total.most) worst = "; the most in " + e.family;
    total += u;
  }
  return total.all() == 0 ? ""
                          : "  ulps     " + std::string(what) + ", " + std::string(name_of(format)) + ": " +
                                in_words(total) + worst + "\n";
}

std::string errors_lines(const Certificate& c) {
  std::string text;
  for (const Format format : both_formats) {
    text += errors_line(c, format, "t", &HitErrors::t) + errors_line(c, format, "weights", &HitErrors::weights);
  }
  return text;
}

std::string after_semicolon(const std::string& text) { return text.empty() ? "" : "; " + text; }

/// "1 wrong of 12 (8.33 %); 3 outside the contract"
std::string wrong_of(const Count& count) {
  return std::to_string(count.wrong) + " wrong of " + std::to_string(count.judged()) + " (" + rate_of(count) + ")" +
         (count.unsupported == 0 ? "" : "; " + std::to_string(count.unsupported) + " outside the contract");
}

/// The same, and what the wrong answers are.
std::string with_breakdown(const Count& count) { return wrong_of(count) + after_semicolon(breakdown(count)); }

Count total_of(const Certificate& c, std::size_t stream) {
  Count total;
  for (const Stratum& s : c.strata) {
    if (s.stream == stream) total += s.count;
  }
  return total;
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

/// One line a fault, each with this before it.
std::string fault_lines(const Certificate& c, const std::string& before) {
  std::string text;
  for (const auto& [fault, n] : faults_in(c)) {
    text += before + fault + ", in " + std::to_string(n) + " of the counterexamples\n";
  }
  return text;
}

std::string sampled_line(const Certificate& c, bool rays, Format format) {
  const Count sampled = c.sampled(rays, format);
  if (sampled.asked == 0) return "";
  return std::string("  sampled  ") + (rays ? "rays, " : "segments, ") + std::string(name_of(format)) + ": " +
         with_breakdown(sampled) + "; 95 % upper bound " +
         percent(upper_bound(sampled.wrong, sampled.judged(), confidence_alpha)) + " on these populations\n";
}

/// Counts of the user's own mesh, which are part of those above. People take them for leaks.
std::string mesh_lines(const Certificate& c) {
  std::string text;
  for (std::size_t i = 0; i < c.streams.size(); ++i) {
    if (c.streams[i].family != mesh_family) continue;
    text += "  mesh     " + std::string(name_of(c.streams[i].format)) + ": " + wrong_of(total_of(c, i)) +
            ", each about one triangle of your mesh: no leak rate, which `tribunal leak` measures\n";
  }
  return text;
}

const char* coverage_word(const Certificate& c) { return c.coverage.has(Operands::polygons) ? "Polygons" : "Classes"; }

std::string word(const Certificate& c, const char* key) { return c.plan[key]; }

}  // namespace

std::string to_markdown(const Certificate& c) {
  std::string text =
      "# " + c.method() + ": " + name_of(c.verdict) + (c.says_outcomes() ? "; " + c.worst() : "") + "\n\n";
  text += "Contract: " + in_words(c.contract) + ". Convention: " + std::string(name_of(c.contract.convention)) +
          ". Budget " + word(c, "budget") + ", seed " + c.plan["seed"].dump() + ". " + coverage_word(c) +
          " judged: " + coverage_text(c) + ".\n\n";
  if (!faults_in(c).empty()) text += "It is no function of its input, or fails:\n\n" + fault_lines(c, "- ") + "\n";
  if (!c.proved.empty()) text += "## Proved: sets run whole\n\n" + proved_table(c) + "\n";
  if (!c.relations.empty()) text += relations_section(c);
  if (c.sampled_strata() > 0) text += sampled_section(c);
  if (!c.errors.empty()) text += errors_section(c);
  if (c.has_own()) text += own_section(c);
  text += "## Not covered\n\n" + gaps_list(c) + "\n";
  text += "## Calibration\n\n" + calibration_list(c) + "\n";
  text += "## Environment\n\n" + environment_list(c);
  return text + "\nEvery number above follows from `log.jsonl` (sha256 of its chain: " + c.log_head +
         "); `tribunal verify` makes them again.\n";
}

std::string to_summary(const Certificate& c) {
  std::string text = c.method() + ": " + name_of(c.verdict) + "; " + c.worst() + "\n";
  for (const ProvedSet& s : c.proved) {
    text += (s.count.wrong == 0 ? "  proved   " : "  refuted  ") + s.name + ": " + std::to_string(s.count.wrong) +
            " wrong of " + std::to_string(s.count.judged()) + ", " + std::to_string(s.classes) + " " + classes_word(c) +
            after_semicolon(breakdown(s.count)) + "\n";
  }
  for (const bool rays : {false, true}) {
    for (const Format format : both_formats) text += sampled_line(c, rays, format);
  }
  text += mesh_lines(c);
  for (const Format format : both_formats) {
    const Count own = c.own(format);
    if (own.asked > 0) text += "  own      " + std::string(name_of(format)) + ": " + with_breakdown(own) + "\n";
  }
  text += relation_lines(c) + errors_lines(c) + fault_lines(c, "  FAULT    ") + worst_line(c);
  text += (c.coverage.has(Operands::polygons) ? "  judged   " : "  classes  ") + coverage_text(c) + "\n";
  for (const Gap& g : c.gaps) {
    if (!g.explained) text += "  HOLE     " + g.what + ": " + g.reason + "\n";
  }
  return text;
}

}  // namespace tribunal
