#include "exact/certificate/verify.h"

#include <algorithm>
#include <cstdio>

#include "exact/base/files.h"
#include "exact/cases/case_io.h"
#include "exact/certificate/certify.h"
#include "exact/certificate/owed.h"
#include "exact/methods/methods.h"
#include "exact/record/contract_json.h"
#include "exact/record/counterexample.h"
#include "exact/relations/relation.h"
#include "exact/trial/severity.h"

namespace tribunal {
namespace {

void compare(Verification& v, const std::string& path, const std::string& due) {
  if (read_file(path) != due) v.faults.push_back(path + " is not what the log gives");
}

/// The member as 0 or 1; -1 if it is missing.
int answer_in(const Record& finding, std::string_view key) {
  return finding.has(key) ? static_cast<int>(finding.count(key, 1)) : -1;
}

/// What it answered is wrong as the finding says: the other answer, or a wrong contact of a hit; or no answer.
bool is_wrong_as_said(const Record& finding, const Truth& truth) {
  const Due owed = due(readings_in(finding), truth);
  const int expected = owed == Due::hit ? 1 : 0, answered = answer_in(finding, "answered");
  if (answer_in(finding, "expected") != expected) return false;
  if (finding.has("fault")) return answered == -1;
  if (owed == Due::nothing) return false;
  if (finding.text_or("outcome", "") != name_of(Outcome::wrong_contact)) return answered == 1 - expected;
  return answered == expected && (finding.text_or("contact_told", "") != name_of(truth.contact) ||
                                  finding.truth_or("planar_told", truth.planar) != truth.planar);
}

/// Older findings do not say how bad they are.
bool is_as_bad_as_said(const Record& finding, const Query& query, const Truth& truth) {
  return !finding.has("severity") || finding.text("severity") == name_of(severity_of(query, truth));
}

bool has_exact_evidence(const Record& finding, const Query& query) {
  const auto evidence = finding.find("exact");
  return evidence && evidence->json() == exact_evidence(query);
}

bool is_counterexample(const Case& c, const Record& finding) {
  const Truth truth = exact_truth(c.query);
  return mistaken_claim(c, truth).empty() && is_wrong_as_said(finding, truth) &&
         is_as_bad_as_said(finding, c.query, truth) && has_exact_evidence(finding, c.query);
}

/// Confirms the log's counterexample by the oracles alone; the method is not asked.
void confirm(Verification& v, const Record& record) {
  const Record line = record.member("case");
  const Case c = to_case(line.json(), line.where());
  if (is_counterexample(c, line.member("finding"))) {
    ++v.confirmed;
  } else {
    v.faults.push_back("counterexample " + c.id + " is none");
  }
}

/// Holds a file, which is read as it goes, against what it should be.
class ExpectedFile {
 public:
  explicit ExpectedFile(const std::string& path) : bytes_(bytes_of(path)) {}

  void expect(const std::string& text) {
    found_.resize(text.size());
    for (std::size_t done = 0; same_ && done < text.size();) {
      const std::size_t n = bytes_(found_.data() + done, text.size() - done);
      done += n;
      same_ = n > 0;
    }
    same_ = same_ && found_ == text;
  }

  /// Whether it was all that, and no more.
  bool is_as_expected() {
    char more = 0;
    return same_ && bytes_(&more, 1) == 0;
  }

