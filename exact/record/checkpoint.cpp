#include "exact/record/checkpoint.h"

#include <algorithm>
#include <set>
#include <span>
#include <tuple>
#include <utility>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/output.h"
#include "exact/record/chain.h"
#include "exact/record/data_record.h"
#include "exact/record/errors_json.h"
#include "exact/record/sample_row.h"
#include "exact/trial/judge.h"
#include "exact/trial/quick_truth.h"
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

/// The saved plan, which must be one: its members are compared, and told.
Json saved_plan(const LogRecords& log) {
  if (log.size() == 0) Where{log.path}.fail("has no plan, expected a checkpoint");
  const Record plan = log[0];
  plan.keys({"record", "methods", "streams", "seed", "cases", "until_first", "data"});
  if (plan.text("record") != "fuzz") plan.fail_at("record", "expected \"fuzz\", the plan");
  for (const char* names : {"methods", "streams"}) {
    for (const Record& name : plan.items(names)) name.text();
  }
  plan.whole("seed");
  plan.whole("cases");
  plan.truth_or("until_first", false);
  for (const Record& file : plan.items_or_none("data")) file.object();
  return plan.json();
}

/// What a run that cannot go on from the checkpoint has otherwise.
std::string difference(const Json& saved, const Json& plan) {
  const auto same = [&](const char* key) {
    return saved.contains(key) == plan.contains(key) && (!plan.contains(key) || saved[key] == plan[key]);
  };
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
Answer answer_of(const Method& method, const Query& query, const Record& record) {
  const auto name = record.find("fault");
  if (!name) return method.ask(query);
  const Status fault = fault_named(name->text());
  if (!is_fault(fault)) name->fail("no such fault");
  return refusal(fault);
}

/// Reads a checkpoint of the plan. Its first record is the plan and its last says how far the run came; nothing between
/// them may say anything else than a run does that came so far.
class CheckpointReader {
 public:
  CheckpointReader(const FuzzPlan& plan, const LogRecords& log) : plan_(plan), report_(empty_report(plan)) {
    read_done(log[log.size() - 1]);
    asked_.resize(report_.errors.size());
    wrong_.resize(report_.errors.size());
    found_.resize(report_.errors.size());
    for (std::size_t i = 1; i + 1 < log.size(); ++i) read(log[i]);
    require_whole(log[log.size() - 1]);
    require_audited(log[log.size() - 1]);
  }

  FuzzReport report() && { return std::move(report_); }

 private:
  /// By outcome and by severity.
  using Kinds = std::set<std::string_view>;

  void read_done(const Record& done) {
    done.keys({"record", "cases", "audited"});
    if (done.text("record") != "done") done.fail_at("record", "expected \"done\", the last record");
    report_.cases = done.count("cases", std::min(plan_.cases, Record::most_count));
    report_.audited = done.count("audited", report_.cases);
  }

  void read(const Record& record) {
    const std::string kind = record.text("record");
    if (kind == "sample") {
      add_row(record);
    } else if (kind == "errors") {
      add_errors(record);
    } else if (kind == "finding") {
      add_finding(record);
    } else {
      record.fail_at("record", "expected \"sample\", \"errors\" or \"finding\", found \"" + kind + "\"");
    }
  }

  /// How many of the first so many cases are of the stream: they are dealt in turn.
  std::uint64_t dealt_to(std::size_t stream, std::uint64_t cases) const {
    const std::uint64_t n = plan_.streams.size();
    return (cases + n - 1 - stream) / n;
  }

  /// How many cases of the stream a method is asked among those that are done.
  std::uint64_t dealt(std::size_t method, std::size_t stream) const {
    return takes(plan_.methods[method], plan_.streams[stream].format) ? dealt_to(stream, report_.cases) : 0;
  }

  void add_row(const Record& record) {
    const SampleRow row = to_sample_row(record);
    const auto method = std::ranges::find(plan_.methods, row.method, &Method::name);
    if (method == plan_.methods.end())
      record.fail_at("method", "expected one of the plan, found \"" + row.method + "\"");
    const auto stream = std::ranges::find_if(
        plan_.streams, [&](const Stream& s) { return s.family->name == row.family && s.format == row.format; });
    if (stream == plan_.streams.end()) record.fail("no such stream in the plan: " + row.family);
    const std::span<const int> levels = stream->family->levels(row.format);
    if (row.level >= levels.size()) record.fail_at("level", "expected one of " + std::to_string(levels.size()));
    if (row.stress != levels[row.level]) {
      record.fail_at("stress", "expected " + std::to_string(levels[row.level]) + ", that of the level");
    }
    const auto m = static_cast<std::size_t>(method - plan_.methods.begin());
    const auto s = static_cast<std::size_t>(stream - plan_.streams.begin());
    if (!rows_.insert({m, s, row.level}).second) record.fail("a second record of this method, family and level");
    for (const auto& [slot, count] : row.counts) add_count({m, s, row.level, slot}, count, record.member("counts"));
  }

  void add_count(const Cell& cell, const Count& count, const Record& counts) {
    const std::string name = slot_name(cell.slot);
    if (!slots_of(plan_.operands()).contains(cell.slot)) counts.fail_at(name, "is of other operands");
    if (count.unsaid() > 0) counts.fail_at(name, "does not say what its wrong answers are");
    const std::size_t at = plan_.errors_at(cell.method, cell.stream);
    const std::uint64_t due = dealt(cell.method, cell.stream);
    if (count.asked > due - asked_[at]) {
      counts.fail_at(name, "more cases than the " + std::to_string(due) + " that were done");
    }
    asked_[at] += count.asked;
    for (const Outcome o : wrong_outcomes) {
      if (count.at(o) > 0) wrong_[at].insert(name_of(o));
    }
    for (const Severity s : all_severities) {
      if (count.at(s) > 0) wrong_[at].insert(name_of(s));
    }
    report_.counts.at(cell) += count;
  }

  /// The numbers of method and stream.
  std::pair<std::size_t, std::size_t> method_and_stream(const Record& record) const {
    return {record.count("method", plan_.methods.size() - 1), record.count("stream", plan_.streams.size() - 1)};
  }

  void add_errors(const Record& record) {
    record.keys({"record", "method", "stream", "hits", "withheld", "t", "weights"});
    const auto [m, s] = method_and_stream(record);
    const std::size_t at = plan_.errors_at(m, s);
    const HitErrors errors = to_errors(record);
    if (report_.errors[at].hits > 0) record.fail("a second record of this method and stream");
    if (errors.hits > asked_[at]) record.fail_at("hits", "more than the method was asked");
    for (const Ulps* u : {&errors.t, &errors.weights}) {
      if (u->measured() > u->equal && u->most_at >= dealt(m, s))
        record.fail("the largest error is of no case that was done");
    }
    report_.errors[at] = errors;
  }

  /// Case and answer are made again from their numbers.
  void add_finding(const Record& record) {
    record.keys({"record", "method", "stream", "case", "outcome", "fault"});
    const auto [m, s] = method_and_stream(record);
    const std::uint64_t due = dealt(m, s);
    if (due == 0) record.fail("the method was asked no case of this stream");
    const std::uint64_t k = record.count("case", due - 1);
    const Stream& source = plan_.streams[s];
    const Trial trial = source.family->make(source.format, plan_.seed, k);
    const Truth truth = truth_of(trial, k);
    const Answer answer = answer_of(plan_.methods[m], trial.query, record);
    const Finding f{m, s, k, trial, truth, answer, outcome_of(record), severity_of(trial.query, truth)};
    const Count& counted = report_.counts.at({m, s, trial.level, slot_of(trial, truth)});
    if (counted.at(f.outcome) == 0 || counted.at(f.severity) == 0) record.fail("a wrong answer that was not counted");
    const std::size_t at = plan_.errors_at(m, s);
    found_[at].insert(name_of(f.outcome));
    found_[at].insert(name_of(f.severity));
    if (!report_.findings.empty() && case_number(plan_, f) < case_number(plan_, report_.findings.back())) {
      record.fail_at("case", "findings that are out of order");
    }
    if (!cases_.insert({m, s, k}).second) record.fail("a second record of this method and case");
    report_.findings.push_back(f);
  }

  static Outcome outcome_of(const Record& record) {
    const Outcome outcome =
        one_of<Outcome>(record.member("outcome"), {{name_of(Outcome::false_hit), Outcome::false_hit},
                                                   {name_of(Outcome::false_miss), Outcome::false_miss},
                                                   {name_of(Outcome::wrong_contact), Outcome::wrong_contact},
                                                   {name_of(Outcome::fault), Outcome::fault}});
    if ((outcome == Outcome::fault) != record.has("fault"))
      record.fail_at("outcome", "expected \"fault\" beside a fault");
    return outcome;
  }

  /// Every case that was done is counted, and every kind of wrong answer has a finding.
  void require_whole(const Record& done) const {
    for (std::size_t m = 0; m < plan_.methods.size(); ++m) {
      for (std::size_t s = 0; s < plan_.streams.size(); ++s) {
        const std::size_t at = plan_.errors_at(m, s);
        const std::string whose = plan_.methods[m].name + " on " + name_of(plan_.streams[s]);
        if (asked_[at] != dealt(m, s)) {
          done.fail_at("cases", "the counts of " + whose + " add up to " + std::to_string(asked_[at]) + ", expected " +
                                    std::to_string(dealt(m, s)));
        }
        if (!plan_.until_first && wrong_[at] != found_[at])
          done.fail("the findings of " + whose + " are not those counted");
      }
    }
  }

  /// Which cases are audited follows from their numbers. Of the first `most_counted` they are counted; of those after
  /// them none, some or all may be.
  void require_audited(const Record& done) const {
    constexpr std::uint64_t most_counted = std::uint64_t{1} << 30;
    const std::uint64_t counted = std::min(report_.cases, most_counted);
    std::uint64_t least = 0;
    if (plan_.operands() == Operands::triangles) {
      for (std::size_t s = 0; s < plan_.streams.size(); ++s) {
        least += audited_among(plan_.seed, s, dealt_to(s, counted));
      }
    }
    const std::uint64_t most = plan_.operands() == Operands::triangles ? least + (report_.cases - counted) : 0;
    if (report_.audited >= least && report_.audited <= most) return;
    done.fail_at("audited", "expected " + std::to_string(least) + (least == most ? "" : " to " + std::to_string(most)) +
                                ", as the numbers of the cases say, found " + std::to_string(report_.audited));
  }

  const FuzzPlan& plan_;
  FuzzReport report_;
  std::set<std::tuple<std::size_t, std::size_t, std::size_t>> rows_{};  ///< by method, stream and level
  std::set<std::tuple<std::size_t, std::size_t, std::uint64_t>>
      cases_{};                         ///< of findings, by method, stream and number
  std::vector<std::uint64_t> asked_{};  ///< by method and stream, as are the errors
  std::vector<Kinds> wrong_{}, found_{};
};

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
  log.finish();
  OutputFile& file = set.open(checkpoint_path(directory));
  log.text().for_each_piece([&](std::string_view piece) { file.write(piece); });
  set.commit(AfterSignal::appears);
}

std::optional<FuzzReport> load_checkpoint(const std::string& directory, const FuzzPlan& plan) {
  const std::string path = checkpoint_path(directory);
  if (!exists(path)) return std::nullopt;
  const LogRecords log = read_log(path);
  if (const Json saved = saved_plan(log); saved != plan_record(plan)) {
    throw Failure(Exit::usage, path + " is of a run with " + difference(saved, plan_record(plan)));
  }
  if (log.size() < 2) Where{path}.fail("does not say how far the run came");
  return CheckpointReader(plan, log).report();
}

}  // namespace tribunal
