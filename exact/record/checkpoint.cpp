#include "exact/record/checkpoint.h"

#include <algorithm>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/output.h"
#include "exact/record/chain.h"
#include "exact/record/data_record.h"
#include "exact/record/errors_json.h"
#include "exact/record/sample_row.h"
#include "exact/trial/judge.h"
#include "exact/trial/severity.h"

namespace tribunal {
namespace {

/// All that the cases and their order depend on; not the threads.
Json plan_record(const FuzzPlan& plan) {
  Json methods = Json::array(), streams = Json::array();
  for (const Method& m : plan.methods) methods.push_back(m.name);
  for (const Stream& s : plan.streams) streams.push_back(name_of(s));
  Json record = {
      {"record", "fuzz"}, {"methods", methods}, {"streams", streams}, {"seed", plan.seed}, {"cases", plan.cases}};
  if (plan.until_first) record["until_first"] = true;
  const Json data = data_of(plan);
  if (!data.empty()) record["data"] = data;
  return record;
}

/// What a run that cannot go on from the checkpoint has otherwise.
std::string difference(const Json& saved, const Json& plan) {
  const auto same = [&](const char* key) { return saved.value(key, Json()) == plan.value(key, Json()); };
  if (!same("data")) return "other data of your own, or changed since";
  return same("until_first") ? "other methods, families, seed or count" : "another way to end (--until-first)";
}

Json finding_record(const Finding& f) {
  Json record = {{"record", "finding"},
                 {"method", f.method},
                 {"stream", f.stream},
                 {"case", f.k},
                 {"outcome", name_of(f.outcome)}};
  if (is_fault(f.answer.status)) record["fault"] = fault_name(f.answer.status);
  return record;
}

/// The answer is asked for again, but for a fault, which may have taken its time.
Answer answer_of(const Method& method, const Query& query, const Json& record, const Where& where) {
  if (!record.contains("fault")) return method.ask(query);
  const Status fault = fault_named(string_of(record, "fault", where));
  if (!is_fault(fault)) where.key("fault").fail("no such fault");
  return refusal(fault);
}

Outcome outcome_of(const Json& record, const Where& where) {
  const auto outcome = outcome_named(string_of(record, "outcome", where));
  if (!outcome) where.key("outcome").fail("no such outcome of a wrong answer");
  return *outcome;
}

/// Case and answer are made again from their numbers.
Finding finding_from(const FuzzPlan& plan, const Json& record, const Where& where) {
  const std::size_t method = number_of(record, "method", where), stream = number_of(record, "stream", where);
  if (method >= plan.methods.size() || stream >= plan.streams.size()) where.fail("no such method or stream");
  const std::uint64_t k = number_of(record, "case", where);
  const Stream& source = plan.streams[stream];
  const Trial trial = source.family->make(source.format, plan.seed, k);
  const Truth truth = truth_of(trial, k);
  const Answer answer = answer_of(plan.methods[method], trial.query, record, where);
  const Outcome outcome =
      record.contains("outcome") ? outcome_of(record, where) : judge(plan.methods[method], truth, answer);
  return {method, stream, k, trial, truth, answer, outcome, severity_of(trial.query, truth)};
}

void add_errors(const FuzzPlan& plan, FuzzReport& report, const Json& record, const Where& where) {
  const std::size_t m = number_of(record, "method", where), s = number_of(record, "stream", where);
  if (m >= plan.methods.size() || s >= plan.streams.size()) where.fail("no such method or stream");
  report.errors[plan.errors_at(m, s)] += to_errors(record, where);
}

/// By the numbers of method and stream in the plan; only what counts something.
void log_errors(ChainedLog& log, const FuzzPlan& plan, const FuzzReport& report) {
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    for (std::size_t s = 0; s < plan.streams.size(); ++s) {
      const HitErrors& errors = report.errors[plan.errors_at(m, s)];
      if (errors.hits == 0) continue;
      Json record = {{"record", "errors"}, {"method", m}, {"stream", s}};
      record.update(from_errors(errors));
      log.add(record);
    }
  }
}

void add_row(const FuzzPlan& plan, FuzzReport& report, const SampleRow& row, const Where& where) {
  const auto method = std::ranges::find(plan.methods, row.method, &Method::name);
  const auto stream = std::ranges::find_if(
      plan.streams, [&](const Stream& s) { return s.family->name == row.family && s.format == row.format; });
  if (method == plan.methods.end() || stream == plan.streams.end()) where.fail("no such method or stream");
  if (row.level >= stream->family->levels(row.format).size()) where.fail("no such level");
  const auto m = static_cast<std::size_t>(method - plan.methods.begin());
  const auto s = static_cast<std::size_t>(stream - plan.streams.begin());
  for (const auto& [slot, count] : row.counts) {
    if (!slots_of(plan.operands()).contains(slot)) where.fail("\"" + slot_name(slot) + "\" is of other operands");
    report.counts.at({m, s, row.level, slot}) += count;
  }
}

void add_record(const FuzzPlan& plan, FuzzReport& report, const Json& record, const Where& where) {
  const std::string kind = string_of(record, "record", where);
  if (kind == "sample") {
    add_row(plan, report, to_sample_row(record, where), where);
  } else if (kind == "errors") {
    add_errors(plan, report, record, where);
  } else if (kind == "finding") {
    report.findings.push_back(finding_from(plan, record, where));
  } else if (kind == "done") {
    report.cases = number_of(record, "cases", where);
    report.audited = number_of(record, "audited", where);
  } else {
    where.fail("unknown record \"" + kind + "\"");
  }
}

}  // namespace

std::string checkpoint_path(const std::string& directory) { return directory + "/checkpoint.jsonl"; }

void save_checkpoint(const std::string& directory, const FuzzPlan& plan, const FuzzReport& report) {
  ChainedLog log;
  log.add(plan_record(plan));
  for (const SampleRow& row : rows_of(plan, report)) log.add(to_record(row));
  log_errors(log, plan, report);
  for (const Finding& f : report.findings) log.add(finding_record(f));
  log.add({{"record", "done"}, {"cases", report.cases}, {"audited", report.audited}});
  OutputSet set;
  for (const char* of_another_run : {"/summary.json", "/counterexamples.jsonl"}) set.drop(directory + of_another_run);
  set.add(checkpoint_path(directory), log.finish());
  set.commit(AfterSignal::appears);
}

std::optional<FuzzReport> load_checkpoint(const std::string& directory, const FuzzPlan& plan) {
  const std::string path = checkpoint_path(directory);
  if (!exists(path)) return std::nullopt;
  const LogRecords log = read_log(path);
  if (log.records.empty() || log.records[0] != plan_record(plan)) {
    const Json saved = log.records.empty() ? Json::object() : log.records[0];
    throw Failure(Exit::usage, path + " is of a run with " + difference(saved, plan_record(plan)));
  }
  FuzzReport report = empty_report(plan);
  for (std::size_t i = 1; i < log.records.size(); ++i) add_record(plan, report, log.records[i], {path, i + 1});
  return report;
}

}  // namespace tribunal
