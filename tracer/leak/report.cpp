#include "tracer/leak/report.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "exact/record/environment.h"
#include "exact/trial/truth.h"

namespace tribunal::leak {
namespace {

double per_million(std::uint64_t n, std::uint64_t rays) {
  return rays == 0 ? 0 : 1e6 * static_cast<double>(n) / static_cast<double>(rays);
}

/// "12.3"; 0 is exactly none.
std::string rate(std::uint64_t n, std::uint64_t rays) {
  if (n == 0) return "0";
  char text[40];
  const double r = per_million(n, rays);
  std::snprintf(text, sizeof text, r < 99.95 ? "%.1f" : "%.0f", r);
  return text;
}

/// A column of the table. `told`: whether the subject says what the outcome is about.
struct Column {
  const char* heading;
  Outcome outcome;
  bool (*told)(const Subject&);
};

bool tells_hits(const Subject& s) { return s.tells_hits; }
bool tells_parity(const Subject& s) { return s.tells_parity; }
bool tells_closest(const Subject& s) { return s.tells_closest; }
bool tells_order(const Subject& s) { return s.tells_closest || s.sorted; }
bool tells_t(const Subject& s) { return s.most_ulps > 0; }
bool tells_normals(const Subject& s) { return s.tells_normals; }
bool may_fail(const Subject&) { return true; }

constexpr Column columns[] = {
    {"leaks", Outcome::leak, tells_hits},
    {"lost", Outcome::lost, tells_hits},
    {"false", Outcome::false_hit, tells_hits},
    {"double", Outcome::double_hit, tells_hits},
    {"parity", Outcome::parity, tells_parity},
    {"closest", Outcome::closest, tells_closest},
    {"order", Outcome::order, tells_order},
    {"t", Outcome::wrong_t, tells_t},
    {"normal", Outcome::wrong_normal, tells_normals},
    {"fault", Outcome::fault, may_fail},
    {"neighbour", Outcome::neighbour, tells_hits},
    {"twice", Outcome::twice, tells_hits},
    {"outline", Outcome::outline, tells_hits},
};

/// The columns that say something: t and normals where a subject tells them, faults where there was one.
std::vector<Column> columns_of(const std::vector<Subject>& subjects, const LeakReport& report) {
  std::vector<Column> chosen;
  for (const Column& c : columns) {
    const bool rare = c.outcome == Outcome::wrong_t || c.outcome == Outcome::wrong_normal;
    if (rare && std::ranges::none_of(subjects, c.told)) continue;
    const auto failed = [](const SubjectReport& s) { return !s.faults.empty(); };
    if (c.outcome == Outcome::fault && std::ranges::none_of(report.subjects, failed)) continue;
    chosen.push_back(c);
  }
  return chosen;
}

std::string heading(const std::vector<Column>& chosen, bool by_aim) {
  std::string text = "per million rays                   format    ";
  char cell[32];
  if (by_aim) text += "aimed at ";
  for (const Column& c : chosen) {
    std::snprintf(cell, sizeof cell, " %9s", c.heading);
    text += cell;
  }
  return text + "\n";
}

std::string row(const std::vector<Column>& chosen, const Subject& subject, const std::string& name, Format format,
                const AimTally& tally, const char* aim) {
  char cell[64];
  std::snprintf(cell, sizeof cell, "%-34s %-10s", name.c_str(), std::string(name_of(format)).c_str());
  std::string text = cell;
  if (aim != nullptr) {
    std::snprintf(cell, sizeof cell, "%-9s", aim);
    text += cell;
  }
  for (const Column& c : chosen) {
    const bool parity = c.outcome == Outcome::parity;
    const std::uint64_t of = parity ? tally.parity_judged : tally.rays;
    const bool judged = c.told(subject) && (!parity || of > 0);
    std::snprintf(cell, sizeof cell, " %9s", judged ? rate(tally[c.outcome], of).c_str() : "-");
    text += cell;
  }
  return text + "\n";
}

/// "all aimed at edges", or "3.1 of those aimed at vertices, 12.0 at edges".
std::string by_aim(const LeakTally& tally) {
  constexpr const char* plurals[] = {"vertices", "edges", "faces", "what is not said"};
  std::string text;
  std::size_t aims = 0, last = 0;
  for (std::size_t a = 0; a < tally.by_aim.size(); ++a) {
    const AimTally& t = tally.by_aim[a];
    if (t[Outcome::leak] == 0) continue;
    const std::string how_often = rate(t[Outcome::leak], t.rays);
    text += (aims++ == 0 ? how_often + " of those aimed at " : ", " + how_often + " at ") + plurals[a];
    last = a;
  }
  return aims == 1 ? "all aimed at " + std::string(plurals[last]) : text;
}

/// Errors beside leaks, as the verdict names them.
struct ErrorName {
  Outcome outcome;
  const char* text;
};

constexpr ErrorName error_names[] = {
    {Outcome::false_hit, "false hits"},       {Outcome::double_hit, "double hits"},
    {Outcome::closest, "wrong closest"},      {Outcome::order, "wrong order"},
    {Outcome::parity, "wrong parity"},        {Outcome::wrong_t, "t beyond its promise"},
    {Outcome::wrong_normal, "wrong normals"}, {Outcome::fault, "faults"}};

std::string other_errors(const AimTally& all) {
  std::string text;
  for (const auto& [outcome, name] : error_names) {
    if (all[outcome] == 0) continue;
    const std::uint64_t of = outcome == Outcome::parity ? all.parity_judged : all.rays;
    text += (text.empty() ? "; " : ", ") + std::string(name) + " " + rate(all[outcome], of);
  }
  return text;
}

Json tally_json(const AimTally& t) {
  Json object = {{"rays", t.rays}, {"parity_judged", t.parity_judged}};
  for (const Outcome o : all_outcomes) object[std::string(name_of(o))] = t[o];
  return object;
}

/// Numbers of faces that have a count, the largest first.
std::vector<std::uint32_t> by_count(const std::vector<std::uint32_t>& counts) {
  std::vector<std::uint32_t> faces;
  for (std::uint32_t f = 0; f < counts.size(); ++f) {
    if (counts[f] > 0) faces.push_back(f);
  }
  std::ranges::stable_sort(faces, [&](std::uint32_t a, std::uint32_t b) { return counts[a] > counts[b]; });
  return faces;
}

/// The faces with the most leaks, with their corners, so that whoever reads it can show where they are.
Json worst_json(const Surface& surface, const SubjectReport& report, std::size_t most) {
  Json faces = Json::array();
  for (const std::uint32_t f : by_count(report.leaks_at)) {
    if (faces.size() == most) break;
    const auto& [a, b, c] = surface.triangle(f);
    faces.push_back(
        {{"face", f}, {"leaks", report.leaks_at[f]}, {"tri", {from_point(a), from_point(b), from_point(c)}}});
  }
  return faces;
}

}  // namespace

std::string table(const std::vector<Subject>& subjects, const LeakReport& report, Format format, bool each_aim) {
  const std::vector<Column> chosen = columns_of(subjects, report);
  std::string text = heading(chosen, each_aim);
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const LeakTally& tally = report.subjects[i].tally;
    text += row(chosen, subjects[i], subjects[i].name, format, tally.all(), each_aim ? "all" : nullptr);
    for (const Aim a : all_aims) {
      if (each_aim) text += row(chosen, subjects[i], "", format, tally[a], std::string(name_of(a)).c_str());
    }
  }
  return text;
}

