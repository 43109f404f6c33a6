#include "exact/certificate/judge_files.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

#include "exact/base/failure.h"
#include "exact/base/progress.h"
#include "exact/base/shown.h"
#include "exact/cases/case_blocks.h"
#include "exact/record/answer_line.h"
#include "exact/record/counterexample.h"
#include "exact/record/id_index.h"
#include "exact/trial/formulations.h"

namespace tribunal {
namespace {

constexpr const char* missing = "nothing was judged";

Method method_of(const std::string& name, const Contract& contract) {
  Method method{};
  method.name = name;
  method.card = {.number = "unknown", .summary = "answers computed elsewhere", .reference = ""};
  method.contract = contract;
  method.tells_contact = method.tells_side = true;  // where it is said
  return method;
}

Judgement empty_judgement(const std::vector<std::string>& names, const Contract& contract) {
  Judgement all;
  for (const std::string& name : names) all.methods.push_back({method_of(name, contract)});
  return all;
}

/// What came of the cases of a block.
struct JudgedBlock {
  std::vector<Fingerprint> ids{};
  std::vector<OwnCounts<std::string>> methods{};
  bool any_triangles = false, any_bounds = false;
  std::uint64_t cases = 0;
};

void add(Judgement& all, const JudgedBlock& block) {
  for (std::size_t m = 0; m < block.methods.size(); ++m) add(all.methods[m].counts, block.methods[m]);
  all.any_triangles |= block.any_triangles;
  all.any_bounds |= block.any_bounds;
}

/// The exact answer to case `number`; fails where the case claims another.
Truth truth_of(const Case& c, std::uint64_t number, const std::string& path, std::size_t line) {
  if (!is_finite(c.query)) return {};
  const Truth truth = truth_of_own(c.query, number);
  const std::string error = mistaken_claim(c, truth);
  if (!error.empty()) throw bad_input(path, line, shown(c.id) + ": " + error);
  return truth;
}

/// Counts the answers to a case: given(m) → what method m answered, and its numbers.
template <class Given>
void judge(JudgedBlock& block, const Judgement& all, const Case& c, const Truth& truth, std::uint64_t number,
           const Given& given) {
  block.methods.resize(all.methods.size());
  block.any_triangles |= c.query.operands() == Operands::triangles;
  block.any_bounds |= c.query.bounds.has_value();
  ++block.cases;
  for (std::size_t m = 0; m < all.methods.size(); ++m) {
    const std::pair<Answer, std::optional<HitAt>> answer = given(m);
    block.methods[m].gives_numbers |= answer.second.has_value();
    const auto numbers = [&] { return answer.second; };
    add(block.methods[m], all.methods[m].method, {c, truth, answer.first, numbers, number});
  }
}

/// Fails: the file is read again for the ids and the numbers of their lines. Returns where two ids only share a
/// fingerprint.
void refuse_same_ids(const Rereadable& cases, const SameId& same) {
  std::uint64_t number = 0;
  std::string first;
  std::size_t first_line = 0;
  LineReader reader = cases.reader();
  Case c;
  for (LineBlock block; reader.next(block, lines_a_block, bytes_a_block);) {
    block.for_each(cases.path(), [&](std::string_view line, std::size_t at) {
      const std::uint64_t n = number++;
      if (n != same.first && n != same.second) return;
      read_case(line, cases.path(), at, c);
      if (n == same.first) {
        first = c.id;
        first_line = at;
      } else if (c.id == first) {
        throw bad_input(cases.path(), at,
                        "id \"" + shown(first) + "\" again, it was on line " + std::to_string(first_line) +
                            "; expected one case an id");
      }
    });
  }
  throw Failure(Exit::resources, cases.path() + ": two of its ids have one fingerprint; rename one of the cases " +
                                     std::to_string(same.first + 1) + " and " + std::to_string(same.second + 1));
}

// --- side by side ----------------------------------------------------------------------------------------------------

/// The answers are not in the order of the cases, or something is wrong with them: what, is found out otherwise.
struct NotInOrder {};

/// The methods that answer the first case; empty where that cannot be seen.
std::vector<std::string> first_methods(const Rereadable& answers) {
  LineReader reader = answers.reader();
  LineBlock block;
  if (!reader.next(block, lines_a_block, bytes_a_block)) return {};
  std::vector<std::string> methods;
  GivenAnswer given;
  std::string id;
  bool done = false;
  try {
    block.for_each(answers.path(), [&](std::string_view line, std::size_t number) {
      if (done) return;
      read_answer(line, answers.path(), number, given);
      if (methods.empty()) id = given.id;
      done = given.id != id;
      if (!done) methods.push_back(given.method);
    });
  } catch (const Failure&) {
    return {};
  }
  std::vector<std::string> sorted = methods;
  std::ranges::sort(sorted);
  return std::ranges::adjacent_find(sorted) == sorted.end() ? methods : std::vector<std::string>{};
}

struct BlockPair {
  LineBlock cases{}, answers{};
  std::uint64_t first = 0;  ///< the number of its first case
};

/// The lines of a block that are not blank, with their numbers.
std::vector<std::pair<std::string_view, std::size_t>> lines_of(const LineBlock& block) {
  std::vector<std::pair<std::string_view, std::size_t>> lines;
  lines.reserve(block.lines);
  block.for_each("", [&](std::string_view line, std::size_t number) { lines.emplace_back(line, number); });
  return lines;
}

class SideBySide {
 public:
  SideBySide(const Rereadable& cases, const Rereadable& answers, const Contract& contract)
      : cases_(cases), answers_(answers), names_(first_methods(answers)), all_(empty_judgement(names_, contract)) {}

