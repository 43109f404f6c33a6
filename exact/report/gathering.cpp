#include "exact/report/gathering.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <tuple>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/certificate/rate.h"
#include "exact/methods/methods.h"
#include "exact/report/base64.h"
#include "exact/report/case_view.h"

namespace tribunal {
namespace {

constexpr std::size_t most_image_bytes = std::size_t{4} << 20, most_bytes_of_images = std::size_t{16} << 20;

/// A number of four bytes, the most significant first.
std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t n = 0;
  for (const char c : bytes.substr(0, 4)) n = n << 8 | static_cast<unsigned char>(c);
  return n;
}

bool is_png(std::string_view bytes) { return bytes.size() > 24 && bytes.starts_with("\x89PNG\r\n\x1a\n"); }

}  // namespace

std::string_view name_of(Level level) {
  constexpr std::string_view names[] = {"plain",     "fault",   "leaks",      "boundary", "extreme",
                                        "relations", "refused", "incomplete", "pictures", "nothing"};
  return names[static_cast<int>(level)];
}

std::string Run::path(const std::string& name) const { return (std::filesystem::path(directory) / name).string(); }

std::string Gathering::add_method(const Record& row) {
  const std::string name = add_method(row.text("name"));
  if (find_method(name) != nullptr) return name;
  for (const char* key : {"number", "fmt", "convention", "contract", "reference"}) {
    if (row.has(key)) methods_[name][key] = row.text(key);
  }
  if (row.has("exact")) methods_[name]["exact"] = row.truth("exact");
  return name;
}

std::string Gathering::add_method(const std::string& name) {
  Json& entry = methods_[name];
  if (entry.is_null()) entry = Json::object();
  if (const Method* m = find_method(name)) {
    entry.update({{"number", m->card.number},
                  {"fmt", name_of(m->contract.format)},
                  {"convention", name_of(m->contract.convention)},
                  {"exact", m->contract.exact},
                  {"contract", in_words(m->contract)},
                  {"about", m->card.summary},
                  {"reference", m->card.reference}});
  }
  return name;
}

void Gathering::leave_out(Run& run, const std::string& what) {
  run.page["left_out"].push_back(what);
  left_out_.push_back(run.path(run.file) + ": " + what);
}

Json Gathering::add_image(Run& run, const std::string& name) {
  const std::string file = run.path(std::filesystem::path(name).filename().string());
  if (!is_regular_file(file)) return leave_out(run, file + " is missing"), Json();
  const std::string bytes = read_file(file);
  if (!is_png(bytes)) throw bad_input(file, 0, "no PNG file, expected a picture that `render` wrote");
  if (bytes.size() > most_image_bytes || image_bytes_ + bytes.size() > most_bytes_of_images) {
    return leave_out(run, file + " is too large for a page (" + std::to_string(bytes.size()) + " bytes)"), Json();
  }
  image_bytes_ += bytes.size();
  images_.push_back({{"uri", "data:image/png;base64," + base64(bytes)},
                     {"width", big_endian(std::string_view(bytes).substr(16))},
                     {"height", big_endian(std::string_view(bytes).substr(20))}});
  return images_.size() - 1;
}

Json Gathering::method_order() const {
  std::vector<std::string> names;
  for (const auto& [name, entry] : methods_.items()) names.push_back(name);
  std::ranges::stable_sort(names, {}, [&](const std::string& n) {
    const auto exact = methods_[n].find("exact");
    return exact != methods_[n].end() && *exact == true;
  });
  return names;
}

