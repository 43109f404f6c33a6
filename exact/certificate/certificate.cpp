// Makes a certificate of the records of a log: reads them, and derives strata, gaps and verdict.
#include "exact/certificate/certificate.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <tuple>

#include "exact/base/output.h"
#include "exact/cases/case_io.h"
#include "exact/certificate/budget.h"
#include "exact/classes/class_table.h"
#include "exact/record/contract_json.h"
#include "exact/record/counterexample.h"
#include "exact/record/errors_json.h"

namespace tribunal {
namespace {

/// Whether the record's probes are rays.
bool has_rays(const Record& r) { return one_of<bool>(r.member("probes"), {{"segment", false}, {"ray", true}}); }

/// FNV-1a as log_plan's sets have it: sixteen digits.
std::string hash_in(const Record& r) {
  std::string hash = r.text("answers_hash");
  if (hash.size() != 16 || hash.find_first_not_of("0123456789abcdef") != std::string::npos) {
    r.fail_at("answers_hash", "expected 16 hexadecimal digits");
  }
  return hash;
}

ProvedSet to_set(const Record& r) {
  r.keys({"record", "set", "probes", "size", "judged_by", "classes", "answers_hash", "complete", "count", "operands"});
  ProvedSet set{.name = r.text("set"),
                .oracles = r.text("judged_by"),
                .answers_hash = hash_in(r),
                .of_rays = has_rays(r),
                .size = r.count("size"),
                .classes = r.count("classes", r.count("size")),
                .complete = r.truth("complete"),
                .count = to_count(r.member("count"))};
  if (set.count.asked > set.size) r.fail_at("count", "more cases than the set has");
  return set;
}

RelationRow to_relation(const Record& r) {
  r.keys({"record", "relation", "statement", "fmt", "probes", "cases", "operands", "asked", "broken", "faults", "first",
          "witness"});
  RelationRow row{.name = r.text("relation"),
                  .statement = r.text("statement"),
                  .format = format_of(r),
                  .of_rays = has_rays(r),
                  .cases = r.count("cases")};
  row.asked = r.count("asked", row.cases);
  row.broken = r.count("broken", row.asked);
  row.faults = r.count("faults", row.cases - row.asked);
  if (row.broken == 0) return row;
  row.first = r.count("first");
  for (const Record& query : r.items("witness")) {
    to_case(query.json(), query.where());
    row.witness.push_back(query.json());
  }
  return row;
}

NonfiniteRow to_nonfinite(const Record& r) {
  r.keys({"record", "fmt", "asked", "refused", "answered", "first"});
  NonfiniteRow row{.format = format_of(r), .asked = r.count("asked")};
  row.refused = r.count("refused", row.asked);
  row.answered = r.count("answered", row.asked - row.refused);
  if (row.answered > 0) row.first = r.text("first");
  return row;
}

/// The operands of a record: triangles, unless it says otherwise.
Operands operands_in(const Record& r) {
  const auto given = r.find("operands");
  return given ? one_of<Operands>(*given, {{"polygons", Operands::polygons}}) : Operands::triangles;
}

SampledStream to_stream(const Record& r) {
  r.keys({"record", "family", "fmt", "axis", "population", "judged_by", "aims_at_classes", "first_cases", "taken",
          "cases", "operands"});
  return {.family = r.text("family"),
          .format = format_of(r),
          .axis = r.text("axis"),
          .population = r.text("population"),
          .judged_by = r.text("judged_by"),
          .aims_at_classes = r.truth("aims_at_classes"),
          .taken = r.truth("taken"),
          .cases = r.count("cases"),
          .operands = operands_in(r)};
}

std::vector<Stage> to_stages(const Record& plan) {
  std::vector<Stage> stages;
  for (const Record& name : plan.items("stages")) {
    const std::optional<Stage> stage = stage_named(name.text());
    if (!stage) name.fail("unknown stage");
    if (std::ranges::find(stages, *stage) != stages.end()) name.fail("the same stage twice");
    stages.push_back(*stage);
  }
  return stages;
}

/// Checks a case that will stand in counterexamples.jsonl, and returns its fault, if it is one. What its finding says
/// is judged by `verify`.
std::optional<std::string> read_counterexample(const Record& r) {
  r.keys({"record", "case"});
  const Record line = r.member("case");
  const Case c = to_case(line.json(), line.where());
  const Record finding = line.member("finding");
  rank_of(c, finding.where());
  const auto fault = finding.find("fault");
  return fault ? std::optional(fault->text()) : std::nullopt;
}

/// Reads the records of a log, of which the first are the plan, what it was made with, and its budget if it has one.
/// What is counted must fit what it is counted of: sets, streams and relations come before what refers to them.
class LogReader {
 public:
  LogReader(Certificate& c, const Log& log) : c_(c) {
    if (log.size() < 2) Where{log.path()}.fail("missing the plan or the environment");
    std::size_t i = 0;
    log.for_each([&](const Record& r) { read(r, i++); });
  }

