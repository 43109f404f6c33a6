// What a report is gathered from and into.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "exact/base/record.h"
#include "exact/base/shape.h"
#include "exact/report/case_book.h"

namespace tribunal {

/// How bad the worst is that a run says of a method, the worst first. `pictures`: pixels differ, and no answer is
/// wrong.
enum class Level : std::uint8_t {
  plain,
  fault,
  leaks,
  boundary,
  extreme,
  relations,
  refused,
  incomplete,
  pictures,
  nothing
};

std::string_view name_of(Level level);

/// One line of a report: what one run says of one method, in one format if there is one.
struct ReportLine {
  std::size_t run = 0;
  std::string method{};
  Level level = Level::nothing;
  std::string fmt{};
  std::string text{};    ///< a sentence
  std::string detail{};  ///< more of it
  std::uint64_t wrong = 0, judged = 0;
};

/// A result: a file that a command wrote, what it holds, and what the page is given of it.
struct Run {
  std::size_t number = 0;
  std::string directory{};  ///< of the file
  std::string file{};       ///< its name in there
  Json record{};            ///< as read
  Json page{};              ///< for the page; every run's common members are there first

  std::string path(const std::string& name) const;
  Record all() const { return {record, {path(file)}}; }
};

/// Everything beside the runs themselves.
class Gathering {
 public:
  CaseBook book{};

  /// What a record says of a method: `name`, and any of `number`, `fmt`, `convention`, `exact`, `contract`,
  /// `reference`. What this program knows of a method of that name is added. Returns the name.
  std::string add_method(const Record& row);
  /// The same of a method of which no more is said.
  std::string add_method(const std::string& name);

  void add(ReportLine line) { lines_.push_back(std::move(line)); }
  void leave_out(Run& run, const std::string& what);

  /// A picture beside the run's file, as a data URI: its number, or null if it is missing, or too large for a page.
  /// Fails with Exit::bad_input if it is no PNG.
  Json add_image(Run& run, const std::string& name);

  /// The methods, keyed by name, and their names, exact ones last.
  Json methods() const { return methods_; }
  Json method_order() const;
  Json images() const { return images_; }
  Json left_out() const { return left_out_; }

  /// The lines, the worst first; each with the number of the worst case of its method in its run, if there is one.
  Json verdicts() const;

 private:
  Json methods_ = Json::object(), images_ = Json::array(), left_out_ = Json::array();
  std::vector<ReportLine> lines_;
  std::size_t image_bytes_ = 0;
};

/// A kind of result: how its file is recognised, which cases belong to it, and how the page's members are made of it.
struct ResultKind {
  std::string_view name;
  std::string_view prefix, suffix;   ///< of the file's name
  std::string_view key;              ///< that the record has
  std::string (*cases)(const Run&);  ///< name of the case file in the directory; empty if there is none
  void (*gather)(Run&, Gathering&);
};

void gather_fuzz(Run& run, Gathering& g);
void gather_relations(Run& run, Gathering& g);
void gather_certificate(Run& run, Gathering& g);
void gather_sweep(Run& run, Gathering& g);
void gather_compilers(Run& run, Gathering& g);
void gather_map(Run& run, Gathering& g);
void gather_chart(Run& run, Gathering& g);
void gather_leak(Run& run, Gathering& g);
void gather_render(Run& run, Gathering& g);
void gather_bench(Run& run, Gathering& g);

// --- what these are made of ---------------------------------------------------------------------------------------

/// "123 of 4567 (2.69 %)".
std::string share_in_words(std::uint64_t part, std::uint64_t whole);

/// What is counted of answers.
struct Figures {
  std::uint64_t judged = 0, wrong = 0, plain = 0, boundary = 0, extreme = 0, fault = 0;

  /// Of a row with the members "plain", "boundary" and "extreme", which may be missing.
  void add_severities(const Record& row);
};

/// The worst severity of which there is a case; `nothing` if all are 0.
Level worst_level(const Figures& f);

/// The level, and as `text` "mine: wrong in 2 of 8 (25 %) binary64 cases", or "mine: nothing wrong in 8 binary64 cases"
/// with the `detail` "so at most 31.2 % wrong of such cases, with 95 % confidence".
ReportLine line_of(std::size_t run, const std::string& method, const std::string& fmt, const Figures& counts);

/// A count of a record, or of a group of it; 0 where the record leaves it out.
inline std::uint64_t number_in(const Record& row, const char* key) { return row.count_or(key, 0); }
std::uint64_t number_in(const Record& row, const char* group, const char* key);

/// "seed", as an option's value.
std::string seed_in(const Record& r);

/// The texts of the members `key` of the objects, each once, in their order.
std::vector<std::string> names_in(const std::vector<Record>& objects, const char* key);

using shape::require_part;

/// `tribunal WORDS…`, each word as a shell takes it.
std::string command_of(const std::vector<std::string>& words);

/// The command whose words the record holds, with --out for the run's directory; null of a record without words.
Json command_in(const Run& run);

/// The same without --out: for a record of which the directory holds a part.
Json command_alone_in(const Run& run);

/// "a,b".
std::string joined(const std::vector<std::string>& names);

}  // namespace tribunal