Json Gathering::verdicts() const {
  std::vector<ReportLine> lines = lines_;
  const auto share = [](const ReportLine& l) {
    return l.judged == 0 ? 0.0 : static_cast<double>(l.wrong) / static_cast<double>(l.judged);
  };
  std::ranges::stable_sort(lines, {}, [&](const ReportLine& l) { return std::tuple(l.level, -share(l)); });
  Json all = Json::array();
  for (const ReportLine& l : lines) {
    Json row = {{"run", l.run},       {"method", l.method}, {"level", name_of(l.level)}, {"text", l.text},
                {"detail", l.detail}, {"wrong", l.wrong},   {"judged", l.judged}};
    if (!l.fmt.empty()) row["fmt"] = l.fmt;
    for (const std::size_t n : book.numbers_of(l.run)) {
      if (text_in(book.at(n).c.finding, "method") != l.method) continue;
      row["case"] = n;
      break;
    }
    all.push_back(std::move(row));
  }
  return all;
}

std::string share_in_words(std::uint64_t part, std::uint64_t whole) {
  const std::string text = std::to_string(part) + " of " + std::to_string(whole);
  return whole == 0 ? text : text + " (" + percent(static_cast<double>(part) / static_cast<double>(whole)) + ")";
}

void Figures::add_severities(const Record& row) {
  plain += number_in(row, "plain");
  boundary += number_in(row, "boundary");
  extreme += number_in(row, "extreme");
}

Level worst_level(const Figures& f) {
  if (f.plain > 0) return Level::plain;
  if (f.boundary > 0) return Level::boundary;
  return f.extreme > 0 ? Level::extreme : Level::nothing;
}

std::uint64_t number_in(const Record& row, const char* group, const char* key) {
  const auto found = row.find(group);
  return found ? number_in(*found, key) : 0;
}

std::string seed_in(const Record& r) { return std::to_string(r.has("seed") ? r.whole("seed") : 0); }

std::vector<std::string> names_in(const std::vector<Record>& objects, const char* key) {
  std::vector<std::string> names;
  for (const Record& o : objects) {
    const std::string name = o.text(key);
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

ReportLine line_of(std::size_t run, const std::string& method, const std::string& fmt, const Figures& counts) {
  ReportLine line{.run = run, .method = method, .level = worst_level(counts), .fmt = fmt};
  line.wrong = counts.wrong;
  line.judged = counts.judged;
  if (line.judged == 0) {
    line.text = method + ": nothing was judged in " + fmt;
    return line;
  }
  if (line.wrong == 0) {
    line.text = method + ": nothing wrong in " + std::to_string(line.judged) + " " + fmt + " cases";
    line.detail = "so at most " + percent(rate_of(0, line.judged).upper) + " wrong of such cases, with 95 % confidence";
    return line;
  }
  if (line.level == Level::nothing) line.level = Level::extreme;
  if (counts.fault > 0 && line.level != Level::plain) line.level = Level::fault;
  line.text = method + ": wrong in " + share_in_words(line.wrong, line.judged) + " " + fmt + " cases";
  line.detail = std::to_string(counts.plain) + " plain, " + std::to_string(counts.boundary) + " on boundaries, " +
                std::to_string(counts.extreme) + " at extreme scale";
  return line;
}

std::string command_of(const std::vector<std::string>& words) {
  std::string text = "tribunal";
  const auto is_option = [](const std::string& word) {
    return word.starts_with("--") && word.find_first_not_of("abcdefghijklmnopqrstuvwxyz-") == std::string::npos;
  };
  for (const std::string& word : words) text += " " + (is_option(word) ? word : shell_word(word));
  return text;
}

/// The words of the record; none if it has none.
std::vector<std::string> words_in(const Run& run) {
  const auto given = run.all().find("command");
  std::vector<std::string> words;
  if (!given || given->json().is_null()) return words;
  for (const Record& word : given->items()) words.push_back(word.text());
  return words;
}

Json command_in(const Run& run) {
  std::vector<std::string> words = words_in(run);
  if (words.empty()) return {};
  words.insert(words.end(), {"--out", run.directory});
  return command_of(words);
}

Json command_alone_in(const Run& run) {
  const std::vector<std::string> words = words_in(run);
  return words.empty() ? Json() : Json(command_of(words));
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ",") + name;
  return text;
}

}  // namespace tribunal
