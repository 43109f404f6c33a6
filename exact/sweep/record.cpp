#include "exact/sweep/record.h"

#include <algorithm>
#include <cstdio>

#include "exact/base/failure.h"
#include "exact/base/interrupt.h"
#include "exact/base/json.h"
#include "exact/base/output.h"
#include "exact/base/parallel.h"
#include "exact/certificate/bounds.h"
#include "exact/certificate/rate.h"
#include "exact/record/contract_json.h"
#include "exact/record/counterexample.h"
#include "exact/record/environment.h"

namespace tribunal {
namespace {

constexpr Format formats[] = {Format::binary32, Format::binary64};

// --- witnesses ------------------------------------------------------------------------------------------------------

std::string id_of(const SweepPlan& plan, const Threshold& t) {
  std::string id = plan.methods[t.method].name + "-" + std::string(plan.axes[t.axis]->name) + "-" +
                   std::string(name_of(t.format)) + "-" + std::to_string(t.first.value) + "-" +
                   std::string(name_of(t.probe)) + "-" + std::string(name_of(t.outcome));
  std::ranges::replace(id, ' ', '-');
  return id + (t.side == AxisSide::down ? "-down" : "");
}

std::string source_of(const SweepPlan& plan, const Threshold& t, const Witness& w) {
  return "sweep " + std::string(plan.axes[t.axis]->name) + " at " + std::to_string(t.first.value) + ", seed " +
         std::to_string(plan.seed) + ", case " + std::to_string(w.k);
}

Json origin_of(const SweepPlan& plan, const Threshold& t, const Witness& w) {
  return {{"axis", plan.axes[t.axis]->name},
          {"fmt", name_of(t.format)},
          {"seed", plan.seed},
          {"value", t.first.value},
          {"case", w.k}};
}

/// A ray at a mesh and the face that shows the error. It is not shrunk: what was wrong is how many faces of the mesh
/// were reported, and the answer about this one may be right by the method's convention.
Case mesh_witness_of(const SweepPlan& plan, const Threshold& t, const Witness& w) {
  const Truth truth = exact_truth(w.query);
  Case c{.format = t.format, .query = w.query, .source = source_of(plan, t, w)};
  c.expect = truth.hit();
  c.class_id = truth.class_id;
  c.finding = {{"method", plan.methods[t.method].name},
               {"outcome", name_of(t.outcome)},
               {"origin", origin_of(plan, t, w)},
               {"made_with", environment()}};
  return c;
}

Case witness_of(const SweepPlan& plan, const Threshold& t, const Witness& w) {
  const std::string source = source_of(plan, t, w);
  Case c{.format = t.format, .query = w.query, .source = source};
  if (plan.axes[t.axis]->is_of_mesh()) {
    c = mesh_witness_of(plan, t, w);
  } else if (t.outcome != SweptOutcome::refused) {
    c = to_counterexample(plan.methods[t.method], w.query, t.format, source, w.status);
    c.finding["origin"] = origin_of(plan, t, w);
  }
  c.id = id_of(plan, t);
  return c;
}

// --- JSON -----------------------------------------------------------------------------------------------------------

Json axis_json(const StressAxis& a) {
  Json values = Json::object(), easiest = Json::object();
  for (const Format f : formats) {
    values[std::string(name_of(f))] = a.values(f);
    easiest[std::string(name_of(f))] = a.easiest(f);
  }
  return {{"name", a.name},
          {"quantity", a.quantity},
          {"population", a.population},
          {"operands", a.is_of_mesh()                      ? "mesh"
                       : a.operands == Operands::triangles ? "triangles"
                                                           : "polygons"},
          {"probes", a.has_segments() ? Json{"segment", "ray"} : Json{"ray"}},
          {"spacing", a.spacing == Spacing::even ? "even" : "logarithmic"},
          {"easiest", easiest},
          {"values", values}};
}

Json share_json(std::uint64_t failures, std::uint64_t chances) {
  const Rate rate = rate_of(failures, chances);
  return {{"n", chances}, {"k", failures}, {"share", rate.share}, {"lower", rate.lower}, {"upper", rate.upper}};
}

/// Hits, misses and what rays at a mesh can show always; what else there was only where there was any.
bool is_said(const SweepCount& c, SweptOutcome o) {
  const bool always = c.mesh_rays > 0 ? o != SweptOutcome::fault : o <= SweptOutcome::false_miss;
  return c.chances(o) > 0 && (always || c.failures(o) > 0);
}

std::uint64_t plain_of(const SweepCount& c, SweptOutcome o) { return c.plain[static_cast<std::size_t>(o)]; }

Json place_json(const SweepPlan& plan, const SweepPlace& p) {
  return {{"method", plan.methods[p.method].name},
          {"axis", plan.axes[p.axis]->name},
          {"fmt", name_of(p.format)},
          {"value", p.value},
          {"probe", name_of(p.probe)}};
}

Json row_json(const SweepPlan& plan, const SweepPlace& place, const SweepCount& c) {
  Json row = place_json(plan, place);
  row["asked"] = c.count.asked;
  row["judged"] = c.count.judged();
  row["due_hits"] = c.due_hits;
  row["refused"] = c.count.refused;
  if (c.mesh_rays > 0) row["parity_judged"] = c.parity_judged;
  row["wrong"] = share_json(c.count.wrong, c.count.judged());
  for (const Severity s : all_severities) row[std::string(name_of(s))] = c.count.at(s);
  Json outcomes = Json::object();
  for (const SweptOutcome o : swept_outcomes) {
    if (!is_said(c, o)) continue;
    outcomes[std::string(name_of(o))] = share_json(c.failures(o), c.chances(o));
    outcomes[std::string(name_of(o))]["plain"] = plain_of(c, o);
  }
  row["outcomes"] = outcomes;
  return row;
}

Json mark_json(const Mark& m) {
  Json object = share_json(m.failures, m.chances);
  object["value"] = m.value;
  return object;
}

Json threshold_json(const SweepPlan& plan, const WitnessedThreshold& w) {
  const Threshold& t = w.threshold;
  return {{"method", plan.methods[t.method].name},
          {"axis", plan.axes[t.axis]->name},
          {"fmt", name_of(t.format)},
          {"side", name_of(t.side)},
          {"probe", name_of(t.probe)},
          {"outcome", name_of(t.outcome)},
          {"before", t.before ? mark_json(*t.before) : Json()},
          {"first", mark_json(t.first)},
          {"all", t.all ? mark_json(*t.all) : Json()},
          {"witness", w.witness.id}};
}

/// An array with each member on a line of its own.
std::string lines_of(const Json& array) {
  std::string text = "[";
  for (std::size_t i = 0; i < array.size(); ++i) text += (i == 0 ? "\n  " : ",\n  ") + array[i].dump();
  return text + (array.empty() ? "]" : "\n ]");
}

// --- the table ------------------------------------------------------------------------------------------------------

std::string verdict_of(const SweepPlan& plan, const Sweep& sweep, std::size_t method) {
  std::vector<Counted> totals;
  for (const Format f : formats) totals.push_back({std::string(name_of(f)), {}});
  for (const auto& [place, c] : sweep.counts) {
    if (place.method == method) totals[place.format == Format::binary32 ? 0 : 1].count += c.count;
  }
  std::erase_if(totals, [](const Counted& c) { return c.count.asked == 0; });
  return plan.methods[method].name + ": " + headline(totals) + "\n";
}

/// "-357: none (<= 0.46 %), -358: 12 of 656"; "0: 3 of 656" where the easiest value has some.
std::string beginning_of(const Threshold& t) {
  const std::string first = std::to_string(t.first.value) + ": " + std::to_string(t.first.failures) + " of " +
                            std::to_string(t.first.chances);
  if (!t.before) return first;
  char bound[32];
  std::snprintf(bound, sizeof bound, "%.2g", 100 * rate_of(0, t.before->chances).upper);
  return std::to_string(t.before->value) + ": none (<= " + bound + " %), " + first;
}

bool is_same_row(const Threshold& a, const Threshold& b) {
  return a.method == b.method && a.axis == b.axis && a.format == b.format && a.side == b.side && a.outcome == b.outcome;
}

std::string cell_of(const Threshold* t) {
  if (t == nullptr) return "";
  return beginning_of(*t) + (t->all ? "; all from " + std::to_string(t->all->value) : "");
}

/// One line for segments and rays; either may have none.
std::string line_of(const SweepPlan& plan, const Threshold& row, const Threshold* segments, const Threshold* rays) {
  const StressAxis& axis = *plan.axes[row.axis];
  const bool two_sided = !values_outward(axis, row.format, AxisSide::up).empty() &&
                         !values_outward(axis, row.format, AxisSide::down).empty();
  const std::string name = std::string(axis.name) + (two_sided ? row.side == AxisSide::up ? " +" : " -" : "");
  char line[256];
  std::snprintf(line, sizeof line, "  %-15s %-8s %-13s  %-48s  %s\n", name.c_str(),
                std::string(name_of(row.format)).c_str(), std::string(name_of(row.outcome)).c_str(),
                cell_of(segments).c_str(), cell_of(rays).c_str());
  return line;
}

/// The lines of one method.
std::string lines_of(const SweepPlan& plan, const std::vector<Threshold>& thresholds, std::size_t method) {
  char head[256];
  std::snprintf(head, sizeof head, "  %-15s %-8s %-13s  %-48s  %s\n", "axis", "format", "outcome", "segments", "rays");
  std::string text;
  for (std::size_t i = 0; i < thresholds.size(); ++i) {
    const Threshold& t = thresholds[i];
    if (t.method != method) continue;
    if (text.empty()) text = head;
    const bool paired = i + 1 < thresholds.size() && is_same_row(t, thresholds[i + 1]);
    const Threshold* const rays = paired ? &thresholds[i + 1] : t.probe == ProbeKind::ray ? &t : nullptr;
    text += line_of(plan, t, t.probe == ProbeKind::segment ? &t : nullptr, rays);
    i += paired;
  }
  return text;
}

}  // namespace

std::vector<WitnessedThreshold> with_witnesses(const SweepPlan& plan, const Sweep& sweep,
                                               const std::vector<Threshold>& thresholds) {
  std::vector<WitnessedThreshold> rows(thresholds.size());
  const auto work = [&](std::size_t i, unsigned) {
    const Threshold& t = thresholds[i];
    rows[i] = {t, witness_of(plan, t, sweep.witnesses.at({t.place(), t.outcome}))};
  };
  if (run_blocks(rows.size(), plan.threads, work) < rows.size()) {
    throw Failure(static_cast<Exit>(128 + interrupted()), "interrupted; no record written");
  }
  return rows;
}

std::string to_json_text(const SweepPlan& plan, const Sweep& sweep, const std::vector<WitnessedThreshold>& thresholds) {
  Json axes = Json::array(), rows = Json::array(), marks = Json::array();
  for (const StressAxis* a : plan.axes) axes.push_back(axis_json(*a));
  for (const auto& [place, count] : sweep.counts) rows.push_back(row_json(plan, place, count));
  for (const WitnessedThreshold& t : thresholds) marks.push_back(threshold_json(plan, t));
  const auto member = [](const char* name, const std::string& value) {
    return " \"" + std::string(name) + "\": " + value;
  };
  return "{\n" + member("seed", std::to_string(plan.seed)) + ",\n" + member("cases", std::to_string(plan.cases)) +
         ",\n" + member("confidence", Json(1 - confidence_alpha).dump()) + ",\n" +
         member("methods", lines_of(methods_json(plan.methods))) + ",\n" + member("axes", lines_of(axes)) + ",\n" +
         member("rows", lines_of(rows)) + ",\n" + member("thresholds", lines_of(marks)) + ",\n" +
         member("audited", std::to_string(sweep.audited)) + ",\n" + member("environment", environment().dump()) +
         "\n}\n";
}

std::string to_csv(const SweepPlan& plan, const Sweep& sweep) {
  std::string text = "axis,fmt,value,method,probe,outcome,n,failures,share,lower,upper,plain\n";
  const auto line = [&](const SweepPlace& p, std::string_view outcome, std::uint64_t k, std::uint64_t n,
                        std::uint64_t plain) {
    const Rate rate = rate_of(k, n);
    char numbers[160];
    std::snprintf(numbers, sizeof numbers, ",%llu,%llu,%.6g,%.6g,%.6g,%llu\n", static_cast<unsigned long long>(n),
                  static_cast<unsigned long long>(k), rate.share, rate.lower, rate.upper,
                  static_cast<unsigned long long>(plain));
    text += std::string(plan.axes[p.axis]->name) + "," + std::string(name_of(p.format)) + "," +
            std::to_string(p.value) + "," + plan.methods[p.method].name + "," + std::string(name_of(p.probe)) + "," +
            std::string(outcome) + numbers;
  };
  for (const auto& [place, c] : sweep.counts) {
    line(place, "wrong", c.count.wrong, c.count.judged(), c.count.at(Severity::plain));
    for (const SweptOutcome o : swept_outcomes) {
      if (is_said(c, o)) line(place, name_of(o), c.failures(o), c.chances(o), plain_of(c, o));
    }
  }
  return text;
}

std::string to_table(const SweepPlan& plan, const Sweep& sweep, const std::vector<Threshold>& thresholds) {
  std::string text;
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    text += verdict_of(plan, sweep, m) + lines_of(plan, thresholds, m) + "\n";
  }
  return text;
}

std::string mesh_file(const SweepPlan& plan) { return std::string(plan.of_mesh->axis->name) + ".off"; }

void write_record(const std::string& directory, const SweepPlan& plan, const Sweep& sweep,
                  const std::vector<WitnessedThreshold>& thresholds) {
  std::vector<Case> witnesses;
  for (const WitnessedThreshold& t : thresholds) witnesses.push_back(t.witness);
  OutputSet set;
  drop_figures(set, directory, sweep_figures);
  set.add(directory + "/sweep.csv", to_csv(plan, sweep));
  set.add(directory + "/witnesses.jsonl", to_lines(witnesses));
  if (plan.of_mesh) set.add(directory + "/" + mesh_file(plan), plan.of_mesh->off);
  set.add(directory + "/sweep.json", to_json_text(plan, sweep, thresholds));
  set.commit();
}

}  // namespace tribunal
