// What a certificate says of relations between answers.
#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "exact/certificate/bounds.h"
#include "exact/certificate/rate.h"
#include "exact/certificate/report_parts.h"

namespace tribunal {
namespace {

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

}  // namespace

std::string relations_section(const Certificate& c) {
  return "## Relations\n\nWhat must hold between answers, whatever they are; no oracle is asked. Checked on the first "
         "cases of each population below, and of triangles on the ray through each segment too. One relation broken "
         "refutes; the queries that show it are in `certificate.json`, and one of their answers, shrunk, is among the "
         "counterexamples. The bounds are one-sided, at 95 % each.\n\n" +
         (c.broken_relations().empty() ? "" : broken_table(c)) + kept_list(c);
}

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

}  // namespace tribunal
