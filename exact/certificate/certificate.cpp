// From records to a certificate: reading, and what follows from what was read.
#include "exact/certificate/certificate.h"

#include <algorithm>
#include <set>

#include "exact/io/files.h"

namespace tribunal {
namespace {

ProvedSet to_set(const Json& r, const Where& where) {
  return {.name = string_of(r, "set", where),
          .oracles = string_of(r, "judged_by", where),
          .answers_hash = string_of(r, "answers_hash", where),
          .size = number_of(r, "size", where),
          .classes = number_of(r, "classes", where),
          .complete = truth_value_of(r, "complete", where),
          .count = to_count(require(r, "count", where), where.key("count"))};
}

SampledStream to_stream(const Json& r, const Where& where) {
  return {.family = string_of(r, "family", where),
          .format = format_of(r, where),
          .axis = string_of(r, "axis", where),
          .population = string_of(r, "population", where),
          .judged_by = string_of(r, "judged_by", where),
          .aims_at_classes = truth_value_of(r, "aims_at_classes", where),
          .taken = truth_value_of(r, "taken", where),
          .cases = number_of(r, "cases", where)};
}

std::vector<Stage> to_stages(const Json& plan, const Where& where) {
  std::vector<Stage> stages;
  for (const Json& name : require(plan, "stages", where)) {
    for (const Stage s : {Stage::filter, Stage::expansion, Stage::exact}) {
      if (name == name_of(s)) stages.push_back(s);
    }
  }
  if (stages.size() != plan["stages"].size()) where.key("stages").fail("unknown stage");
  return stages;
}

void read(Certificate& c, const Json& r, const Where& where) {
  const std::string kind = string_of(r, "record", where);
  if (kind == "plan") {
    for (const char* key : {"method", "convention", "contract", "budget"}) string_of(r, key, where);
    c.plan = r;
    c.stages = to_stages(r, where);
  } else if (kind == "environment") {
    c.environment = r;
  } else if (kind == "set") {
    c.proved.push_back(to_set(r, where));
  } else if (kind == "stream") {
    c.streams.push_back(to_stream(r, where));
  } else if (kind == "sample") {
    const SampleRow row = to_sample_row(r, where);
    if (c.plan.is_object() && row.method == c.method()) {
      c.rows.push_back(row);
    } else {
      c.calibration[row.method] += total_of(row);
    }
  } else if (kind == "counterexample") {
    c.counterexamples.push_back(require(r, "case", where));
  } else {
    where.fail("unknown record \"" + kind + "\"");
  }
}

bool belongs(const SampleRow& row, const SampledStream& stream) {
  return row.family == stream.family && row.format == stream.format;
}

std::string name_of(const SampledStream& s) { return s.family + " " + std::string(tribunal::name_of(s.format)); }

/// Every class of every stream that the method takes, empty ones too; rays only where there are some.
void add_strata(Certificate& c) {
  for (std::size_t i = 0; i < c.streams.size(); ++i) {
    if (!c.streams[i].taken) continue;
    std::vector<Count> counts(class_count + 1);
    for (const SampleRow& row : c.rows) {
      if (!belongs(row, c.streams[i])) continue;
      for (std::size_t id = 0; id <= class_count; ++id) counts[id] += row.counts[id];
    }
    for (std::size_t id = counts[0].asked > 0 ? 0 : 1; id <= class_count; ++id) {
      c.strata.push_back({i, static_cast<ClassId>(id), counts[id]});
    }
  }
}

void add_coverage(Certificate& c) {
  for (const Stratum& s : c.strata) c.coverage.add(c.streams[s.stream].format, s.class_id, s.count);
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

/// Every class × stream in which nothing was judged.
void add_class_gaps(Certificate& c) {
  for (const Stratum& s : c.strata) {
    if (s.count.judged() > 0) continue;
    const SampledStream& stream = c.streams[s.stream];
    const std::string what = name_of(stream) + " " + class_name(s.class_id);
    if (s.count.asked > 0) {
      c.gaps.push_back({what, "outside the method's contract: " + c.plan["contract"].get<std::string>(), true});
    } else if (stream.aims_at_classes) {
      c.gaps.push_back({what, "no case was drawn", false});
    } else {
      c.gaps.push_back({what, "no case of this class came up: this population does not aim at classes", true});
    }
  }
}

/// Why no answer to a class came from a stage; nothing if it should have. A filter certifies no vanishing sign, so a
/// class that has one can leave it only where another sign rejects first. The last stage is for operands too wide for
/// the one before, and few families are that wide.
std::string reason_of(Stage stage, ClassId id) {
  if (stage == Stage::filter && !is_generic(id)) return "a sign of the class vanishes, and no filter certifies a zero";
  if (stage == Stage::exact) return "no case of the class was too wide for the stage before";
  return "";
}

void add_stage_gaps(Certificate& c) {
  for (const Format format : {Format::binary64, Format::binary32}) {
    if (c.coverage.classes(format) == 0) continue;
    for (const Stage stage : c.stages) {
      const std::string where = std::string(tribunal::name_of(format)) + " stage " + std::string(name_of(stage));
      if (c.coverage.classes(format, stage) == 0) c.gaps.push_back({where, "no answer came from this stage", false});
      for (ClassId id = 1; id <= class_count; ++id) {
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
  for (const auto& [method, count] : c.calibration) {
    if (count.wrong == 0) c.gaps.push_back({"calibration", method + " was never wrong on this sample", false});
  }
}

void add_set_gaps(Certificate& c) {
  for (const ProvedSet& s : c.proved) {
    if (!s.complete || s.count.asked != s.size) c.gaps.push_back({s.name, "the set was not run whole", false});
  }
}

Verdict verdict_of(const Certificate& c) {
  const bool wrong_in_set = std::ranges::any_of(c.proved, [](const ProvedSet& s) { return s.count.wrong > 0; });
  if (wrong_in_set || c.sampled().wrong > 0) return Verdict::refuted;
  const bool hole = std::ranges::any_of(c.gaps, [](const Gap& g) { return !g.explained; });
  return hole ? Verdict::incomplete : Verdict::not_refuted;
}

}  // namespace

std::string name_of(Verdict v) {
  constexpr const char* names[] = {"not refuted", "refuted", "incomplete"};
  return names[static_cast<int>(v)];
}

Count Certificate::sampled() const {
  Count total;
  for (const SampleRow& row : rows) total += total_of(row);
  return total;
}

Certificate certificate_from(const LogRecords& log, const std::string& path) {
  Certificate c{};
  c.log_head = log.head;
  for (std::size_t i = 0; i < log.records.size(); ++i) read(c, log.records[i], {path, i + 1});
  if (!c.plan.is_object() || !c.environment.is_object()) Where{path}.fail("missing the plan or the environment");
  add_strata(c);
  add_coverage(c);
  add_set_gaps(c);
  add_stream_gaps(c);
  add_class_gaps(c);
  add_stage_gaps(c);
  add_calibration_gaps(c);
  c.verdict = verdict_of(c);
  return c;
}

std::string counterexample_lines(const Certificate& c) {
  std::string lines;
  for (const Json& line : c.counterexamples) lines += line.dump() + "\n";
  return lines;
}

Certificate write_certificate(const std::string& directory, ChainedLog& log) {
  const std::string path = directory + "/log.jsonl";
  write_file(path, log.finish());
  const Certificate c = certificate_from(read_log(path), path);
  write_file(directory + "/certificate.json", to_json(c).dump(1) + "\n");
  write_file(directory + "/certificate.md", to_markdown(c));
  write_file(directory + "/counterexamples.jsonl", counterexample_lines(c));
  return c;
}

}  // namespace tribunal