 private:
  void read_plan(const Record& r) {
    if (r.text("record") != "plan") r.fail_at("record", "expected \"plan\", the first record");
    r.keys({"record", "method", "number", "reference", "terms", "stages", "budget", "seed", "version", "operands",
            "command"});
    for (const char* key : {"method", "number", "reference", "budget"}) r.text(key);
    r.whole("seed");
    for (const Record& word : r.items_or_none("command")) word.text();
    if (r.has("version")) {
      const std::int64_t version = r.integer("version", 1, std::numeric_limits<std::int64_t>::max());
      if (version > static_cast<std::int64_t>(log_version)) {
        r.fail_at("version", "expected at most " + std::to_string(log_version) + ": the log is of a newer program");
      }
    }
    operands_in(r);
    c_.plan = r.json();
    c_.contract = to_contract(r.member("terms"));
    c_.stages = to_stages(r);
  }

  void read_environment(const Record& r) {
    if (r.text("record") != "environment") r.fail_at("record", "expected \"environment\", the second record");
    for (const auto& [key, value] : r.members()) value.text();
    c_.environment = r.json();
  }

  void read(const Record& r, std::size_t i) {
    if (i == 0) return read_plan(r);
    if (i == 1) return read_environment(r);
    const std::string kind = r.text("record");
    if (kind == "budget") {
      if (i != 2) r.fail("expected the budget once, after the environment");
      to_budget(r);
      c_.budget = r.json();
    } else if (kind == "set") {
      c_.proved.push_back(to_set(r));
    } else if (kind == "relation") {
      c_.relations.push_back(to_relation(r));
    } else if (kind == "stream") {
      read_stream(r);
    } else if (kind == "sample") {
      read_sample(r);
    } else if (kind == "errors") {
      read_errors(r);
    } else if (kind == "nonfinite") {
      c_.nonfinite.push_back(to_nonfinite(r));
    } else if (kind == "counterexample") {
      count_counterexample(read_counterexample(r));
    } else {
      r.fail_at("record", "unknown record \"" + kind + "\"");
    }
  }

  void count_counterexample(const std::optional<std::string>& fault) {
    ++c_.counterexamples;
    if (fault) ++c_.faults[*fault];
  }

  void read_stream(const Record& r) {
    SampledStream stream = to_stream(r);
    for (const SampledStream& s : c_.streams) {
      if (s.family == stream.family && s.format == stream.format && s.operands == stream.operands) {
        r.fail("a second record of this stream");
      }
    }
    if (total_ > Record::most_count - stream.cases) r.fail_at("cases", "more cases than can be counted");
    total_ += stream.cases;
    c_.streams.push_back(std::move(stream));
  }

