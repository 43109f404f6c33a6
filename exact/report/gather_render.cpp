// What `render --against` wrote: NAME.diff.json, its pictures and NAME.cases.jsonl.
#include <algorithm>
#include <filesystem>
#include <map>

#include "exact/report/gathering.h"
#include "exact/report/table.h"

namespace tribunal {
namespace {

/// How many pixels differ for which reason, and who is wrong on them, by an answer or by the order of hits.
struct Blame {
  std::uint64_t method = 0, against = 0, neither = 0, order = 0, start = 0, unexamined = 0;
};

Blame blame_of(const Json& pixels, const std::string& method, const std::string& against) {
  Blame b;
  for (const Json& p : pixels) {
    const std::string why = p.value("why", "");
    const Json wrong = p.value("wrong", Json::array());
    if (why != "face" && wrong.empty()) {
      ++(why == "order" ? b.order : why == "start" ? b.start : b.unexamined);
      continue;
    }
    const bool one = std::ranges::find(wrong, Json(method)) != wrong.end();
    const bool other = std::ranges::find(wrong, Json(against)) != wrong.end();
    b.method += one;
    b.against += other;
    b.neither += !one && !other;
  }
  return b;
}

Json pixels_table(const Run& run, const CaseBook& book) {
  Table table({"x", "y", "colour", "parted_on", "why", "case"});
  for (const Json& p : run.record.at("pixels")) {
    const auto number = book.number_of(run.number, p.value("case", ""));
    table.add({p.at("x"), p.at("y"), p.value("colour", true) ? 1 : 0, p.value("parted_on", ""), p.at("why"),
               number ? Json(*number) : Json()});
  }
  return table.json();
}

/// The severity of the worst of this method's cases; a boundary if none was kept.
Level level_of(const CaseBook& book, std::size_t run, const std::string& method) {
  for (const std::size_t n : book.numbers_of(run)) {
    const Json& finding = book.at(n).c.finding;
    if (text_in(finding, "method") != method) continue;
    const Level level = worst_level({{text_in(finding, "severity"), 1}});
    return level == Level::nothing ? Level::boundary : level;
  }
  return Level::boundary;
}

Line line_for(const Run& run, const CaseBook& book, const std::string& method, std::uint64_t wrong, const Blame& b) {
  const Json& r = run.record;
  const std::uint64_t pixels = r.at("width").get<std::uint64_t>() * r.at("height").get<std::uint64_t>();
  const std::uint64_t judged = pixels - std::min(pixels, b.unexamined);
  Line line{.run = run.number, .method = method, .fmt = r.value("fmt", ""), .wrong = wrong, .judged = judged};
  if (wrong > 0) {
    line.level = level_of(book, run.number, method);
    line.text = method + ": " + share_in_words(wrong, judged) + " pixels show a wrong answer";
  } else {
    line.level = b.unexamined > 0 ? Level::incomplete : b.order + b.start > 0 ? Level::pictures : Level::nothing;
    line.text = method + ": no pixel of " + std::to_string(judged) + " shows a wrong answer";
  }
  if (b.start > 0) {
    line.detail =
        std::to_string(b.start) + " more differ only by where a secondary ray starts: no answer is wrong there";
  }
  if (b.order > 0) {
    line.detail +=
        (line.detail.empty() ? "" : "; ") + std::to_string(b.order) + " only by which of two hits comes first";
  }
  if (b.unexamined > 0) {
    line.detail += (line.detail.empty() ? "" : "; ") + std::to_string(b.unexamined) + " that differ were not examined";
  }
  return line;
}

/// The command; null of a record that does not say with which options it was made.
Json command_for(const Run& run, const std::string& method, const std::string& against) {
  const Json& r = run.record;
  const std::string size = std::to_string(r.value("width", 0)) + "x" + std::to_string(r.value("height", 0));
  if (!r.contains("options")) return Json();
  std::vector<std::string> words{"render",    r.value("scene", ""),
                                 "--method",  method,
                                 "--against", against,
                                 "--size",    size,
                                 "--accel",   r.value("accel", "bvh"),
                                 "--depth",   std::to_string(r.value("depth", 1))};
  for (const char* key : {"camera", "scale", "up", "max-cases", "triangulate", "heat"}) {
    const Json value = r["options"].value(key, Json());
    if (value.is_null() || value == false) continue;
    words.push_back(std::string("--") + key);
    if (value != true) words.push_back(value.is_string() ? value.get<std::string>() : value.dump());
  }
  words.insert(words.end(), {"--out", run.path(r.at("files").value("image", "image.png"))});
  return command_of(words);
}

}  // namespace

void gather_render(Run& run, Gathering& g) {
  const Json& r = run.record;
  const std::string method = r.at("difference").at("method"), against = r["difference"].at("against");
  for (const std::string& name : {method, against}) {
    g.add_method({{"name", name}});
    run.page["methods"].push_back(name);
  }
  const std::string scene = std::filesystem::path(r.value("scene", "")).filename().string();
  run.page["title"] = scene + ": " + method + " against " + against;
  run.page["seed"] = Json();
  run.page["command"] = command_for(run, method, against);
  const Blame b = blame_of(r.at("pixels"), method, against);
  g.add(line_for(run, g.book, method, b.method, b));
  g.add(line_for(run, g.book, against, b.against, b));
  run.page["verdict_pixels"] = {{"method", b.method}, {"against", b.against}, {"neither", b.neither},
                                {"order", b.order},   {"start", b.start},     {"unexamined", b.unexamined}};
  Json record = r;
  record["pixels"] = pixels_table(run, g.book);
  for (const char* key : {"files", "environment", "options"}) record.erase(key);
  run.page["record"] = std::move(record);
  for (const auto& [key, name] : r.at("files").items()) {
    if (key != "cases") run.page["images"][key == "image" ? "method" : key] = g.add_image(run, name.get<std::string>());
  }
}

}  // namespace tribunal
