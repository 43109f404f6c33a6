#include <algorithm>
#include <bit>
#include <optional>

#include "exact/base/foreign_json.h"
#include "exact/cases/case_io.h"
#include "exact/cases/case_scan.h"
#include "exact/record/answer_line.h"
#include "exact/record/chain.h"
#include "tests/fuzz/memory_file.h"
#include "tests/fuzz/targets.h"

namespace tribunal::fuzzing {
namespace {

/// What is written of a case is read as the same case.
void demand_same_again(const Case& c) {
  const std::string line = from_case(c).dump();
  const std::vector<Case> again = cases_in(line + "\n", "again");
  demand(again.size() == 1 && from_case(again[0]).dump() == line, "read again it is another case: " + line);
}

/// Calls visit(line) for each.
template <class Visit>
void for_each_line_of(std::string_view text, const Visit& visit) {
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    visit(text.substr(begin, end - begin));
    begin = end + 1;
  }
}

/// Where the scanner takes a line, the library reads the same case there.
void demand_same_by_scanner(std::string_view line) {
  Case quick;
  if (!scan_case(line, quick)) return;
  const std::string text = from_case(quick).dump();
  const bool accepted = accepts([&] {
    const Where where{"fuzzed", 1};
    const Case slow = to_case(parse_json_beyond(line, where), where);
    demand(from_case(slow).dump() == text, "the scanner reads another case: " + text);
  });
  demand(accepted, "the scanner takes what is refused otherwise");
}

bool same(const std::optional<HitAt>& a, const std::optional<HitAt>& b) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  if (a.has_value() != b.has_value()) return false;
  if (!a) return true;
  if (bits(a->t) != bits(b->t) || a->weights.has_value() != b->weights.has_value()) return false;
  return !a->weights || (bits(a->weights->b) == bits(b->weights->b) && bits(a->weights->c) == bits(b->weights->c));
}

}  // namespace

void answers(std::string_view bytes) {
  for_each_line_of(bytes, [](std::string_view line) {
    GivenAnswer quick, slow;
    const bool scanned = scan_answer(line, quick);
    const bool accepted = accepts([&] {
      const Where where{"fuzzed", 1};
      slow = to_given_answer(parse_json_beyond(line, where), where);
      demand(!slow.id.empty() && !slow.method.empty(), "an answer to nothing, or of nobody");
    });
    if (!scanned) return;
    demand(accepted, "the scanner takes what is refused otherwise");
    demand(quick.id == slow.id && quick.method == slow.method && quick.answer == slow.answer &&
               same(quick.numbers, slow.numbers),
           "the scanner reads another answer");
  });
}

void cases(std::string_view bytes) {
  for_each_line_of(bytes, demand_same_by_scanner);
  accepts([&] {
    const std::vector<Case> read = cases_in(bytes, "fuzzed");
    demand(!read.empty(), "a file without cases was accepted");
    for (const Case& c : read) demand_same_again(c);
  });
}

void chain(std::string_view bytes) {
  const MemoryFile file(bytes);
  accepts([&] {
    const LogRecords log = read_log(file.path());
    ChainedLog again;
    for (const Json& r : log.records) again.add(r);
    again.finish();
    demand(again.text().at(0, bytes.size() + 1) == bytes, "an accepted log is written otherwise");
    std::size_t i = 0;
    Log(file.path()).for_each([&](const Record& r) {
      demand(r.json() == log.records[i++], "streamed, it is another log");
    });
    demand(i == log.size(), "streamed, it has other records");
  });
}

}  // namespace tribunal::fuzzing