namespace {

std::string basis(const Surface& surface, const LeakReport& trial, const LeakTally& tally) {
  const std::uint64_t at_edges = tally[Aim::vertex].rays + tally[Aim::edge].rays;
  return std::string(surface.topology().closed() ? " (closed mesh; " : " (open mesh; ") + std::to_string(trial.rays) +
         " of " + std::to_string(trial.rays + trial.skipped) + " rays judged, " + std::to_string(at_edges) +
         " aimed at vertices and edges, " + std::to_string(trial.exactly) + " exactly through one)";
}

std::string verdict_line(const Surface& surface, const Subject& subject, const LeakReport& trial,
                         const SubjectReport& report) {
  const AimTally all = report.tally.all();
  const std::string who = subject.name + ", " + std::string(name_of(surface.format())) + " rays: ";
  if (all[Outcome::fault] == all.rays) return who + "no answer to any of these " + std::to_string(all.rays) + " rays\n";
  if (!subject.tells_hits) {
    const std::string of = std::to_string(all.parity_judged) + " rays";
    const std::string faults = all[Outcome::fault] == 0 ? "" : "; faults " + rate(all[Outcome::fault], all.rays);
    if (all[Outcome::parity] == 0) return who + "right about inside and outside on these " + of + faults + "\n";
    return who + "wrong about inside and outside: " + rate(all[Outcome::parity], all.parity_judged) +
           " per million of these " + of + faults + "\n";
  }
  if (all[Outcome::leak] == 0 && all[Outcome::fault] > 0) {
    return who + "no leak where it answered, but faults: " + rate(all[Outcome::fault], all.rays) +
           " per million of these " + std::to_string(all.rays) + " rays" + other_errors(all) + "\n";
  }
  if (all[Outcome::leak] == 0) {
    return who + (surface.topology().closed() ? "watertight" : "no leak") + " on these " + std::to_string(all.rays) +
           " rays" + other_errors(all) + basis(surface, trial, report.tally) + "\n";
  }
  return who + "leaks: " + rate(all[Outcome::leak], all.rays) + " per million rays, " + by_aim(report.tally) +
         other_errors(all) + "\n";
}

}  // namespace

