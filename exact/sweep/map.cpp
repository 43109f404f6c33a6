#include "exact/sweep/map.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "exact/base/failure.h"
#include "exact/base/interrupt.h"
#include "exact/base/json.h"
#include "exact/base/parallel.h"
#include "exact/base/progress.h"
#include "exact/cases/case_io.h"
#include "exact/cases/families/shapes.h"
#include "exact/record/environment.h"
#include "exact/trial/judge.h"

namespace tribunal {
namespace {

constexpr double middle = 0.75;

/// Decimal numbers, so that their significands are full; x and y of one point are the same number, and the point lies
/// in the plane x = y exactly.
Point3 in_diagonal(double xy, double z, Format format) { return in_format(Point3{xy, xy, z}, format); }
Point3 beside(double x, double y, double z, Format format) { return in_format(Point3{x, y, z}, format); }

/// The edge a b and the segment lie in the plane x = y and cross there; the triangle is on the side x > y.
SegmentPair at_edge(Format f) {
  return {{in_diagonal(middle, -1.3, f), in_diagonal(24, 24.4, f)},
          {in_diagonal(8.8, -7.3, f), in_diagonal(17.3, 41.7, f), beside(20.7, 3.2, 5.1, f)}};
}

/// The source, the vertex a and the target are p, p + 8·v and p + 24·v, exactly, with v in multiples of 2⁻¹⁴.
SegmentPair at_vertex(Format f) {
  const Point3 p{middle, middle, -1.25};
  const Point3 v = Point3{18023, 14747, 21299} * 0x1p-14;
  const Point3 a = p + 8.0 * v;
  return {{p, p + 24.0 * v}, {a, in_format(a + Point3{3.3, -7.7, 2.1}, f), in_format(a + Point3{6.1, 5.3, -4.9}, f)}};
}

/// All five points lie in the plane x = y, and the segment runs from outside through the triangle and out again.
SegmentPair in_the_plane(Format f) {
  return {{in_diagonal(middle, -1.3, f), in_diagonal(24, 24.4, f)},
          {in_diagonal(8.8, -7.3, f), in_diagonal(17.3, 21.7, f), in_diagonal(12.1, 30.3, f)}};
}

/// The triangle lies in the plane x = y and has the source inside; the target is on the side x > y.
SegmentPair at_end(Format f) {
  return {{in_diagonal(middle, 1.7, f), beside(24, 3.1, 5.7, f)},
          {in_diagonal(-8.8, -7.3, f), in_diagonal(17.3, -3.1, f), in_diagonal(2.3, 30.3, f)}};
}

constexpr MapContact contacts[] = {
    {"edge", "the probe meets an edge of the triangle; exactly, it is a hit on and below the diagonal", at_edge},
    {"vertex", "the probe meets a vertex of the triangle; exactly, it is a hit in a wedge from the middle", at_vertex},
    {"plane", "the probe lies in the triangle's plane; exactly, it is a hit on the diagonal alone, in the plane",
     in_the_plane},
    {"end", "the probe begins in the triangle; exactly, it is a hit on and above the diagonal", at_end},
};

/// A unit in the last place of numbers from 1/2 to 1.
double unit_of(Format format) { return std::ldexp(1.0, -digits_of(format)); }

constexpr Format formats[] = {Format::binary32, Format::binary64};

bool is_asked(const MapPlan& plan, Format format) {
  return std::ranges::any_of(plan.methods, [&](const Method& m) { return m.contract.format == format; });
}

Truth truth_of_pixel(const Query& query, ClassBy quick) {
  return quick == nullptr ? exact_truth(query) : truth_in_class(quick(query), query);
}

/// One row of pixels: the truth in each format and every method's answers.
void fill_row(const MapPlan& plan, int y, ClassBy quick, FailureMap& map) {
  for (auto& [format, rows] : map.truth) {
    for (int x = 0; x < plan.map.size; ++x) {
      const Query query = query_of_pixel(plan.map, format, x, y);
      const Truth truth = truth_of_pixel(query, quick);
      rows[static_cast<std::size_t>(y)] += truth.hit() ? 'h' : '.';
      for (MapPanel& panel : map.panels) {
        const Method& method = plan.methods[panel.method];
        if (method.contract.format != format) continue;
        const Answer answer = method.ask(query);
        panel.pixels[static_cast<std::size_t>(y)] += character_of(judge(method, truth, answer), answer.hit);
      }
    }
  }
}

/// The characters of answers that are not right.
struct Character {
  char character;
  Outcome outcome;
};

constexpr Character characters[] = {{'+', Outcome::false_hit},     {'-', Outcome::false_miss},
                                    {'c', Outcome::wrong_contact}, {'x', Outcome::fault},
                                    {'?', Outcome::refused},       {' ', Outcome::not_owed}};

Outcome outcome_of(char c) {
  const auto found = std::ranges::find(characters, c, &Character::character);
  return found == std::end(characters) ? Outcome::right : found->outcome;
}

void count_pixels(MapPanel& panel) {
  for (const std::string& row : panel.pixels) {
    for (const char c : row) ++panel.counts[outcome_of(c)];
  }
}

std::string rows_text(const std::vector<std::string>& rows) {
  std::string text = "[";
  for (std::size_t i = 0; i < rows.size(); ++i) text += (i == 0 ? "\n   " : ",\n   ") + Json(rows[i]).dump();
  return text + "]";
}

/// The case of the pixel in the middle, as a case file has it but for its id and format.
std::string base_text(const MapKind& kind, Format format) {
  Json base = from_case({.format = format, .query = query_of_pixel(kind, format, kind.size / 2, kind.size / 2)});
  base.erase("id");
  base.erase("fmt");
  return base.dump();
}

/// Of each format that is asked, what `member` makes of it, as an object.
template <class Member>
std::string by_format(const FailureMap& map, const Member& member) {
  std::string text = "{";
  for (const auto& [format, rows] : map.truth) {
    text += (text.size() > 1 ? ",\n  " : "\n  ") + Json(name_of(format)).dump() + ": " + member(format);
  }
  return text + "}";
}

std::string panel_text(const Method& m, const MapPanel& panel) {
  Json counts = Json::object();
  for (const auto& [outcome, n] : panel.counts) counts[std::string(name_of(outcome))] = n;
  return "  {\"method\": " + Json(m.name).dump() + ", \"fmt\": " + Json(name_of(m.contract.format)).dump() +
         ", \"convention\": " + Json(name_of(m.contract.convention)).dump() + ", \"counts\": " + counts.dump() +
         ",\n   \"pixels\": " + rows_text(panel.pixels) + "}";
}

}  // namespace

std::span<const MapContact> all_map_contacts() { return contacts; }

const MapContact* find_map_contact(std::string_view name) {
  const auto found = std::ranges::find(contacts, name, &MapContact::name);
  return found == std::end(contacts) ? nullptr : &*found;
}

Point3 moved_on_map(const Point3& p, Format format, int x, int y) {
  return {p.x + x * unit_of(format), p.y + y * unit_of(format), p.z};
}

std::string MapKind::name() const { return std::string(contact->name) + (probe == ProbeKind::ray ? "-ray" : ""); }

Query query_of_pixel(const MapKind& map, Format format, int x, int y) {
  const SegmentPair pair = map.contact->at(format);
  const Point3 source = moved_on_map(pair.segment.p, format, x - map.size / 2, y - map.size / 2);
  if (map.probe == ProbeKind::segment) return {Segment{source, pair.segment.q}, pair.triangle};
  return {Ray{source, {in_format(pair.segment.q - pair.segment.p, format)}}, pair.triangle};
}

char character_of(Outcome outcome, bool hit) {
  const auto found = std::ranges::find(characters, outcome, &Character::outcome);
  return found != std::end(characters) ? found->character : hit ? 'H' : 'M';
}

FailureMap failure_map(const MapPlan& plan) {
  const auto rows = static_cast<std::size_t>(plan.map.size);
  FailureMap map;
  for (const Format format : formats) {
    if (is_asked(plan, format)) map.truth[format].resize(rows);
  }
  for (std::size_t m = 0; m < plan.methods.size(); ++m) map.panels.push_back({m, std::vector<std::string>(rows), {}});
  const ClassBy quick = quick_class_for(plan.methods, Operands::triangles);
  Progress progress("map " + plan.map.name(), "rows", rows);
  const auto work = [&](std::size_t y, unsigned) {
    fill_row(plan, static_cast<int>(y), quick, map);
    progress.add(1);
  };
  if (run_blocks(rows, plan.threads, work) < rows) {
    throw Failure(static_cast<Exit>(128 + interrupted()), "interrupted; no map written");
  }
  for (MapPanel& panel : map.panels) count_pixels(panel);
  return map;
}

std::string to_json_text(const MapPlan& plan, const FailureMap& map) {
  std::string text =
      "{\n \"map\": " + Json(plan.map.contact->name).dump() + ",\n \"probe\": " + Json(name_of(plan.map.probe)).dump() +
      ",\n \"about\": " + Json(plan.map.contact->about).dump() + ",\n \"size\": " + std::to_string(plan.map.size) +
      ",\n \"moved\": \"x and y of the source, by units in the last place\"";
  text += ",\n \"base\": " + by_format(map, [&](Format f) { return base_text(plan.map, f); });
  text += ",\n \"unit\": " + by_format(map, [](Format f) { return Json(hex_float(unit_of(f))).dump(); });
  text += ",\n \"truth\": " + by_format(map, [&](Format f) { return rows_text(map.truth.at(f)); });
  text += ",\n \"panels\": [";
  bool first = true;
  for (const MapPanel& panel : map.panels) {
    text += (first ? "\n" : ",\n") + panel_text(plan.methods[panel.method], panel);
    first = false;
  }
  return text + "],\n \"environment\": " + environment().dump() + "\n}\n";
}

std::string to_table(const MapPlan& plan, const FailureMap& map) {
  std::string text = plan.map.name() + ": " + std::string(plan.map.contact->about) + "\n";
  char line[160];
  std::snprintf(line, sizeof line, "  %-22s %-9s %8s %10s %11s %14s %6s %8s %9s\n", "method", "format", "right",
                "false hit", "false miss", "wrong contact", "fault", "refused", "not owed");
  text += line;
  for (const MapPanel& panel : map.panels) {
    const auto n = [&](Outcome o) {
      const auto found = panel.counts.find(o);
      return found == panel.counts.end() ? 0ULL : static_cast<unsigned long long>(found->second);
    };
    const Method& m = plan.methods[panel.method];
    std::snprintf(line, sizeof line, "  %-22s %-9s %8llu %10llu %11llu %14llu %6llu %8llu %9llu\n", m.name.c_str(),
                  std::string(name_of(m.contract.format)).c_str(), n(Outcome::right), n(Outcome::false_hit),
                  n(Outcome::false_miss), n(Outcome::wrong_contact), n(Outcome::fault), n(Outcome::refused),
                  n(Outcome::not_owed));
    text += line;
  }
  return text;
}

}  // namespace tribunal
