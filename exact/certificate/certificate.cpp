// Makes a certificate of the records of a log: reads them, and derives strata, gaps and verdict.
#include "exact/certificate/certificate.h"

#include <algorithm>
#include <map>

#include "exact/base/output.h"
#include "exact/classes/class_table.h"
#include "exact/record/contract_json.h"
#include "exact/record/errors_json.h"

namespace tribunal {
namespace {

ProvedSet to_set(const Json& r, const Where& where) {
  const std::string probes = string_of(r, "probes", where);
  if (probes != "segment" && probes != "ray") where.key("probes").fail("expected \"segment\" or \"ray\"");
  return {.name = string_of(r, "set", where),
          .oracles = string_of(r, "judged_by", where),
          .answers_hash = string_of(r, "answers_hash", where),
          .of_rays = probes == "ray",
          .size = number_of(r, "size", where),
          .classes = number_of(r, "classes", where),
          .complete = truth_value_of(r, "complete", where),
          .count = to_count(require(r, "count", where), where.key("count"))};
}

RelationRow to_relation(const Json& r, const Where& where) {
  const std::string probes = string_of(r, "probes", where);
  if (probes != "segment" && probes != "ray") where.key("probes").fail("expected \"segment\" or \"ray\"");
  RelationRow row{.name = string_of(r, "relation", where),
                  .statement = string_of(r, "statement", where),
                  .format = format_of(r, where),
                  .of_rays = probes == "ray",
                  .cases = number_of(r, "cases", where),
                  .asked = number_of(r, "asked", where),
                  .broken = number_of(r, "broken", where),
                  .faults = number_of(r, "faults", where)};
  if (row.broken > row.asked || row.asked > row.cases || row.faults > row.cases - row.asked) {
    where.fail("counts that cannot be");
  }
  if (row.broken == 0) return row;
  row.first = number_of(r, "first", where);
  const Json& witness = require(r, "witness", where);
  if (!witness.is_array()) where.key("witness").fail("expected an array");
  row.witness.assign(witness.begin(), witness.end());
  return row;
}

NonfiniteRow to_nonfinite(const Json& r, const Where& where) {
  NonfiniteRow row{.format = format_of(r, where),
                   .asked = number_of(r, "asked", where),
                   .refused = number_of(r, "refused", where),
                   .answered = number_of(r, "answered", where)};
  if (row.refused > row.asked || row.answered > row.asked - row.refused) where.fail("counts that cannot be");
  if (row.answered > 0) row.first = string_of(r, "first", where);
  return row;
}

/// The operands of a record: triangles, unless it says otherwise.
Operands operands_in(const Json& r, const Where& where) {
  if (!r.contains("operands")) return Operands::triangles;
  if (string_of(r, "operands", where) != "polygons") where.key("operands").fail("expected \"polygons\" or no such key");
  return Operands::polygons;
}

SampledStream to_stream(const Json& r, const Where& where) {
  return {.family = string_of(r, "family", where),
          .format = format_of(r, where),
          .axis = string_of(r, "axis", where),
          .population = string_of(r, "population", where),
          .judged_by = string_of(r, "judged_by", where),
          .aims_at_classes = truth_value_of(r, "aims_at_classes", where),
          .taken = truth_value_of(r, "taken", where),
          .cases = number_of(r, "cases", where),
          .operands = operands_in(r, where)};
}

std::vector<Stage> to_stages(const Json& plan, const Where& where) {
  std::vector<Stage> stages;
  for (const Json& name : require(plan, "stages", where)) {
    const auto stage = name.is_string() ? stage_named(name.get_ref<const std::string&>()) : std::nullopt;
    if (stage) stages.push_back(*stage);
  }
  if (stages.size() != plan["stages"].size()) where.key("stages").fail("unknown stage");
  return stages;
}

void read(Certificate& c, const Json& r, const Where& where) {
  const std::string kind = string_of(r, "record", where);
  if (kind == "plan") {
    for (const char* key : {"method", "budget"}) string_of(r, key, where);
    if (r.contains("version")) number_of(r, "version", where);
    c.plan = r;
    c.contract = to_contract(require(r, "terms", where), where.key("terms"));
    c.stages = to_stages(r, where);
    operands_in(r, where);
  } else if (kind == "environment") {
    c.environment = r;
  } else if (kind == "budget") {
    c.budget = r;
  } else if (kind == "set") {
    c.proved.push_back(to_set(r, where));
  } else if (kind == "relation") {
    c.relations.push_back(to_relation(r, where));
  } else if (kind == "stream") {
    c.streams.push_back(to_stream(r, where));
  } else if (kind == "sample") {
    const SampleRow row = to_sample_row(r, where);
    if (c.plan.is_object() && row.method == c.method()) {
      c.rows.push_back(row);
    } else {
      c.calibration[row.method].of(row.format) += total_of(row);
    }
  } else if (kind == "errors") {
    c.errors.push_back({string_of(r, "family", where), format_of(r, where), to_errors(r, where)});
  } else if (kind == "nonfinite") {
    c.nonfinite.push_back(to_nonfinite(r, where));
  } else if (kind == "counterexample") {
    c.counterexamples.push_back(require(r, "case", where));
  } else {
    where.fail("unknown record \"" + kind + "\"");
  }
}

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

Operands Certificate::operands() const { return plan.contains("operands") ? Operands::polygons : Operands::triangles; }

std::size_t Certificate::sampled_strata() const {
  return static_cast<std::size_t>(std::ranges::count_if(strata, [this](const Stratum& s) { return !is_own(s); }));
}

std::string Certificate::word_of(Stage stage) const {
  const auto at = std::ranges::find(stages, stage) - stages.begin();
  return plan.at("stages").at(static_cast<std::size_t>(at));
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

Certificate certificate_from(const LogRecords& log, const std::string& path) {
  Certificate c{};
  c.log_head = log.head;
  for (std::size_t i = 0; i < log.records.size(); ++i) read(c, log.records[i], {path, i + 1});
  if (!c.plan.is_object() || !c.environment.is_object()) Where{path}.fail("missing the plan or the environment");
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

std::string counterexample_lines(const Certificate& c) {
  std::string lines;
  for (const Json& line : c.counterexamples) lines += line.dump() + "\n";
  return lines;
}

Certificate write_certificate(const std::string& directory, ChainedLog& log) {
  OutputSet set;
  const std::string text = log.finish();
  const Certificate c = certificate_from(log.so_far(), directory + "/log.jsonl");
  set.add(directory + "/log.jsonl", text);
  set.add(directory + "/counterexamples.jsonl", counterexample_lines(c));
  set.add(directory + "/certificate.md", to_markdown(c));
  set.add(directory + "/certificate.json", to_json(c).dump(1) + "\n");
  set.commit();
  return c;
}

}  // namespace tribunal