std::string verdict(const Surface& surface, const Subject& subject, const LeakReport& trial,
                    const SubjectReport& report) {
  std::string text = verdict_line(surface, subject, trial, report);
  for (const auto& [fault, rays] : report.faults) {
    text += "  FAULT: " + fault + " on " + std::to_string(rays) + " rays\n";
  }
  return text;
}

bool has_erred(const SubjectReport& report) {
  const AimTally all = report.tally.all();
  return std::ranges::any_of(all_outcomes, [&](Outcome o) { return is_error(o) && all[o] > 0; });
}

Json summary(const Surface& surface, const std::vector<Subject>& subjects, const LeakReport& report) {
  Json rows = Json::array();
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const SubjectReport& s = report.subjects[i];
    Json aims = Json::object();
    for (const Aim a : all_aims) aims[std::string(name_of(a))] = tally_json(s.tally[a]);
    if (s.tally[Aim::unsaid].rays > 0) aims["unsaid"] = tally_json(s.tally[Aim::unsaid]);
    Json row = {
        {"name", subjects[i].name}, {"judged", subjects[i].told}, {"all", tally_json(s.tally.all())}, {"by_aim", aims}};
    if (s.worst_ulps > 0) row["worst_t_ulps"] = s.worst_ulps;
    if (s.worst_degrees > 0) row["worst_normal_degrees"] = s.worst_degrees;
    if (!s.faults.empty()) row["faults"] = s.faults;
    if (Json faces = worst_json(surface, s, 20); !faces.empty()) row["worst_faces"] = std::move(faces);
    if (!subjects[i].tells_parity) row["all"].erase("parity");
    rows.push_back(std::move(row));
  }
  return {{"fmt", name_of(surface.format())},
          {"topology", describe(surface.topology())},
          {"closed", surface.topology().closed()},
          {"faces", surface.face_count()},
          {"rays", report.rays},
          {"from_inside", report.inside},
          {"exactly_through_edges_or_vertices", report.exactly},
          {"skipped", report.skipped},
          {"subjects", rows}};
}

std::string worst_faces(const SubjectReport& report, std::size_t most) {
  std::string text;
  const auto faces = by_count(report.leaks_at);
  for (std::size_t i = 0; i < std::min(most, faces.size()); ++i) {
    text += (i == 0 ? "  worst faces (leaks): " : ", ") + std::to_string(faces[i]) + " (" +
            std::to_string(report.leaks_at[faces[i]]) + ")";
  }
  return text.empty() ? "" : text + "\n";
}

std::vector<Case> cases_of(const Surface& surface, const Subject& subject, const SubjectReport& report,
                           const std::string& mesh, std::uint64_t seed) {
  std::vector<Case> cases;
  for (const auto& [outcome, findings] : report.findings) {
    for (const LeakFinding& f : findings) {
      Case c{.format = surface.format(), .query = {f.aimed.ray, surface.triangle(f.face)}};
      const Truth truth = exact_truth(c.query);
      std::string what(name_of(outcome));
      std::ranges::replace(what, ' ', '-');
      c.id = subject.name + "-" + what + "-" + std::string(name_of(surface.format())) + "-" + std::to_string(f.k);
      c.expect = truth.hit();
      c.class_id = truth.class_id;
      c.source = "leak trial of " + mesh;
      c.finding = {{"method", subject.name},
                   {"outcome", name_of(outcome)},
                   {"origin",
                    {{"mesh", mesh},
                     {"face", f.face},
                     {"seed", seed},
                     {"ray", f.k},
                     {"aimed_at", std::string(name_of(f.aimed.aim)) + " " + std::to_string(f.aimed.at)}}},
                   {"made_with", environment()}};
      if (!f.fault.empty()) c.finding["detail"] = f.fault;
      cases.push_back(std::move(c));
    }
  }
  return cases;
}

}  // namespace tribunal::leak
