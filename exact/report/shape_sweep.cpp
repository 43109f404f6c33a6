// What sweep.json and map-NAME.json must look like.
#include <algorithm>
#include <map>
#include <string>

#include "exact/cases/case_io.h"
#include "exact/report/shapes.h"

namespace tribunal {
namespace {

using namespace shape;

constexpr std::int64_t least_value = -(std::int64_t{1} << 53), most_value = std::int64_t{1} << 53;

// --- axes -----------------------------------------------------------------------------------------------------------

Check axis_value() { return integer(least_value, most_value); }

Check axis() {
  return object({needed("name", name()), needed("quantity", text()), needed("population", text()),
                 if_there("operands", word({"triangles", "polygons", "mesh"})),
                 if_there("probes", list(word({"segment", "ray"}))), if_there("spacing", word({"even", "logarithmic"})),
                 needed("easiest", named(axis_value())), needed("values", named(list(axis_value())))});
}

/// How many of how many at a value.
Check mark() { return rate({needed("value", axis_value())}); }

Check outcome() {
  return [](const Record& r) {
    rate()(r);
    require_part(r, r.count_or("plain", 0), r.count("k"), "plain");
  };
}

Check row() {
  return object({needed("method", name()), needed("axis", name()), needed("fmt", format()),
                 needed("value", axis_value()), needed("probe", word({"segment", "ray"})), needed("asked", count()),
                 needed("judged", count()), if_there("due_hits", count()), if_there("refused", count()),
                 if_there("parity_judged", count()), needed("wrong", rate()), if_there("outcomes", named(outcome()))},
                [](const Record& r) {
                  const std::uint64_t asked = r.count("asked"), judged = r.count("judged");
                  require_part(r, judged, asked, "judged");
                  require_part(r, r.count_or("due_hits", 0), asked, "due_hits");
                  require_part(r, r.count_or("refused", 0), asked - judged, "refused");
                  require_part(r, r.count_or("parity_judged", 0), judged, "parity_judged");
                  const Record wrong = r.member("wrong");
                  if (wrong.count("n") != judged)
                    wrong.fail_at("n", "expected " + std::to_string(judged) + ", those judged");
                  std::uint64_t severities = 0;
                  for (const char* key : {"plain", "boundary", "extreme"}) {
                    severities += r.count_or(key, 0, wrong.count("k"));
                  }
                  require_part(r, severities, wrong.count("k"), "severity");
                  const auto outcomes = r.find("outcomes");
                  if (!outcomes) return;
                  for (const auto& [key, value] : outcomes->members()) {
                    require_part(value, value.count("n"), asked, "n");
                    if (key != "refused") require_part(value, value.count("k"), wrong.count("k"), "k");
                  }
                });
}

Check threshold() {
  return object({needed("method", name()), needed("axis", name()), needed("fmt", format()),
                 needed("side", word({"up", "down"})), needed("probe", word({"segment", "ray"})),
                 needed("outcome", text()), if_there("before", null_or(mark())), needed("first", mark()),
                 if_there("all", null_or(mark())), if_there("witness", text())});
}

using Axes = std::map<std::string, Record>;

/// A value of the axis in the format; the easiest need not be one of them.
void require_on_axis(const Record& row, const Record& value, const Axes& axes) {
  const auto axis = axes.find(row.text("axis"));
  if (axis == axes.end()) row.fail_at("axis", "is none of \"axes\"");
  const std::string fmt = row.text("fmt");
  const std::int64_t given = value.integer("value", least_value, most_value);
  if (given == axis->second.member("easiest").integer(fmt, least_value, most_value)) return;
  for (const Record& one : axis->second.member("values").items(fmt)) {
    if (one.integer(least_value, most_value) == given) return;
  }
  value.fail_at("value", "is none of the axis's values");
}

/// Every row is at a value of an axis, about no more cases than there were.
void require_whole(const Record& r) {
  Axes axes;
  for (const Record& one : r.items("axes")) axes.emplace(one.text("name"), one);
  std::uint64_t asked = 0;
  for (const Record& one : r.items("rows")) {
    require_on_axis(one, one, axes);
    if (r.has("cases")) require_part(one, one.count("asked"), r.count("cases"), "asked");
    require_part(one, one.count("asked"), Record::most_count - asked, "asked in all");
    asked += one.count("asked");
  }
  require_part(r, r.count_or("audited", 0), asked, "audited");
  for (const Record& one : r.items("thresholds")) {
    for (const char* key : {"before", "first", "all"}) {
      const auto mark = one.find(key);
      if (!mark || mark->json().is_null()) continue;
      require_on_axis(one, *mark, axes);
      if (r.has("cases")) require_part(*mark, mark->count("n"), r.count("cases"), "n");
    }
  }
}

// --- maps -----------------------------------------------------------------------------------------------------------

constexpr std::uint64_t most_pixels_a_side = 4096;

/// So many texts of as many characters, all of them known.
void require_square(const Record& rows, std::uint64_t side, std::string_view known) {
  const std::vector<Record> all = rows.items();
  if (all.size() != side) rows.fail("expected " + std::to_string(side) + " rows, found " + std::to_string(all.size()));
  for (const Record& row : all) {
    const std::string text = row.text();
    if (text.size() != side || text.find_first_not_of(known) != std::string::npos) {
      row.fail("expected " + std::to_string(side) + " characters of \"" + std::string(known) + "\"");
    }
  }
}

/// What the pixels say, counted as the counts name it.
std::map<std::string, std::uint64_t> counted(const Record& pixels) {
  const std::map<char, std::string> names = {{'H', "right"},      {'M', "right"},         {'+', "false hit"},
                                             {'-', "false miss"}, {'c', "wrong contact"}, {'x', "fault"},
                                             {'?', "refused"},    {' ', "not owed"}};
  std::map<std::string, std::uint64_t> counts;
  for (const Record& row : pixels.items()) {
    for (const char c : row.text()) ++counts[names.at(c)];
  }
  return counts;
}

/// The counts are those of the pixels.
void require_panel(const Record& panel, std::uint64_t side) {
  const Record pixels = panel.member("pixels"), counts = panel.member("counts");
  require_square(pixels, side, "HM+-cx? ");
  const auto expected = counted(pixels);
  for (const auto& [key, n] : counts.members()) {
    const auto found = expected.find(key);
    const std::uint64_t owed = found == expected.end() ? 0 : found->second;
    if (n.count() != owed) n.fail("expected " + std::to_string(owed) + ", as the pixels say");
  }
  for (const auto& [key, n] : expected) counts.count(key, n);
}

/// The case in the middle of a format, and by how much a pixel moves it.
void require_contact(const Record& r, const std::string& fmt) {
  const auto base = r.find("base"), unit = r.find("unit");
  if (!base || base->json().is_null()) return;
  const Record middle = base->member(fmt).object();
  Json line = middle.json();
  line["id"] = "pixel";
  line["fmt"] = fmt;
  const Case c = to_case(line, middle.where());
  if (c.query.operands() != Operands::triangles || !is_finite(c.query)) middle.fail("expected finite operands");
  if (!unit) r.fail("missing \"unit\"");
  const Record of_format = unit->member(fmt);
  if (to_number(of_format.json(), Format::binary64, of_format.where()) <= 0) of_format.fail("expected more than 0");
  require_square(r.member("truth").member(fmt), r.count("size"), "h.");
}

}  // namespace

void require_sweep_record(const Record& record) {
  static const Check shape =
      object({needed("methods", list(method())), needed("axes", list(axis())), needed("rows", list(row())),
              needed("thresholds", list(threshold())), if_there("seed", whole()), if_there("cases", count()),
              if_there("confidence", share()), if_there("audited", count()), if_there("environment", environment())},
             require_whole);
  if (record.items("axes").empty()) record.fail_at("axes", "expected at least one");
  shape(record);
}

void require_map_record(const Record& record) {
  static const Check shape = object(
      {needed("map", name()), needed("size", count(most_pixels_a_side)), if_there("about", text()),
       if_there("moved", text()), if_there("probe", word({"segment", "ray"})),
       if_there("base", null_or(named(object({})))), if_there("unit", null_or(object({}))),
       if_there("truth", named(list(text()))),
       needed("panels", list(object({needed("method", name()), needed("fmt", format()), if_there("convention", text()),
                                     needed("counts", named(count())), needed("pixels", list(text()))}))),
       if_there("environment", environment())});
  shape(record);
  for (const Record& panel : record.items("panels")) {
    require_panel(panel, record.count("size"));
    require_contact(record, panel.text("fmt"));
  }
  if (const auto truth = record.find("truth")) {
    for (const auto& [fmt, rows] : truth->members()) require_square(rows, record.count("size"), "h.");
  }
}

}  // namespace tribunal