 private:
  LineReader::Source bytes_;
  std::string found_{};
  bool same_ = true;
};

/// The log's counterexamples in turn: each must stand in the file beside it, and be one.
void compare_and_confirm(Verification& v, const std::string& path, const Log& log) {
  ExpectedFile file(path);
  Verification confirmed{};
  for_each_counterexample(log, [&](const Record& record, const std::string& line) {
    file.expect(line);
    confirm(confirmed, record);
  });
  if (!file.is_as_expected()) v.faults.push_back(path + " is not what the log gives");
  for (const std::string& debt : debts_of(v.certificate, log.others())) v.faults.push_back(debt);
  v.faults.insert(v.faults.end(), confirmed.faults.begin(), confirmed.faults.end());
  v.confirmed = confirmed.confirmed;
}

void compare(Verification& v, const ScopeResult& again) {
  char hash[20];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(again.answers_hash));
  const ProvedSet& logged = v.certificate.proved.front();
  if (logged.answers_hash != hash || logged.count != again.count) {
    v.faults.push_back("the set \"" + logged.name + "\", run again, gives other answers");
  }
  v.asked_again = again.size;
}

void ask_again(Verification& v) {
  const Method* method = find_method(v.certificate.method());
  if (v.certificate.proved.empty()) {
    v.not_asked = "its answers came from a file";
  } else if (method == nullptr) {
    v.not_asked = "the method is not known here";
  } else if (v.certificate.operands() == Operands::triangles) {
    compare(v, pocket_run(*method));
  } else if (method->polygon) {
    compare(v, pocket_of_rings_run(*method));
  } else {
    v.not_asked = "the method of this name takes no polygons here";
  }
}

/// The queries of a witness must be those that the relation makes of the case it names, and a method that this program
/// has must break the relation on them again.
void confirm(Verification& v, const FuzzPlan& plan, const RelationRow& row) {
  const auto relations = relations_of(plan.operands());
  const auto r = static_cast<std::size_t>(std::ranges::find(relations, row.name, &Relation::name) - relations.begin());
  const auto instance =
      r < relations.size() && row.first < plan.cases ? instance_of(plan, r, row.first, row.of_rays) : std::nullopt;
  std::vector<Json> due;
  if (instance) {
    for (const Query& q : instance->queries) due.push_back(from_case({.id = "", .format = row.format, .query = q}));
  }
  const Method* const method = find_method(v.certificate.method());
  if (due.empty() || due != row.witness) {
    v.faults.push_back("the witness against relation " + row.name + " is none");
  } else if (method != nullptr && instance->holds(*method) != std::optional(false)) {
    v.faults.push_back("relation " + row.name + " holds on the witness against it");
  }
}

void confirm_relations(Verification& v) {
  const Certificate& c = v.certificate;
  if (c.relations.empty() || !c.budget.is_object()) return;
  const FuzzPlan plan = relation_plan(to_budget({c.budget, {"log.jsonl"}}), c.seed(), c.operands());
  for (const RelationRow& row : c.relations) {
    if (row.broken > 0) confirm(v, plan, row);
  }
}

/// The records that a rerun must give again, in the log's order.
std::vector<Record> answers_in(const LogRecords& log) {
  std::vector<Record> records;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const Record r = log[i];
    const std::string kind = r.text("record");
    const bool own = r.text_or("family", "") == own_cases;
    if (kind == "set" || kind == "relation" || (!own && (kind == "stream" || kind == "sample" || kind == "errors")))
      records.push_back(r);
  }
  return records;
}

std::string what_it_counts(const Record& record) {
  for (const char* key : {"set", "relation", "family"}) {
    if (record.has(key)) return record.text(key);
  }
  return record.text("record");
}

ChainedLog run_again(const Method& method, const Certificate& c, unsigned threads) {
  CertifyPlan plan{.method = method,
                   .operands = c.operands(),
                   .budget = to_budget({c.budget, {"log.jsonl"}}),
                   .seed = c.seed(),
                   .threads = threads};
  return certify(plan);
}

void rerun_all(Verification& v, const LogRecords& log, unsigned threads) {
  const Certificate& c = v.certificate;
  const Method* const method = find_method(c.method());
  if (method == nullptr || !c.budget.is_object()) {
    v.faults.push_back("cannot be run again: " + std::string(method == nullptr ? "the method is not known here"
                                                                               : "its answers came from a file"));
    return;
  }
  ChainedLog again = run_again(*method, c, threads);
  again.finish();
  const Log due_log(again);
  const std::vector<Record> due = answers_in(due_log.others()), logged = answers_in(log);
  if (due.size() != logged.size())
    v.faults.push_back("run again, the trial has other records (a mesh is not run again)");
  for (std::size_t i = 0; i < std::min(due.size(), logged.size()); ++i) {
    if (due[i].has("size")) v.rerun += due[i].count("size");
    if (due[i].text("record") == "stream") v.rerun += due[i].count("cases");
    if (due[i].json() == logged[i].json()) continue;
    v.faults.push_back("run again, " + what_it_counts(due[i]) + " gives other counts");
  }
}

}  // namespace

Verification verify(const std::string& directory, unsigned rerun) {
  const std::string path = directory + "/log.jsonl";
  const Log log(path);
  Verification v{certificate_from(log)};
  compare(v, directory + "/certificate.json", to_json(v.certificate).dump(1) + "\n");
  compare(v, directory + "/certificate.md", to_markdown(v.certificate));
  compare_and_confirm(v, directory + "/counterexamples.jsonl", log);
  confirm_relations(v);
  ask_again(v);
  if (rerun > 0 && v.faults.empty()) rerun_all(v, log.others(), rerun);
  return v;
}

}  // namespace tribunal
