// tribunal judge: answers computed anywhere, held against the exact ones.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "exact/classes/class_table.h"
#include "exact/cli/command.h"
#include "exact/harness/counterexample.h"
#include "exact/harness/environment.h"
#include "exact/harness/judge_answers.h"
#include "exact/io/failure.h"
#include "exact/io/files.h"

namespace tribunal {
namespace {

struct Options {
  std::string cases, answers, convention = "closed", out;
  unsigned threads = 1;
};

/// A sheet with what was said of it.
struct Judged {
  AnswerSheet sheet;
  SheetReport report;
};

Convention convention_of(const Options& o) {
  return o.convention == name_of(Convention::closed) ? Convention::closed : Convention::transversal;
}

std::string name_of_stratum(ClassId id) { return id == 0 ? "rays" : class_name(id); }

Count total(const std::vector<Judged>& all) {
  Count sum;
  for (const Judged& j : all) {
    for (const auto& [key, count] : j.report.counts) sum += count;
  }
  return sum;
}

// --- what the terminal shows ----------------------------------------------------------------------------------------

/// One method in one format.
struct Row {
  Count count{};
  int classes = 0, classes_wrong = 0;
};

std::map<Format, Row> by_format(const SheetReport& report) {
  std::map<Format, Row> rows;
  for (const auto& [key, count] : report.counts) {
    Row& row = rows[key.first];
    row.count += count;
    if (key.second == 0) continue;
    row.classes += count.judged() > 0;
    row.classes_wrong += count.wrong > 0;
  }
  return rows;
}

std::string line_of(const std::string& method, Format format, const Row& row) {
  const Count& n = row.count;
  const double share = n.judged() == 0 ? 0 : 100 * static_cast<double>(n.wrong) / static_cast<double>(n.judged());
  char text[160];
  std::snprintf(text, sizeof text, " %-9s %10llu %11llu %9llu  %8.4f %%  %d wrong of %d judged\n",
                std::string(name_of(format)).c_str(), static_cast<unsigned long long>(n.judged()),
                static_cast<unsigned long long>(n.unsupported), static_cast<unsigned long long>(n.wrong), share,
                row.classes_wrong, row.classes);
  return method + std::string(method.size() < 14 ? 14 - method.size() : 0, ' ') + text;
}

std::string table(const std::vector<Judged>& all) {
  std::string text = "method         format        judged unsupported     wrong       share  classes (of 163)\n";
  for (const Judged& j : all) {
    for (const auto& [format, row] : by_format(j.report)) text += line_of(j.sheet.method, format, row);
  }
  return text;
}

/// The strata with the most wrong answers, for a first look.
std::string worst(const Judged& j) {
  constexpr std::size_t shown = 5;
  using Stratum = std::pair<std::pair<Format, ClassId>, Count>;
  std::vector<Stratum> strata(j.report.counts.begin(), j.report.counts.end());
  std::stable_sort(strata.begin(), strata.end(),
                   [](const Stratum& a, const Stratum& b) { return a.second.wrong > b.second.wrong; });
  if (strata.size() > shown) strata.resize(shown);
  std::string text;
  for (const auto& [key, count] : strata) {
    if (count.wrong == 0) break;
    text += (text.empty() ? "  most of " + j.sheet.method + "'s in: " : ", ") + name_of_stratum(key.second) + " " +
            std::string(name_of(key.first)) + " " + std::to_string(count.wrong) + "/" + std::to_string(count.judged());
  }
  return text.empty() ? "" : text + "\n";
}

// --- what a program reads -------------------------------------------------------------------------------------------

Json summary(const std::vector<Judged>& all, Convention convention) {
  Json rows = Json::array();
  for (const Judged& j : all) {
    for (const auto& [key, count] : j.report.counts) {
      rows.push_back({{"method", j.sheet.method},
                      {"fmt", name_of(key.first)},
                      {"class", name_of_stratum(key.second)},
                      {"asked", count.asked},
                      {"wrong", count.wrong},
                      {"unsupported", count.unsupported}});
    }
  }
  return {{"convention", name_of(convention)}, {"counts", rows}, {"environment", environment()}};
}

std::vector<Case> counterexamples(const Exam& exam, const std::vector<Judged>& all, Convention convention) {
  std::vector<Case> cases;
  for (const Judged& j : all) {
    for (const std::size_t at : j.report.wrong) cases.push_back(to_counterexample(exam, j.sheet, convention, at));
  }
  return cases;
}

std::string write_report(const Exam& exam, const std::vector<Judged>& all, const Options& o) {
  const std::vector<Case> cases = counterexamples(exam, all, convention_of(o));
  write_file(o.out + "/summary.json", summary(all, convention_of(o)).dump(1) + "\n");
  write_file(o.out + "/counterexamples.jsonl", to_lines(cases));
  return std::to_string(cases.size()) + " wrong answers in " + o.out + "/counterexamples.jsonl" +
         (cases.empty() ? "" : "; `tribunal replay` shows them") + "\n";
}

int run(const Options& o) {
  if (o.cases == "-" && o.answers == "-") throw Failure(Exit::usage, "--cases and --answers are both standard input");
  const Convention convention = convention_of(o);
  const Exam exam = read_exam(o.cases, o.threads);
  std::vector<Judged> all;
  for (AnswerSheet& sheet : read_answers(o.answers, exam.cases)) {
    const SheetReport report = judge_sheet(exam, sheet, convention);
    all.push_back({std::move(sheet), report});
  }
  const Count sum = total(all);
  if (sum.judged() == 0) throw bad_input(o.answers, 0, "no answer is \"ok\", nothing to judge");
  std::string text = table(all);
  for (const Judged& j : all) text += worst(j);
  if (!o.out.empty()) {
    make_directory(o.out);
    text += write_report(exam, all, o);
  }
  print(text);
  return code(sum.wrong > 0 ? Exit::disagreement : Exit::ok);
}

}  // namespace

Action declare_judge(CLI::App& app) {
  const auto o = std::make_shared<Options>();
  app.add_option("--cases", o->cases, "case file (JSON Lines); - is standard input")->required();
  app.add_option("--answers", o->answers, "answer file (JSON Lines), one answer a case and method")->required();
  app.add_option("--convention", o->convention, "what the answers promise of coplanar contacts")
      ->check(CLI::IsMember({"closed", "transversal"}))
      ->capture_default_str();
  add_threads_option(app, o->threads);
  app.add_option("--out", o->out, "directory for summary.json and counterexamples.jsonl");
  return [o] { return run(*o); };
}

}  // namespace tribunal
