// Writes a certificate as JSON, for programs.
#include <algorithm>
#include <functional>
#include <map>

#include "exact/certificate/bounds.h"
#include "exact/certificate/report_parts.h"
#include "exact/record/errors_json.h"

namespace tribunal {
namespace {

/// Adds what the wrong answers are, where there are any and the log says so.
void add_outcomes(Json& object, const Count& c) {
  if (c.wrong > c.unsaid() || c.refused > 0) object.update(outcomes_of(c));
}

Json to_json(const Count& c) {
  Json object = {{"asked", c.asked}, {"wrong", c.wrong}, {"unsupported", c.unsupported}};
  add_outcomes(object, c);
  return object;
}

Json to_json(const ProvedSet& s) {
  return {{"set", s.name},          {"probes", probes_word(s.of_rays)}, {"size", s.size},
          {"classes", s.classes},   {"answers_hash", s.answers_hash},   {"complete", s.complete},
          {"judged_by", s.oracles}, {"count", to_json(s.count)}};
}

/// Bounds hold for one stratum; the simultaneous ones for all at once (Bonferroni).
double simultaneous_alpha(const Certificate& c) { return confidence_alpha / static_cast<double>(c.sampled_strata()); }

bool of_triangles(Slot slot) { return operands_of(slot) == Operands::triangles; }

Json to_json(const Certificate& c, const Stratum& s) {
  const SampledStream& stream = c.streams[s.stream];
  Json row;
  row[of_triangles(s.slot) ? "class" : "case"] = slot_name(s.slot);
  row["probe"] = probes_word(is_of_rays(s.slot));
  row["family"] = stream.family;
  row["fmt"] = name_of(stream.format);
  row["n"] = s.count.judged();
  row["k"] = s.count.wrong;
  row["unsupported"] = s.count.unsupported;
  add_outcomes(row, s.count);
  for (const Stage stage : c.stages) row["from_" + c.word_of(stage)] = s.count.at(stage);
  if (c.is_own(s)) return row;
  row["upper_95"] = upper_bound(s.count.wrong, s.count.judged(), confidence_alpha);
  row["upper_95_simultaneous"] = upper_bound(s.count.wrong, s.count.judged(), simultaneous_alpha(c));
  return row;
}

Json proved_json(const Certificate& c) {
  Json rows = Json::array();
  for (const ProvedSet& s : c.proved) rows.push_back(to_json(s));
  return rows;
}

/// Both bounds are one-sided, at 95 % each.
Json to_json(const RelationRow& r) {
  Json row = {{"relation", r.name},
              {"statement", r.statement},
              {"fmt", name_of(r.format)},
              {"probe", probes_word(r.of_rays)},
              {"n", r.asked},
              {"broken", r.broken},
              {"lower_95", lower_bound(r.broken, r.asked, confidence_alpha)},
              {"upper_95", upper_bound(r.broken, r.asked, confidence_alpha)}};
  if (r.faults > 0) row["faults"] = r.faults;
  if (r.broken > 0) row["witness"] = r.witness;
  return row;
}

Json relations_json(const Certificate& c) {
  Json rows = Json::array();
  for (const RelationRow& r : c.relations) rows.push_back(to_json(r));
  return rows;
}

Json errors_json(const Certificate& c) {
  Json rows = Json::array();
  for (const ErrorRow& e : c.errors) {
    Json row = {{"family", e.family}, {"fmt", name_of(e.format)}};
    row.update(from_errors(e.errors));
    rows.push_back(row);
  }
  return rows;
}

Json streams_json(const Certificate& c) {
  Json rows = Json::array();
  for (const SampledStream& s : c.streams) {
    rows.push_back({{"family", s.family},
                    {"fmt", name_of(s.format)},
                    {"population", s.population},
                    {"judged_by", s.judged_by},
                    {"cases", s.cases}});
  }
  return rows;
}

/// Of the sampled strata, or of one's own cases.
Json strata_json(const Certificate& c, bool own) {
  Json rows = Json::array();
  for (const Stratum& s : c.strata) {
    if (c.is_own(s) == own && s.count.judged() > 0) rows.push_back(to_json(c, s));
  }
  return rows;
}

Json gaps_json(const Certificate& c) {
  Json rows = Json::array();
  for (const Gap& g : c.gaps) rows.push_back({{"what", g.what}, {"reason", g.reason}, {"explained", g.explained}});
  return rows;
}

Json calibration_json(const Certificate& c) {
  Json rows = Json::object();
  for (const auto& [method, counts] : c.calibration) {
    if (!c.says_outcomes()) rows[method] = to_json(counts.total());
    for (const Format format : both_formats) {
      if (c.says_outcomes() && counts.of(format).asked > 0) {
        rows[method][std::string(name_of(format))] = to_json(counts.of(format));
      }
    }
  }
  return rows;
}

/// Of one's own cases that are not finite.
Json nonfinite_json(const Certificate& c) {
  Json rows = Json::array();
  for (const NonfiniteRow& r : c.nonfinite) {
    rows.push_back({{"fmt", name_of(r.format)}, {"asked", r.asked}, {"refused", r.refused}, {"answered", r.answered}});
    if (r.answered > 0) rows.back()["first"] = r.first;
  }
  return rows;
}

Json coverage_json(const Certificate& c, Format format, const SlotGroup& group, const char* judged) {
  Json row = {{judged, c.coverage.judged(format, group)}, {"of", group.size}};
  if (!group.finest) return row;
  for (const Stage stage : c.stages) {
    row["from_" + c.word_of(stage)] = c.coverage.judged(format, group, stage);
  }
  return row;
}

/// The classes of the group: the 163 of segments, or those of rays.
Json classes_json(const Certificate& c, const SlotGroup& group) {
  Json rows = Json::object();
  for (const Format format : {Format::binary64, Format::binary32}) {
    rows[std::string(name_of(format))] = coverage_json(c, format, group, "classes");
  }
  return rows;
}

Json polygons_json(const Certificate& c) {
  Json rows = Json::object();
  for (const Format format : {Format::binary64, Format::binary32}) {
    for (const SlotGroup& group : c.coverage.groups(Operands::polygons)) {
      rows[std::string(name_of(format))][group.name] = coverage_json(c, format, group, "judged");
    }
  }
  return rows;
}

}  // namespace

Json environment_json(const Certificate& c) {
  Json e = c.environment;
  e.erase("record");
  return e;
}

Json to_json(const Certificate& c) {
  Json object = c.plan;
  object.erase("record");
  object["convention"] = name_of(c.contract.convention);
  object["contract"] = in_words(c.contract);
  object["verdict"] = name_of(c.verdict);
  if (c.says_outcomes()) object["worst"] = c.worst();
  const bool polygons = c.coverage.has(Operands::polygons);
  if (!polygons || c.coverage.has(Operands::triangles)) {
    object["classes_judged"] = classes_json(c, slot_groups(Operands::triangles)[0]);
    object["ray_classes_judged"] = classes_json(c, slot_groups(Operands::triangles)[1]);
  }
  if (polygons) object["polygons_judged"] = polygons_json(c);
  object["proved"] = proved_json(c);
  if (!c.relations.empty()) object["relations"] = relations_json(c);
  if (!c.errors.empty()) object["errors"] = errors_json(c);
  object["streams"] = streams_json(c);
  object["sampled"] = strata_json(c, false);
  if (c.has_own()) object["own_cases"] = strata_json(c, true);
  if (!c.nonfinite.empty()) object["nonfinite_cases"] = nonfinite_json(c);
  object["not_covered"] = gaps_json(c);
  object["calibration"] = calibration_json(c);
  object["counterexamples"] = c.counterexamples;
  if (!c.faults.empty()) object["faults"] = c.faults;
  object["environment"] = environment_json(c);
  object["log_sha256"] = c.log_head;
  return object;
}

}  // namespace tribunal