  /// The stream that a record is about. Triangles and polygons may have one family name: one's own cases.
  const SampledStream& stream_of(const Record& r, const std::string& family, Format format, Operands operands) const {
    for (const SampledStream& s : c_.streams) {
      if (s.family == family && s.format == format && s.operands == operands) return s;
    }
    r.fail("of a stream that is not in the log before it: " + family + " " + std::string(tribunal::name_of(format)));
  }

  void read_sample(const Record& r) {
    SampleRow row = to_sample_row(r);
    for (const Operands operands : {Operands::triangles, Operands::polygons}) {
      std::uint64_t asked = 0;
      bool any = false;
      for (const auto& [slot, count] : row.counts) {
        if (operands_of(slot) != operands) continue;
        any = true;
        if (count.asked > Record::most_count - asked) r.fail_at("counts", "more cases than can be counted");
        asked += count.asked;
      }
      if (!any) continue;
      const SampledStream& stream = stream_of(r, row.family, row.format, operands);
      std::uint64_t& so_far = asked_[{row.method, row.family, row.format, operands}];
      if (asked > stream.cases - std::min(so_far, stream.cases)) {
        r.fail_at("counts",
                  "more cases of " + row.method + " than the " + std::to_string(stream.cases) + " of the stream");
      }
      so_far += asked;
    }
    if (row.method == c_.method()) {
      c_.rows.push_back(std::move(row));
    } else {
      c_.calibration[row.method].of(row.format) += total_of(row);
    }
  }

  void read_errors(const Record& r) {
    r.keys({"record", "method", "family", "fmt", "hits", "withheld", "t", "weights"});
    if (r.text("method") != c_.method()) r.fail_at("method", "expected " + c_.method() + ", the plan's");
    ErrorRow row{r.text("family"), format_of(r), to_errors(r)};
    const SampledStream& stream = stream_of(r, row.family, row.format, Operands::triangles);
    if (row.errors.hits > stream.cases) r.fail_at("hits", "more than the stream has cases");
    for (const ErrorRow& e : c_.errors) {
      if (e.family == row.family && e.format == row.format) r.fail("a second record of this stream");
    }
    c_.errors.push_back(std::move(row));
  }

