// What `sweep` wrote: sweep.json and witnesses.jsonl, compilers.json, map-NAME.json.
#include <algorithm>
#include <map>

#include "exact/report/gathering.h"
#include "exact/report/shapes.h"
#include "exact/report/table.h"

namespace tribunal {
namespace {

/// A row with what was wrong as members of its own: outcomes keep their names, severities theirs. The number of
/// refusals is the one in the outcome of that name, which is there wherever it is not 0.
Json flat(const Record& row) {
  Json result = row.json();
  for (const char* key : {"outcomes", "refused"}) result.erase(key);
  if (const auto outcomes = row.find("outcomes")) result.update(outcomes->object().json());
  return result;
}

/// What one method did in one format along some axes: those of single cases together, or one of rays at a mesh.
struct Along {
  std::vector<std::string> axes{};
  Figures figures{};
  std::uint64_t leaks = 0;

  bool has(const std::string& axis) const { return std::ranges::find(axes, axis) != axes.end(); }
};

/// Of {"name": {"k": n, …}} the n; 0 if there is none of the name.
std::uint64_t outcome_in(const Record& row, const char* name) {
  const auto outcomes = row.find("outcomes");
  const auto outcome = outcomes ? outcomes->find(name) : std::nullopt;
  return outcome ? number_in(*outcome, "k") : 0;
}

Along along(const Record& r, std::vector<std::string> axes, const std::string& method, const std::string& fmt) {
  Along a{.axes = std::move(axes)};
  for (const Record& row : r.items("rows")) {
    if (row.text("method") != method || row.text("fmt") != fmt || !a.has(row.text("axis"))) continue;
    const std::uint64_t judged = number_in(row, "judged"), wrong = number_in(row.member("wrong"), "k");
    require_part(row, wrong, judged, "wrong");
    require_part(row, judged, Record::most_count - a.figures.judged, "judged in all");
    for (const char* key : {"plain", "boundary", "extreme"}) require_part(row, number_in(row, key), wrong, key);
    for (const char* key : {"leak", "fault"}) require_part(row, outcome_in(row, key), wrong, key);
    a.figures.judged += judged;
    a.figures.wrong += wrong;
    a.figures.fault += outcome_in(row, "fault");
    a.figures.add_severities(row);
    a.leaks += outcome_in(row, "leak");
  }
  return a;
}

constexpr std::int64_t least_value = -(std::int64_t{1} << 53), most_value = std::int64_t{1} << 53;  ///< of an axis

/// How far along its side of the axis a threshold lies: 0 at the easiest value, 1 at the last.
double progress_of(const Record& threshold, const Record& axis) {
  const std::string fmt = threshold.text("fmt");
  const std::vector<Record> values = axis.member("values").items(fmt);
  const std::int64_t easiest = axis.member("easiest").integer(fmt, least_value, most_value);
  const std::int64_t at = threshold.member("first").integer("value", least_value, most_value);
  const bool up = threshold.text("side") == "up";
  std::size_t all = 0, passed = 0;
  for (const Record& value : values) {
    const std::int64_t v = value.integer(least_value, most_value);
    const bool outward = up ? v > easiest : v < easiest;
    all += outward;
    passed += outward && (up ? v <= at : v >= at);
  }
  return all == 0 ? 0 : static_cast<double>(passed) / static_cast<double>(all);
}

/// "fails first on the axis fill: at 18, 2 of 51 false hit", of the thresholds the one that is passed after the
/// smallest part of its axis; "" if there is none.
std::string first_failure(const Record& r, const Along& a, const std::string& method, const std::string& fmt) {
  double least = 2;
  std::string text;
  const std::vector<Record> axes = r.items("axes");
  for (const Record& t : r.items("thresholds")) {
    const std::string name = t.text("axis"), outcome = t.text("outcome");
    if (t.text("method") != method || t.text("fmt") != fmt || outcome == "refused" || !a.has(name)) continue;
    const auto axis = std::ranges::find_if(axes, [&](const Record& x) { return x.text("name") == name; });
    const double progress = axis == axes.end() ? 1 : progress_of(t, *axis);
    if (progress >= least) continue;
    least = progress;
    const Record first = t.member("first");
    require_part(first, number_in(first, "k"), number_in(first, "n"), "k");
    text = "fails first on the axis " + name + ": at " +
           std::to_string(first.integer("value", least_value, most_value)) + ", " +
           std::to_string(number_in(first, "k")) + " of " + std::to_string(number_in(first, "n")) + " " + outcome;
  }
  return text;
}

/// No bound stands here: how many of the cases are easy depends on how many easy values the axes have.
ReportLine sweep_line(const Run& run, const Along& a, const std::string& method, const std::string& fmt, bool of_mesh) {
  ReportLine line{
      .run = run.number, .method = method, .fmt = fmt, .wrong = a.figures.wrong, .judged = a.figures.judged};
  const std::string what = " " + fmt + (of_mesh ? " rays at a mesh" : " cases") + " along " +
                           (a.axes.size() == 1 ? "the axis " + a.axes[0] : std::to_string(a.axes.size()) + " axes");
  if (line.wrong == 0) {
    line.text = method + ": nothing wrong of " + std::to_string(line.judged) + what;
    return line;
  }
  line.level = a.leaks > 0 ? Level::leaks : worst_level(a.figures);
  if (a.figures.fault > 0 && line.level != Level::plain) line.level = std::min(line.level, Level::fault);
  if (line.level == Level::nothing) line.level = Level::boundary;
  line.text = method + ": " + std::to_string(line.wrong) + " wrong of " + std::to_string(line.judged) + what;
  line.detail = first_failure(run.all(), a, method, fmt);
  return line;
}

void add_lines(const Run& run, Gathering& g, const std::string& method) {
  std::vector<std::vector<std::string>> meshes;
  std::vector<std::string> others;
  const Record r = run.all();
  for (const Record& axis : r.items("axes")) {
    const std::string name = axis.text("name");
    if (axis.text_or("operands", "") == "mesh") {
      meshes.push_back({name});
    } else {
      others.push_back(name);
    }
  }
  for (const std::string fmt : {"binary64", "binary32"}) {
    const Along cases = along(r, others, method, fmt);
    if (cases.figures.judged > 0) g.add(sweep_line(run, cases, method, fmt, false));
    for (const auto& axis : meshes) {
      const Along rays = along(r, axis, method, fmt);
      if (rays.figures.judged > 0) g.add(sweep_line(run, rays, method, fmt, true));
    }
  }
}

/// A mesh of the user's own, whose file the record does not name. The program's own is "a torus".
bool has_own_mesh(const Record& r) {
  return std::ranges::any_of(r.items("axes"), [](const Record& axis) {
    const bool own = axis.text_or("population", "").find(" of a torus (") == std::string::npos;
    return axis.text_or("operands", "") == "mesh" && own;
  });
}

/// A failure map is made of segments around one contact: what is wrong there is wrong on a boundary.
ReportLine map_line(std::size_t run, const Record& panel, const std::string& map) {
  const auto count = [&](const char* key) { return number_in(panel, "counts", key); };
  const std::uint64_t wrong = count("false hit") + count("false miss") + count("wrong contact") + count("fault");
  const std::uint64_t judged = wrong + count("right");
  const std::string method = panel.text("method");
  return {.run = run,
          .method = method,
          .level = wrong > 0 ? Level::boundary : Level::nothing,
          .fmt = panel.text_or("fmt", ""),
          .text = method + ": wrong on " + share_in_words(wrong, judged) + " pixels of the map " + map,
          .detail = "each pixel is a case, some units in the last place from a contact",
          .wrong = wrong,
          .judged = judged};
}

}  // namespace

void gather_sweep(Run& run, Gathering& g) {
  const Record all = run.all();
  require_sweep_record(all);
  const std::vector<std::string> methods = names_in(all.items("methods"), "name");
  run.page["methods"] = methods;
  if (!has_own_mesh(all)) {
    run.page["command"] = command_of({"sweep", "--method", joined(methods), "--axis",
                                      joined(names_in(all.items("axes"), "name")), "--seed", seed_in(all), "--count",
                                      std::to_string(number_in(all, "cases")), "--out", run.directory});
  }
  for (const Record& m : all.items("methods")) add_lines(run, g, g.add_method(m));
  Json r = run.record, rows = Json::array();
  for (const Record& row : all.items("rows")) rows.push_back(flat(row));
  r["rows"] = table_of(rows).json();
  const std::vector<Record> thresholds = all.items("thresholds");
  for (std::size_t i = 0; i < thresholds.size(); ++i) {
    const auto number = g.book.number_of(run.number, thresholds[i].text_or("witness", ""));
    r["thresholds"][i]["case"] = number ? Json(*number) : Json();
  }
  r.erase("environment");
  run.page["record"] = std::move(r);
}

void gather_compilers(Run& run, Gathering& g) {
  const Record all = run.all();
  require_compilers_record(all);
  const std::vector<std::string> names = names_in(all.items("rows"), "method");
  for (const std::string& name : names) g.add_method(name);
  run.page["methods"] = names;
  run.page["command"] =
      command_of({"sweep", "--axis", "compiler", "--method", joined(names), "--seed", seed_in(all), "--count",
                  std::to_string(number_in(all, "cases_of_each_format")), "--out", run.directory});
  Json r = run.record;
  r.erase("environment");
  run.page["record"] = std::move(r);
}

void gather_map(Run& run, Gathering& g) {
  const Record all = run.all();
  require_map_record(all);
  const std::string map = all.text("map");
  run.page["title"] = "map " + map;
  std::vector<std::string> methods;
  for (const Record& panel : all.items("panels")) {
    const Json row = {{"name", panel.text("method")}, {"fmt", panel.text_or("fmt", "")}};
    methods.push_back(g.add_method(Record(row, panel.where())));
    g.add(map_line(run.number, panel, map));
  }
  run.page["methods"] = methods;
  std::vector<std::string> words{"sweep", "--map", map};
  if (all.text_or("probe", "segment") == "ray") words.insert(words.end(), {"--probe", "ray"});
  words.insert(words.end(), {"--map-size", std::to_string(number_in(all, "size")), "--method", joined(methods), "--out",
                             run.directory});
  run.page["command"] = command_of(words);
  Json r = run.record;
  for (const char* key : {"base", "unit"}) {
    if (!r.contains(key)) r[key] = Json();
  }
  r.erase("environment");
  run.page["record"] = std::move(r);
}

}  // namespace tribunal
