#include "exact/harness/checkpoint.h"

#include <algorithm>
#include <filesystem>

#include "exact/io/failure.h"
#include "exact/io/files.h"
#include "exact/log/chain.h"
#include "exact/log/sample_row.h"
#include "exact/polygon/fuzz.h"

namespace tribunal {
namespace {

/// All that the cases and their order depend on; not the threads.
template <class On>
Json plan_record(const BasicFuzzPlan<On>& plan) {
  Json methods = Json::array(), streams = Json::array();
  for (const Method& m : plan.methods) methods.push_back(m.name);
  for (const BasicStream<On>& s : plan.streams) streams.push_back(name_of(s));
  return {{"record", "fuzz"}, {"methods", methods}, {"streams", streams}, {"seed", plan.seed}, {"cases", plan.cases}};
}

template <class On>
Json finding_record(const BasicFinding<On>& f) {
  Json record = {{"record", "finding"}, {"method", f.method}, {"stream", f.stream}, {"case", f.k}};
  if (is_fault(plain(f.answer).status)) record["fault"] = fault_name(plain(f.answer).status);
  return record;
}

/// The answer is asked for again, but for a fault, which may have taken its time.
template <class On>
typename On::Answer answer_of(const Method& method, const typename On::Query& query, const Json& record,
                              const Where& where) {
  if (!record.contains("fault")) return method.ask(query);
  const Status fault = fault_named(string_of(record, "fault", where));
  if (!is_fault(fault)) where.key("fault").fail("no such fault");
  return {refusal(fault)};
}

/// Case and answer are made again from their numbers.
template <class On>
BasicFinding<On> finding_from(const BasicFuzzPlan<On>& plan, const Json& record, const Where& where) {
  const std::size_t method = number_of(record, "method", where), stream = number_of(record, "stream", where);
  if (method >= plan.methods.size() || stream >= plan.streams.size()) where.fail("no such method or stream");
  const std::uint64_t k = number_of(record, "case", where);
  const BasicStream<On>& source = plan.streams[stream];
  const typename On::Trial trial = source.family->make(source.format, plan.seed, k);
  return {method,
          stream,
          k,
          trial,
          On::truth_of(trial, k),
          answer_of<On>(plan.methods[method], trial.query, record, where)};
}

template <class On>
void add_row(const BasicFuzzPlan<On>& plan, BasicFuzzReport<On>& report, const SampleRow& row, const Where& where) {
  const auto method = std::ranges::find(plan.methods, row.method, &Method::name);
  const auto stream = std::ranges::find_if(
      plan.streams, [&](const BasicStream<On>& s) { return s.family->name == row.family && s.format == row.format; });
  if (method == plan.methods.end() || stream == plan.streams.end()) where.fail("no such method or stream");
  if (row.level >= stream->family->levels(row.format).size()) where.fail("no such level");
  const auto m = static_cast<std::size_t>(method - plan.methods.begin());
  const auto s = static_cast<std::size_t>(stream - plan.streams.begin());
  for (const auto& [slot, count] : row.counts) {
    if (!slots_of(On::operands).contains(slot)) where.fail("\"" + slot_name(slot) + "\" is of other operands");
    report.counts.at({m, s, row.level, slot}) += count;
  }
}

template <class On>
void add_record(const BasicFuzzPlan<On>& plan, BasicFuzzReport<On>& report, const Json& record, const Where& where) {
  const std::string kind = string_of(record, "record", where);
  if (kind == "sample") {
    add_row(plan, report, to_sample_row(record, where), where);
  } else if (kind == "finding") {
    report.findings.push_back(finding_from(plan, record, where));
  } else if (kind == "done") {
    report.cases = number_of(record, "cases", where);
  } else {
    where.fail("unknown record \"" + kind + "\"");
  }
}

}  // namespace

std::string checkpoint_path(const std::string& directory) { return directory + "/checkpoint.jsonl"; }

template <class On>
void save_checkpoint(const std::string& directory, const BasicFuzzPlan<On>& plan, const BasicFuzzReport<On>& report) {
  ChainedLog log;
  log.add(plan_record(plan));
  for (const SampleRow& row : rows_of(plan, report)) log.add(to_record(row));
  for (const BasicFinding<On>& f : report.findings) log.add(finding_record(f));
  log.add({{"record", "done"}, {"cases", report.cases}});
  write_file(checkpoint_path(directory), log.finish());
  for (const char* of_another_run : {"/summary.json", "/counterexamples.jsonl"}) {
    std::filesystem::remove(directory + of_another_run);
  }
}

template <class On>
std::optional<BasicFuzzReport<On>> load_checkpoint(const std::string& directory, const BasicFuzzPlan<On>& plan) {
  const std::string path = checkpoint_path(directory);
  if (!std::filesystem::exists(path)) return std::nullopt;
  const LogRecords log = read_log(path);
  if (log.records.empty() || log.records[0] != plan_record(plan)) {
    throw Failure(Exit::usage, path + " is of a run with other methods, families, seed or count");
  }
  BasicFuzzReport<On> report = empty_report(plan);
  for (std::size_t i = 1; i < log.records.size(); ++i) add_record(plan, report, log.records[i], {path, i + 1});
  return report;
}

template void save_checkpoint(const std::string&, const FuzzPlan&, const FuzzReport&);
template void save_checkpoint(const std::string&, const PolygonFuzzPlan&, const PolygonFuzzReport&);
template std::optional<FuzzReport> load_checkpoint(const std::string&, const FuzzPlan&);
template std::optional<PolygonFuzzReport> load_checkpoint(const std::string&, const PolygonFuzzPlan&);

void remove_checkpoint(const std::string& directory) { std::filesystem::remove(checkpoint_path(directory)); }

}  // namespace tribunal
