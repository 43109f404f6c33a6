// What `render --against` wrote: NAME.diff.json, its pictures and NAME.cases.jsonl.
#include <algorithm>
#include <filesystem>
#include <map>

#include "exact/report/gathering.h"
#include "exact/report/shapes.h"
#include "exact/report/table.h"

namespace tribunal {
namespace {

/// How many pixels differ for which reason, and who is wrong on them, by an answer or by the order of hits.
struct Blame {
  std::uint64_t method = 0, against = 0, neither = 0, order = 0, start = 0, unexamined = 0;
};

Blame blame_of(const std::vector<Record>& pixels, const std::string& method, const std::string& against) {
  Blame b;
  for (const Record& p : pixels) {
    const std::string why = p.text_or("why", "");
    const std::vector<Record> wrong = p.items_or_none("wrong");
    if (why != "face" && wrong.empty()) {
      ++(why == "order" ? b.order : why == "start" ? b.start : b.unexamined);
      continue;
    }
    const auto is_wrong = [&](const std::string& name) {
      return std::ranges::any_of(wrong, [&](const Record& w) { return w.text() == name; });
    };
    const bool one = is_wrong(method), other = is_wrong(against);
    b.method += one;
    b.against += other;
    b.neither += !one && !other;
  }
  return b;
}

/// The image's pixels in all.
struct Size {
  std::uint64_t width, height;
};

Size size_of(const Record& r) {
  constexpr std::uint64_t most = std::uint64_t{1} << 24;
  return {r.count("width", most), r.count("height", most)};
}

Json pixels_table(const Run& run, const CaseBook& book) {
  Table table({"x", "y", "colour", "parted_on", "why", "case"});
  const Size size = size_of(run.all());
  for (const Record& p : run.all().items("pixels")) {
    const auto number = book.number_of(run.number, p.text_or("case", ""));
    table.add({p.count("x", size.width), p.count("y", size.height), p.truth_or("colour", true) ? 1 : 0,
               p.text_or("parted_on", ""), p.text("why"), number ? Json(*number) : Json()});
  }
  return table.json();
}

/// The severity of the worst of this method's cases; a boundary if none was kept.
Level level_of(const CaseBook& book, std::size_t run, const std::string& method) {
  for (const std::size_t n : book.numbers_of(run)) {
    const Json& finding = book.at(n).c.finding;
    if (text_in(finding, "method") != method) continue;
    const std::string severity = text_in(finding, "severity");
    for (const Level level : {Level::plain, Level::extreme}) {
      if (severity == name_of(level)) return level;
    }
    return Level::boundary;
  }
  return Level::boundary;
}

ReportLine line_for(const Run& run, const CaseBook& book, const std::string& method, std::uint64_t wrong,
                    const Blame& b) {
  const Record r = run.all();
  const auto [width, height] = size_of(r);
  const std::uint64_t pixels = width * height;
  const std::uint64_t judged = pixels - std::min(pixels, b.unexamined);
  ReportLine line{.run = run.number, .method = method, .fmt = r.text_or("fmt", ""), .wrong = wrong, .judged = judged};
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
  const Record r = run.all();
  const auto [width, height] = size_of(r);
  const auto options = r.find("options");
  if (!options) return Json();
  std::vector<std::string> words{"render",    r.text_or("scene", ""),
                                 "--method",  method,
                                 "--against", against,
                                 "--size",    std::to_string(width) + "x" + std::to_string(height),
                                 "--accel",   r.text_or("accel", "bvh"),
                                 "--depth",   std::to_string(r.count_or("depth", 1, 1000))};
  for (const char* key : {"camera", "scale", "up", "max-cases", "triangulate", "heat"}) {
    const auto value = options->find(key);
    if (!value || value->json().is_null() || value->json() == false) continue;
    words.push_back(std::string("--") + key);
    if (value->json() != true) words.push_back(value->json().is_string() ? value->text() : value->json().dump());
  }
  words.insert(words.end(), {"--out", run.path(r.member("files").text_or("image", "image.png"))});
  return command_of(words);
}

}  // namespace

void gather_render(Run& run, Gathering& g) {
  const Record r = run.all();
  require_render_record(r);
  const Record difference = r.member("difference");
  const std::string method = difference.text("method"), against = difference.text("against");
  for (const std::string& name : {method, against}) run.page["methods"].push_back(g.add_method(name));
  const std::string scene = std::filesystem::path(r.text_or("scene", "")).filename().string();
  run.page["title"] = scene + ": " + method + " against " + against;
  run.page["seed"] = Json();
  run.page["command"] = command_for(run, method, against);
  const std::vector<Record> pixels = r.items("pixels");
  const auto [width, height] = size_of(r);
  require_part(r, pixels.size(), width * height, "pixels");
  const Blame b = blame_of(pixels, method, against);
  g.add(line_for(run, g.book, method, b.method, b));
  g.add(line_for(run, g.book, against, b.against, b));
  run.page["verdict_pixels"] = {{"method", b.method}, {"against", b.against}, {"neither", b.neither},
                                {"order", b.order},   {"start", b.start},     {"unexamined", b.unexamined}};
  Json record = run.record;
  record["pixels"] = pixels_table(run, g.book);
  for (const char* key : {"files", "environment", "options"}) record.erase(key);
  run.page["record"] = std::move(record);
  for (const auto& [key, name] : r.member("files").members()) {
    if (key != "cases") run.page["images"][key == "image" ? "method" : key] = g.add_image(run, name.text());
  }
}

}  // namespace tribunal