  /// Throws NotInOrder.
  Judgement run(unsigned threads) {
    if (names_.empty()) throw NotInOrder();
    LineReader cases = cases_.reader(), answers = answers_.reader();
    std::uint64_t read = 0;
    const auto next = [&](BlockPair& pair) {
      pair.first = read;
      const bool more = cases.next(pair.cases, lines_a_block, bytes_a_block);
      const std::size_t due = more ? pair.cases.lines * names_.size() : 1;
      answers.next(pair.answers, due, most_answer_bytes);
      read += more ? pair.cases.lines : 0;
      if (pair.answers.too_long || pair.answers.lines != (more ? due : 0)) {
        if (!pair.cases.too_long) throw NotInOrder();
      }
      return more;
    };
    const auto work = [this](const BlockPair& pair, JudgedBlock& block) { judge_pair(pair, block); };
    const auto take = [this](const JudgedBlock& block) {
      for (const Fingerprint& f : block.ids) ids_.add(f);
      add(all_, block);
      progress_.add(block.cases, 0);
    };
    run_in_order<BlockPair, JudgedBlock>(threads, missing, next, work, take);
    if (read == 0) throw NotInOrder();
    if (const auto same = ids_.first_repeated()) refuse_same_ids(cases_, *same);
    return std::move(all_);
  }

 private:
  /// More than any block of answers of the usual kind has.
  static constexpr std::size_t most_answer_bytes = std::size_t{1} << 25;

  void judge_pair(const BlockPair& pair, JudgedBlock& block) const {
    const auto answers = pair.cases.too_long ? decltype(lines_of(pair.answers)){} : lines_of(pair.answers);
    std::vector<GivenAnswer> given(names_.size());
    Case c;
    std::size_t at = 0;
    pair.cases.for_each(cases_.path(), [&](std::string_view line, std::size_t number) {
      read_case(line, cases_.path(), number, c);
      block.ids.push_back(fingerprint_of(c.id));
      if (pair.cases.too_long) return;  // a later line is wrong, and that is all that matters
      for (std::size_t m = 0; m < names_.size(); ++m) read(answers[at * names_.size() + m], c.id, names_[m], given[m]);
      const Truth truth = truth_of(c, pair.first + at, cases_.path(), number);
      judge(block, all_, c, truth, pair.first + at, [&](std::size_t m) {
        return std::pair{given[m].answer, given[m].numbers};
      });
      ++at;
    });
  }

  void read(const std::pair<std::string_view, std::size_t>& line, const std::string& id, const std::string& method,
            GivenAnswer& given) const {
    try {
      read_answer(line.first, answers_.path(), line.second, given);
    } catch (const Failure&) {
      throw NotInOrder();
    }
    if (given.id != id || given.method != method) throw NotInOrder();
  }

  const Rereadable &cases_, &answers_;
  const std::vector<std::string> names_;
  Judgement all_;
  IdSpools ids_{};
  Progress progress_{"judge", "cases", 0};
};

// --- in any order ----------------------------------------------------------------------------------------------------

/// The answers of one method, each in two bytes, with numbers where it gives any. A method with few answers has no
/// place for all, so that many methods take no more than their answers are.
class Sheet {
 public:
  Sheet(std::string name, std::size_t cases) : name_(std::move(name)), cases_(cases) {}