  Certificate& c_;
  std::uint64_t total_ = 0;  ///< cases of all streams
  std::map<std::tuple<std::string, std::string, Format, Operands>, std::uint64_t> asked_{};
};

/// Whether the row counts cases of the stream. Triangles and polygons may have one family name (one's own cases), but
/// have different slots.
bool belongs(const SampleRow& row, const SampledStream& stream) {
  return row.family == stream.family && row.format == stream.format;
}

std::string name_of(const SampledStream& s) { return s.family + " " + std::string(tribunal::name_of(s.format)); }

/// Adds a stratum for every class, construction or outcome that each stream must have cases of, for segments and rays,
/// also where none was drawn.
void add_strata(Certificate& c) {
  for (std::size_t i = 0; i < c.streams.size(); ++i) {
    const SampledStream& stream = c.streams[i];
    if (!stream.taken) continue;
    std::map<Slot, Count> counts;
    for (const Slot slot : slots_due(stream.operands, stream.aims_at_classes)) counts[slot];
    for (const SampleRow& row : c.rows) {
      if (!belongs(row, stream)) continue;
      for (const auto& [slot, count] : row.counts) {
        if (operands_of(slot) == stream.operands) counts[slot] += count;
      }
    }
    for (const auto& [slot, count] : counts) c.strata.push_back({i, slot, count});
  }
}

void add_coverage(Certificate& c) {
  for (const Stratum& s : c.strata) c.coverage.add(c.streams[s.stream].format, s.slot, s.count);
}

void add_stream_gaps(Certificate& c) {
  for (std::size_t i = 0; i < c.streams.size(); ++i) {
    const SampledStream& stream = c.streams[i];
    if (!stream.taken) {
      c.gaps.push_back({name_of(stream), "the method computes in binary32; these operands do not fit", true});
      continue;
    }
    std::uint64_t asked = 0;
    for (const Stratum& s : c.strata) asked += s.stream == i ? s.count.asked : 0;
    if (asked == stream.cases) continue;
    c.gaps.push_back({name_of(stream),
                      "the counts add up to " + std::to_string(asked) + " of " + std::to_string(stream.cases) +
                          " cases: some were lost",
                      false});
  }
}

std::string outside_contract(const Certificate& c) { return "outside the method's contract: " + in_words(c.contract); }

/// Adds a gap for every stratum in which nothing was judged, or something was refused.
void add_class_gaps(Certificate& c) {
  for (const Stratum& s : c.strata) {
    const SampledStream& stream = c.streams[s.stream];
    std::string what = name_of(stream) + " " + slot_name(s.slot);
    if (s.count.unsupported > 0) {
      what += ": " + std::to_string(s.count.unsupported) + " of " + std::to_string(s.count.asked);
      c.gaps.push_back({what, outside_contract(c), true});
    }
    if (s.count.asked > 0) continue;
    if (stream.aims_at_classes) {
      c.gaps.push_back({what, "no case was drawn", false});
    } else {
      const bool triangles = stream.operands == Operands::triangles;
      c.gaps.push_back({what,
                        triangles ? "no case of this class came up: this population does not aim at classes"
                                  : "no case with this exact contact came up: this population does not aim at contacts",
                        true});
    }
  }
}

/// Why no answer to a class came from a stage; empty if one should have. A filter certifies no vanishing sign, so a
/// class that has one can be decided by it only where another sign rejects first. The last stage is for operands too
/// wide for the one before, and few families are that wide.
std::string reason_of(Stage stage, ClassId id) {
  if (stage == Stage::filter && !is_generic(id)) return "a sign of the class vanishes, and no filter certifies a zero";
  if (stage == Stage::exact) return "no case of the class was too wide for the stage before";
  return "";
}

void add_stage_gaps(Certificate& c) {
  for (const Format format : {Format::binary64, Format::binary32}) {
    for (const Stage stage : c.stages) {
      const std::string where = std::string(tribunal::name_of(format)) + " stage " + c.word_of(stage);
      for (const Operands operands : {Operands::triangles, Operands::polygons}) {
        const Count all = c.coverage.total(format, operands);
        if (all.judged() > 0 && all.at(stage) == 0) c.gaps.push_back({where, "no answer came from this stage", false});
      }
      for (ClassId id = 1; id <= all_class_count; ++id) {
        if (c.coverage.at(format, id).judged() == 0 || c.coverage.at(format, id).at(stage) > 0) continue;
        const std::string reason = reason_of(stage, id);
        c.gaps.push_back({where + " " + class_name(id), reason.empty() ? "no answer came from this stage" : reason,
                          !reason.empty()});
      }
    }
  }
}

/// A sample that cannot make the naive methods fail says nothing about any other.
void add_calibration_gaps(Certificate& c) {
  for (const auto& [method, counts] : c.calibration) {
    if (counts.total().wrong == 0) c.gaps.push_back({"calibration", method + " was never wrong on this sample", false});
  }
}

void add_set_gaps(Certificate& c) {
  const bool of_a_file =
      c.proved.empty() && (c.has_own() || !c.nonfinite.empty());  // what judge writes: nothing else is due
  if (!of_a_file && c.sampled().judged() == 0) c.gaps.push_back({"sample", "the method answered none of it", false});
  if (c.has_own() && c.own().judged() == 0) {
    c.gaps.push_back({own_cases, "the method answered none of them", !of_a_file});
  }
  for (const ProvedSet& s : c.proved) {
    if (!s.complete || s.count.asked != s.size) c.gaps.push_back({s.name, "the set was not run whole", false});
    if (s.count.judged() == 0) {
      const bool promised = c.takes(s.of_rays);
      c.gaps.push_back({s.name, promised ? "the method answered none of it" : outside_contract(c), !promised});
    } else if (s.count.unsupported > 0) {
      const std::string what = s.name + ": " + std::to_string(s.count.unsupported) + " of " + std::to_string(s.size);
      c.gaps.push_back({what, outside_contract(c), true});
    }
  }
}

/// Whether the contract takes all that relations are about: then each of them speaks of some case.
bool takes_all_relations(const Certificate& c) {
  const Contract& k = c.contract;
  if (!k.probes.segments || !k.probes.rays) return false;
  if (c.operands() == Operands::polygons) return promises_all_polygons(k);
  return reads_point_sets(k) && k.triangles == Triangles::any && k.probes.bounds;
}

/// Relations that nothing was asked of, in either format and with either probe.
void add_relation_gaps(Certificate& c) {
  std::map<std::string, std::uint64_t> asked;
  for (const RelationRow& r : c.relations) asked[r.name] += r.asked;
  for (const auto& [name, n] : asked) {
    if (n > 0) continue;
    const bool promised = takes_all_relations(c);
    c.gaps.push_back({"relation " + name, promised ? "no instance of it came up" : outside_contract(c), !promised});
  }
}

/// The kinds of probe that the contract names must have been asked, at least in the sample.
void add_probe_gaps(Certificate& c) {
  if (c.proved.empty()) return;  // what judge writes is about the cases of a file
  for (const bool rays : {false, true}) {
    const char* const name = rays ? "rays" : "segments";
    if (!c.takes(rays)) {
      c.gaps.push_back({name, outside_contract(c), true});
      continue;
    }
    if (c.sampled(rays).judged() == 0) c.gaps.push_back({name, "in the contract, and the sample judged none", false});
    const auto whole = [&](const ProvedSet& s) { return s.of_rays == rays && s.count.judged() > 0; };
    if (std::ranges::none_of(c.proved, whole)) c.gaps.push_back({name, "no set that was run whole has any", true});
  }
}

Count total_of_rows(const Certificate& c, bool own, Format format) {
  Count total;
  for (const SampleRow& row : c.rows) {
    if ((row.family == own_cases) == own && row.format == format) total += total_of(row);
  }
  return total;
}

Count total_of_sets(const Certificate& c, bool rays) {
  Count total;
  for (const ProvedSet& s : c.proved) {
    if (s.of_rays == rays) total += s.count;
  }
  return total;
}

Verdict verdict_of(const Certificate& c) {
  const bool wrong_in_set = std::ranges::any_of(c.proved, [](const ProvedSet& s) { return s.count.wrong > 0; });
  if (wrong_in_set || c.sampled().wrong > 0 || c.own().wrong > 0) return Verdict::refuted;
  if (!c.broken_relations().empty() || c.all_nonfinite().answered > 0) return Verdict::refuted;
  const bool hole = std::ranges::any_of(c.gaps, [](const Gap& g) { return !g.explained; });
  return hole ? Verdict::incomplete : Verdict::not_refuted;
}

}  // namespace

std::string name_of(Verdict v) {
  constexpr const char* names[] = {"not refuted", "refuted", "incomplete"};
  return names[static_cast<int>(v)];
}

std::string Certificate::method() const { return Record(plan, {"log.jsonl"}).text("method"); }

std::uint64_t Certificate::seed() const { return Record(plan, {"log.jsonl"}).whole("seed"); }

std::uint64_t Certificate::version() const { return Record(plan, {"log.jsonl"}).count_or("version", 1); }

Operands Certificate::operands() const { return plan.contains("operands") ? Operands::polygons : Operands::triangles; }

std::size_t Certificate::sampled_strata() const {
  return static_cast<std::size_t>(std::ranges::count_if(strata, [this](const Stratum& s) { return !is_own(s); }));
}

std::string Certificate::word_of(Stage stage) const {
  const auto at = std::ranges::find(stages, stage) - stages.begin();
  return Record(plan, {"log.jsonl"}).items("stages").at(static_cast<std::size_t>(at)).text();
}

bool Certificate::has_own() const {
  return std::ranges::any_of(streams, [](const SampledStream& s) { return s.is_own(); });
}

Count Certificate::sampled(bool rays, Format format) const {
  Count total;
  for (const SampleRow& row : this->rows) {
    if (row.family != own_cases && row.format == format) total += total_of(row, rays);
  }
  return total;
}

Count Certificate::sampled(bool rays) const {
  return sampled(rays, Format::binary64) += sampled(rays, Format::binary32);
}

Count Certificate::sampled(Format format) const { return total_of_rows(*this, false, format); }

Count Certificate::sampled() const { return sampled(Format::binary64) += sampled(Format::binary32); }

Count Certificate::own(Format format) const { return total_of_rows(*this, true, format); }

Count Certificate::own() const { return own(Format::binary64) += own(Format::binary32); }

NonfiniteRow Certificate::all_nonfinite() const {
  NonfiniteRow all;
  for (const NonfiniteRow& row : nonfinite) {
    if (all.answered == 0) all.first = row.first;
    all.asked += row.asked;
    all.refused += row.refused;
    all.answered += row.answered;
  }
  return all;
}

std::vector<std::string> Certificate::broken_relations() const {
  std::vector<std::string> names;
  for (const RelationRow& r : relations) {
    if (r.broken > 0 && (names.empty() || names.back() != r.name)) names.push_back(r.name);
  }
  return names;
}

std::string Certificate::worst() const {
  std::vector<Counted> counts;
  for (const bool rays : {false, true}) {
    counts.push_back({rays ? "rays of whole sets" : "segments of whole sets", total_of_sets(*this, rays)});
  }
  for (const Format format : {Format::binary64, Format::binary32}) {
    const std::string name(tribunal::name_of(format));
    counts.push_back({"sampled " + name, sampled(format)});
    counts.push_back({"your own " + name, own(format)});
  }
  std::string text = headline(counts);
  if (const std::uint64_t n = all_nonfinite().answered; n > 0) {
    text += "; answers " + std::to_string(n) + " cases that are not finite";
  }
  const std::vector<std::string> broken = broken_relations();
  for (std::size_t i = 0; i < broken.size(); ++i) text += (i == 0 ? "; breaks relations " : ", ") + broken[i];
  return text;
}

Certificate certificate_from(const Log& log) {
  Certificate c{};
  c.log_head = log.head();
  LogReader(c, log);
  add_strata(c);
  add_coverage(c);
  add_set_gaps(c);
  add_relation_gaps(c);
  add_probe_gaps(c);
  add_stream_gaps(c);
  add_class_gaps(c);
  add_stage_gaps(c);
  add_calibration_gaps(c);
  c.verdict = verdict_of(c);
  return c;
}

void for_each_counterexample(const Log& log, const std::function<void(const Record&, const std::string&)>& visit) {
  log.for_each([&](const Record& r) {
    if (r.text("record") == "counterexample") visit(r, r.member("case").json().dump() + "\n");
  });
}

Certificate add_certificate(OutputSet& set, const std::string& directory, ChainedLog& log) {
  log.finish();
  const Log records(log);
  const Certificate c = certificate_from(records);
  OutputFile& text = set.open(directory + "/log.jsonl");
  log.text().for_each_piece([&](std::string_view piece) { text.write(piece); });
  OutputFile& cases = set.open(directory + "/counterexamples.jsonl");
  for_each_counterexample(records, [&](const Record&, const std::string& line) { cases.write(line); });
  set.add(directory + "/certificate.md", to_markdown(c));
  set.add(directory + "/certificate.json", to_json(c).dump(1) + "\n");
  return c;
}

Certificate write_certificate(const std::string& directory, ChainedLog& log) {
  OutputSet set;
  const Certificate c = add_certificate(set, directory, log);
  set.commit();
  return c;
}

}  // namespace tribunal
