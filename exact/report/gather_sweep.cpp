// What `sweep` wrote: sweep.json and witnesses.jsonl, compilers.json, map-NAME.json.
#include <algorithm>
#include <map>

#include "exact/report/gathering.h"
#include "exact/report/table.h"

namespace tribunal {
namespace {

/// A row with what was wrong as members of its own: outcomes keep their names, severities theirs. The number of
/// refusals is the one in the outcome of that name, which is there wherever it is not 0.
Json flat(Json row) {
  const Json outcomes = row.value("outcomes", Json::object());
  for (const char* key : {"outcomes", "refused"}) row.erase(key);
  row.update(outcomes);
  return row;
}

/// What one method did in one format along some axes: those of single cases together, or one of rays at a mesh.
struct Along {
  std::vector<std::string> axes{};
  std::uint64_t judged = 0, wrong = 0, leaks = 0, faults = 0;
  Json severities = Json::object();

  bool has(const std::string& axis) const { return std::ranges::find(axes, axis) != axes.end(); }
};

Along along(const Json& r, std::vector<std::string> axes, const std::string& method, const std::string& fmt) {
  Along a{.axes = std::move(axes)};
  for (const Json& row : r.at("rows")) {
    if (row.at("method") != method || row.at("fmt") != fmt || !a.has(row.at("axis"))) continue;
    const Json outcomes = row.value("outcomes", Json::object());
    a.judged += number_in(row, "judged");
    a.wrong += number_in(row.at("wrong"), "k");
    a.leaks += number_in(outcomes.value("leak", Json::object()), "k");
    a.faults += number_in(outcomes.value("fault", Json::object()), "k");
    for (const char* key : {"plain", "boundary", "extreme"}) {
      a.severities[key] = number_in(a.severities, key) + number_in(row, key);
    }
  }
  return a;
}

/// How far along its side of the axis a threshold lies: 0 at the easiest value, 1 at the last.
double progress_of(const Json& threshold, const Json& axis) {
  const std::string fmt = threshold.at("fmt");
  const std::vector<int> values = axis.at("values").at(fmt);
  const int easiest = axis.at("easiest").at(fmt), at = threshold.at("first").at("value");
  const bool up = threshold.at("side") == "up";
  const auto outward = [&](int v) { return up ? v > easiest : v < easiest; };
  const auto all = std::ranges::count_if(values, outward);
  const auto passed = std::ranges::count_if(values, [&](int v) { return outward(v) && (up ? v <= at : v >= at); });
  return all == 0 ? 0 : static_cast<double>(passed) / static_cast<double>(all);
}

/// "fails first on the axis fill: at 18, 2 of 51 false hit", of the thresholds the one that is passed after the
/// smallest part of its axis; "" if there is none.
std::string first_failure(const Json& r, const Along& a, const std::string& method, const std::string& fmt) {
  double least = 2;
  std::string text;
  for (const Json& t : r.at("thresholds")) {
    if (t.at("method") != method || t.at("fmt") != fmt || t.at("outcome") == "refused" || !a.has(t.at("axis")))
      continue;
    const auto axis = std::ranges::find(r.at("axes"), t["axis"], [](const Json& x) { return x.at("name"); });
    const double progress = axis == r["axes"].end() ? 1 : progress_of(t, *axis);
    if (progress >= least) continue;
    least = progress;
    const Json& first = t.at("first");
    text = "fails first on the axis " + t["axis"].get<std::string>() + ": at " +
           std::to_string(first.at("value").get<int>()) + ", " + std::to_string(number_in(first, "k")) + " of " +
           std::to_string(number_in(first, "n")) + " " + t["outcome"].get<std::string>();
  }
  return text;
}

/// No bound stands here: how many of the cases are easy depends on how many easy values the axes have.
Line sweep_line(const Run& run, const Along& a, const std::string& method, const std::string& fmt, bool of_mesh) {
  Line line{.run = run.number, .method = method, .fmt = fmt, .wrong = a.wrong, .judged = a.judged};
  const std::string what = " " + fmt + (of_mesh ? " rays at a mesh" : " cases") + " along " +
                           (a.axes.size() == 1 ? "the axis " + a.axes[0] : std::to_string(a.axes.size()) + " axes");
  if (a.wrong == 0) {
    line.text = method + ": nothing wrong of " + std::to_string(a.judged) + what;
    return line;
  }
  line.level = a.leaks > 0 ? Level::leaks : worst_level(a.severities);
  if (a.faults > 0 && line.level != Level::plain) line.level = std::min(line.level, Level::fault);
  if (line.level == Level::nothing) line.level = Level::boundary;
  line.text = method + ": " + std::to_string(a.wrong) + " wrong of " + std::to_string(a.judged) + what;
  line.detail = first_failure(run.record, a, method, fmt);
  return line;
}

void add_lines(const Run& run, Gathering& g, const std::string& method) {
  std::vector<std::vector<std::string>> meshes;
  std::vector<std::string> others;
  for (const Json& axis : run.record.at("axes")) {
    const std::string name = axis.at("name");
    if (axis.value("operands", "") == "mesh") {
      meshes.push_back({name});
    } else {
      others.push_back(name);
    }
  }
  for (const std::string fmt : {"binary64", "binary32"}) {
    const Along cases = along(run.record, others, method, fmt);
    if (cases.judged > 0) g.add(sweep_line(run, cases, method, fmt, false));
    for (const auto& axis : meshes) {
      const Along rays = along(run.record, axis, method, fmt);
      if (rays.judged > 0) g.add(sweep_line(run, rays, method, fmt, true));
    }
  }
}

/// A mesh of the user's own, whose file the record does not name. The program's own is "a torus".
bool has_own_mesh(const Json& r) {
  return std::ranges::any_of(r.at("axes"), [](const Json& axis) {
    const bool own = axis.value("population", "").find(" of a torus (") == std::string::npos;
    return axis.value("operands", "") == "mesh" && own;
  });
}

Json names_of(const Json& objects) {
  Json names = Json::array();
  for (const Json& o : objects) names.push_back(o.at("name"));
  return names;
}

/// A failure map is made of segments around one contact: what is wrong there is wrong on a boundary.
Line map_line(std::size_t run, const Json& panel, const std::string& map) {
  const Json counts = panel.value("counts", Json::object());
  const auto count = [&](const char* key) { return number_in(counts, key); };
  const std::uint64_t wrong = count("false hit") + count("false miss") + count("wrong contact") + count("fault");
  const std::uint64_t judged = wrong + count("right");
  const std::string method = panel.at("method");
  return {.run = run,
          .method = method,
          .level = wrong > 0 ? Level::boundary : Level::nothing,
          .fmt = panel.value("fmt", ""),
          .text = method + ": wrong on " + share_in_words(wrong, judged) + " pixels of the map " + map,
          .detail = "each pixel is a case, some units in the last place from a contact",
          .wrong = wrong,
          .judged = judged};
}

}  // namespace

void gather_sweep(Run& run, Gathering& g) {
  Json r = run.record;
  run.page["methods"] = names_of(r.at("methods"));
  if (!has_own_mesh(r)) {
    run.page["command"] = command_of({"sweep", "--method", joined(run.page["methods"]), "--axis",
                                      joined(names_of(r.at("axes"))), "--seed", std::to_string(number_in(r, "seed")),
                                      "--count", std::to_string(number_in(r, "cases")), "--out", run.directory});
  }
  for (const Json& m : r["methods"]) add_lines(run, g, g.add_method(m));
  Json rows = Json::array();
  for (const Json& row : r["rows"]) rows.push_back(flat(row));
  r["rows"] = table_of(rows).json();
  for (Json& threshold : r.at("thresholds")) {
    const auto number = g.book.number_of(run.number, threshold.value("witness", ""));
    threshold["case"] = number ? Json(*number) : Json();
  }
  r.erase("environment");
  run.page["record"] = std::move(r);
}

void gather_compilers(Run& run, Gathering& g) {
  Json r = run.record;
  Json names = Json::array();
  for (const Json& row : r.at("rows")) {
    if (std::ranges::find(names, row.at("method")) == names.end()) names.push_back(row["method"]);
  }
  for (const Json& name : names) g.add_method({{"name", name}});
  run.page["methods"] = names;
  run.page["command"] = command_of({"sweep", "--axis", "compiler", "--method", joined(names), "--seed",
                                    std::to_string(number_in(r, "seed")), "--count",
                                    std::to_string(number_in(r, "cases_of_each_format")), "--out", run.directory});
  r.erase("environment");
  run.page["record"] = std::move(r);
}

void gather_map(Run& run, Gathering& g) {
  Json r = run.record;
  const std::string map = r.at("map");
  run.page["title"] = "map " + map;
  run.page["methods"] = Json::array();
  for (const Json& panel : r.at("panels")) {
    run.page["methods"].push_back(g.add_method({{"name", panel.at("method")}, {"fmt", panel.value("fmt", "")}}));
    g.add(map_line(run.number, panel, map));
  }
  std::vector<std::string> words{"sweep", "--map", map};
  if (r.value("probe", "segment") == "ray") words.insert(words.end(), {"--probe", "ray"});
  words.insert(words.end(), {"--map-size", std::to_string(number_in(r, "size")), "--method",
                             joined(run.page["methods"]), "--out", run.directory});
  run.page["command"] = command_of(words);
  for (const char* key : {"base", "unit"}) {
    if (!r.contains(key)) r[key] = Json();
  }
  r.erase("environment");
  run.page["record"] = std::move(r);
}

}  // namespace tribunal