  const std::string& name() const { return name_; }
  bool gives_numbers() const { return gives_numbers_; }
  std::size_t answered() const { return answered_; }

  /// False if there is an answer to the case already.
  bool add(std::uint32_t number, const Answer& answer, const std::optional<HitAt>& numbers) {
    gives_numbers_ |= numbers.has_value();
    if (dense_.empty() && (answered_ + 1) * sparse_share > cases_) spread();
    if (!dense_.empty()) {
      if (dense_[number] != 0) return false;
      dense_[number] = packed(answer);
      if (numbers) place_of_numbers(number) = numbers;
    } else if (!sparse_.emplace(number, std::pair{packed(answer), numbers}).second) {
      return false;
    }
    ++answered_;
    return true;
  }

  /// The first case without an answer, if one has none.
  std::optional<std::size_t> first_missing() const {
    if (answered_ == cases_) return {};
    std::size_t i = 0;
    while (dense_.empty() ? sparse_.contains(static_cast<std::uint32_t>(i)) : dense_[i] != 0) ++i;
    return i;
  }

  /// Once nothing is missing.
  std::pair<Answer, std::optional<HitAt>> at(std::size_t i) const {
    return {unpacked(dense_[i]), numbers_.empty() ? std::nullopt : numbers_[i]};
  }

 private:
  static constexpr std::size_t sparse_share = 64;

  static std::uint16_t packed(const Answer& a) {
    return static_cast<std::uint16_t>(1 | (a.hit ? 2 : 0) | static_cast<int>(a.contact) << 2 |
                                      static_cast<int>(a.facing) << 5 | static_cast<int>(a.status) << 7);
  }

  static Answer unpacked(std::uint16_t bits) {
    Answer a{.hit = (bits & 2) != 0,
             .contact = static_cast<Contact>(bits >> 2 & 7),
             .status = static_cast<Status>(bits >> 7)};
    a.facing = static_cast<Facing>(bits >> 5 & 3);
    return a;
  }

  std::optional<HitAt>& place_of_numbers(std::size_t number) {
    if (numbers_.empty()) numbers_.resize(cases_);
    return numbers_[number];
  }

  void spread() {
    dense_.resize(cases_);
    for (const auto& [number, answer] : sparse_) {
      dense_[number] = answer.first;
      if (answer.second) place_of_numbers(number) = answer.second;
    }
    sparse_ = {};
  }

  std::string name_;
  std::size_t cases_, answered_ = 0;
  bool gives_numbers_ = false;
  std::unordered_map<std::uint32_t, std::pair<std::uint16_t, std::optional<HitAt>>> sparse_{};
  std::vector<std::uint16_t> dense_{};
  std::vector<std::optional<HitAt>> numbers_{};
};

/// One answer of a block, with the number of its case if there is such a case.
struct PlacedAnswer {
  std::size_t line = 0;
  std::optional<std::uint32_t> number{};
  GivenAnswer given{};
};

/// A block of answers, up to the first line that is wrong.
struct PlacedBlock {
  std::vector<PlacedAnswer> answers{};
  std::exception_ptr failure{};
};

class ByIndex {
 public:
  ByIndex(const Rereadable& cases, const Rereadable& answers) : cases_(cases), answers_(answers) {}

  Judgement run(const Contract& contract, unsigned threads) {
    index_cases(threads);
    read_answers(threads);
    require_all();
    return judge_all(contract, threads);
  }

 private:
  void index_cases(unsigned threads) {
    const auto work = [](const Case& c, CasePlace, std::vector<Fingerprint>& ids) {
      ids.push_back(fingerprint_of(c.id));
    };
    const auto take = [this](const std::vector<Fingerprint>& ids) {
      for (const Fingerprint& f : ids) index_.add(f);
    };
    for_each_case<std::vector<Fingerprint>>(cases_.reader(), cases_.path(), {threads, missing}, work, take);
    if (const auto same = index_.sort()) refuse_same_ids(cases_, *same);
  }

  void read_answers(unsigned threads) {
    LineReader reader = answers_.reader();
    const auto read = [&](LineBlock& block) { return reader.next(block, lines_a_block, bytes_a_block); };
    const auto work = [this](const LineBlock& lines, PlacedBlock& block) {
      try {
        lines.for_each(answers_.path(), [&](std::string_view line, std::size_t number) {
          PlacedAnswer placed{.line = number};
          read_answer(line, answers_.path(), number, placed.given);
          placed.number = index_.find(fingerprint_of(placed.given.id));
          block.answers.push_back(std::move(placed));
        });
      } catch (const Failure&) {
        block.failure = std::current_exception();
      }
    };
    const auto take = [this](const PlacedBlock& block) {
      for (const PlacedAnswer& a : block.answers) place(a);
      if (block.failure) std::rethrow_exception(block.failure);
    };
    run_in_order<LineBlock, PlacedBlock>(threads, missing, read, work, take);
    if (sheets_.empty()) throw bad_input(answers_.path(), 0, "holds no answers, expected one JSON object a line");
  }

  void place(const PlacedAnswer& a) {
    if (!a.number) {
      throw bad_input(answers_.path(), a.line, "answers \"" + shown(a.given.id) + "\", which is no case's id");
    }
    const auto [at, fresh] = by_name_.try_emplace(a.given.method, sheets_.size());
    if (fresh) sheets_.emplace_back(a.given.method, index_.size());
    if (sheets_[at->second].add(*a.number, a.given.answer, a.given.numbers)) return;
    throw bad_input(answers_.path(), a.line,
                    "a second answer of " + a.given.method + " to \"" + shown(a.given.id) + "\", expected one");
  }

  void require_all() const {
    for (const Sheet& sheet : sheets_) {
      const auto first = sheet.first_missing();
      if (!first) continue;
      throw bad_input(answers_.path(), 0,
                      std::to_string(index_.size() - sheet.answered()) + " of " + std::to_string(index_.size()) +
                          " answers of " + sheet.name() + " are missing, the first to \"" + shown(id_of(*first)) +
                          "\"; expected one for each case");
    }
  }

  /// The file is read again for it.
  std::string id_of(std::size_t number) const {
    LineReader reader = cases_.reader();
    Case c;
    std::string id;
    std::size_t at = 0;
    for (LineBlock block; at <= number && reader.next(block, lines_a_block, bytes_a_block);) {
      block.for_each(cases_.path(), [&](std::string_view line, std::size_t line_number) {
        if (at++ != number) return;
        read_case(line, cases_.path(), line_number, c);
        id = c.id;
      });
    }
    return id;
  }

  Judgement judge_all(const Contract& contract, unsigned threads) {
    std::vector<std::string> names;
    for (const Sheet& sheet : sheets_) names.push_back(sheet.name());
    Judgement all = empty_judgement(names, contract);
    LineReader reader = cases_.reader();
    std::uint64_t read = 0;
    Progress progress("judge", "cases", index_.size());
    const auto next = [&](BlockPair& pair) {
      pair.first = read;
      const bool more = reader.next(pair.cases, lines_a_block, bytes_a_block);
      read += more ? pair.cases.lines : 0;
      return more;
    };
    const auto work = [&](const BlockPair& pair, JudgedBlock& block) {
      Case c;
      std::uint64_t number = pair.first;
      pair.cases.for_each(cases_.path(), [&](std::string_view line, std::size_t line_number) {
        read_case(line, cases_.path(), line_number, c);
        if (index_.find(fingerprint_of(c.id)) != number) {
          throw bad_input(cases_.path(), line_number, "was changed while it was read");
        }
        const Truth truth = truth_of(c, number, cases_.path(), line_number);
        judge(block, all, c, truth, number, [&](std::size_t m) { return sheets_[m].at(number); });
        ++number;
      });
    };
    const auto take = [&](const JudgedBlock& block) {
      add(all, block);
      progress.add(block.cases, 0);
    };
    run_in_order<BlockPair, JudgedBlock>(threads, missing, next, work, take);
    return all;
  }

  const Rereadable &cases_, &answers_;
  IdIndex index_{};
  std::vector<Sheet> sheets_{};
  std::unordered_map<std::string, std::size_t> by_name_{};
};

}  // namespace

Judgement judge_files(const Rereadable& cases, const Rereadable& answers, const Contract& contract, unsigned threads) {
  try {
    return SideBySide(cases, answers, contract).run(threads);
  } catch (const NotInOrder&) {
    return ByIndex(cases, answers).run(contract, threads);
  }
}

}  // namespace tribunal
