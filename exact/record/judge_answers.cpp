#include "exact/record/judge_answers.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <unordered_map>

#include "exact/base/failure.h"
#include "exact/base/foreign_json.h"
#include "exact/base/interrupt.h"
#include "exact/base/parallel.h"
#include "exact/base/progress.h"
#include "exact/base/record.h"
#include "exact/base/shown.h"
#include "exact/record/counterexample.h"

namespace tribunal {
namespace {

/// Answers all cases of the exam exactly. Fails where a case claims something false of itself.
void answer_exactly(Exam& exam, const std::string& path, unsigned threads) {
  constexpr std::size_t block_size = 256;
  const std::size_t n = exam.cases.size();
  exam.truths.resize(n);
  Progress progress("judge", "cases", n);
  const auto work = [&](std::size_t block, unsigned) {
    const std::size_t begin = block * block_size, end = std::min(n, begin + block_size);
    for (std::size_t i = begin; i < end; ++i) {
      if (is_finite(exam.cases[i].query)) exam.truths[i] = exact_truth(exam.cases[i].query);
    }
    progress.add(end - begin, 0);
  };
  run_blocks((n + block_size - 1) / block_size, threads, work, {});
  if (interrupted() != 0) throw Failure(static_cast<Exit>(128 + interrupted()), "interrupted; nothing was judged");
  for (std::size_t i = 0; i < n; ++i) {
    if (!is_finite(exam.cases[i].query)) continue;
    const std::string error = mistaken_claim(exam.cases[i], exam.truths[i]);
    if (!error.empty()) throw bad_input(path, 0, shown(exam.cases[i].id) + ": " + error);
  }
}

/// Reads the cases, refusing a second one of the same id at its line.
Exam read_distinct_cases(const std::string& path) {
  Exam exam;
  std::unordered_map<std::string, std::size_t> lines;
  for_each_line(path, [&](const Json& object, const Where& where) {
    exam.cases.push_back(to_case(object, where));
    const auto [first, fresh] = lines.emplace(exam.cases.back().id, where.line);
    if (fresh) return;
    where.fail("id \"" + first->first + "\" again, it was on line " + std::to_string(first->second) +
               "; expected one case an id");
  });
  if (exam.cases.empty()) throw bad_input(path, 0, "holds no cases, expected one JSON object a line");
  return exam;
}

// --- answer lines --------------------------------------------------------------------------------------------------

std::string text_at(const Json& object, const char* key, const Where& where) { return Record(object, where).name(key); }

/// The fault of an answer with the status "failed", if the line names one.
Status fault_at(const Json& object, const Where& where) {
  if (!object.contains("fault")) return Status::gave_no_answer;
  const std::string name = text_at(object, "fault", where);
  if (const Status fault = fault_named(name); is_fault(fault)) return fault;
  where.key("fault").fail("expected one that docs/formats.md lists, found \"" + name + "\"");
}

Status status_at(const Json& object, const Where& where) {
  if (!object.contains("status")) return Status::ok;
  const std::string name = text_at(object, "status", where);
  for (const Status s : {Status::ok, Status::nonfinite, Status::unsupported}) {
    if (name == name_of(s)) return s;
  }
  if (name == name_of(Status::gave_no_answer)) return fault_at(object, where);
  where.key("status").fail("expected \"ok\", \"nonfinite\", \"unsupported\" or \"failed\", found \"" + name + "\"");
}

/// Unsaid unless the line says it.
Contact contact_at(const Json& object, const Where& where) {
  if (!object.contains("contact")) return Contact::unsaid;
  const std::string name = text_at(object, "contact", where);
  for (const Contact c : {Contact::interior, Contact::edge, Contact::vertex, Contact::coplanar}) {
    if (name == name_of(c)) return c;
  }
  where.key("contact").fail("expected \"interior\", \"edge\", \"vertex\" or \"coplanar\" of a hit, found \"" + name +
                            "\"");
}

/// "t", and with it "weights": those of b and c.
std::optional<HitAt> numbers_at(const Json& object, const Where& where) {
  if (!object.contains("t")) {
    if (object.contains("weights")) where.key("weights").fail("given without \"t\"");
    return std::nullopt;
  }
  if (!object.contains("hit") || object["hit"] != 1) where.key("t").fail("given of what is no hit");
  HitAt at{.t = to_any_number(object["t"], Format::binary64, where.key("t"))};
  if (!object.contains("weights")) return at;
  const Json& weights = object["weights"];
  if (!weights.is_array() || weights.size() != 2) where.key("weights").fail("expected those of b and c, two numbers");
  at.weights = BarycentricWeights{to_any_number(weights[0], Format::binary64, where.key("weights").index(0)),
                                  to_any_number(weights[1], Format::binary64, where.key("weights").index(1))};
  return at;
}

/// Unsaid unless the line says it.
Facing side_at(const Json& object, const Where& where) {
  if (!object.contains("side")) return Facing::unsaid;
  const std::string name = text_at(object, "side", where);
  for (const Facing f : {Facing::front, Facing::back}) {
    if (name == name_of(f)) return f;
  }
  where.key("side").fail("expected \"front\" or \"back\" of a hit, found \"" + name + "\"");
}

/// Keys that this program writes into answers but does not judge are allowed.
Answer to_answer(const Json& object, const Where& where) {
  require_keys(object,
               {"id", "method", "hit", "status", "class", "contact", "at", "side", "stage", "planar", "fault", "detail",
                "t", "weights"},
               where);
  const Status status = status_at(object, where);
  if (status != Status::ok) {
    if (object.contains("hit")) where.key("hit").fail("given with a status that is not \"ok\"");
    return refusal(status);
  }
  const Json& hit = require(object, "hit", where);
  if (hit != 0 && hit != 1) where.key("hit").fail("expected 0 or 1, found " + hit.dump());
  if (hit == 0) return miss();
  Answer answer = hit_at(contact_at(object, where));
  answer.facing = side_at(object, where);
  return answer;
}

/// The answer sheets while an answer file is read.
class Sheets {
 public:
  explicit Sheets(const std::vector<std::string>& ids) : ids_(ids) {
    for (std::size_t i = 0; i < ids.size(); ++i) places_.emplace(ids[i], i);
  }

  void add(const Json& object, const Where& where) {
    const Answer answer = to_answer(object, where);
    const std::string id = text_at(object, "id", where);
    const std::string method = object.contains("method") ? name_at(object, "method", where) : "answers";
    const auto place = places_.find(id);
    if (place == places_.end()) where.fail("answers \"" + id + "\", which is no case's id");
    std::optional<Answer>& slot = sheet_of(method).answers[place->second];
    if (slot) where.fail("a second answer of " + method + " to \"" + id + "\", expected one");
    slot = answer;
    sheet_of(method).numbers[place->second] = numbers_at(object, where);
  }

  std::vector<AnswerSheet> complete(const std::string& path) const {
    if (sheets_.empty()) throw bad_input(path, 0, "holds no answers, expected one JSON object a line");
    std::vector<AnswerSheet> sheets;
    for (const Sheet& s : sheets_) sheets.push_back({s.method, complete(s, path), s.numbers});
    return sheets;
  }

 private:
  struct Sheet {
    std::string method;
    std::vector<std::optional<Answer>> answers;
    std::vector<std::optional<HitAt>> numbers;
  };

  Sheet& sheet_of(const std::string& method) {
    for (Sheet& s : sheets_) {
      if (s.method == method) return s;
    }
    return sheets_.emplace_back(
        Sheet{method, std::vector<std::optional<Answer>>(ids_.size()), std::vector<std::optional<HitAt>>(ids_.size())});
  }

  std::vector<Answer> complete(const Sheet& sheet, const std::string& path) const {
    std::vector<Answer> answers;
    std::size_t missing = 0, first = 0;
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      if (!sheet.answers[i] && missing++ == 0) first = i;
      answers.push_back(sheet.answers[i].value_or(miss()));
    }
    if (missing == 0) return answers;
    throw bad_input(path, 0,
                    std::to_string(missing) + " of " + std::to_string(ids_.size()) + " answers of " + sheet.method +
                        " are missing, the first to \"" + shown(ids_[first]) + "\"; expected one for each case");
  }

  const std::vector<std::string>& ids_;
  std::unordered_map<std::string, std::size_t> places_;
  std::vector<Sheet> sheets_;
};

}  // namespace

Exam read_exam(const std::string& path, unsigned threads) {
  Exam exam = read_distinct_cases(path);
  answer_exactly(exam, path, threads);
  return exam;
}

std::vector<AnswerSheet> read_answers(const std::string& path, const Exam& exam) {
  std::vector<std::string> ids;
  for (const Case& c : exam.cases) ids.push_back(c.id);
  Sheets sheets(ids);
  for_each_line(path, [&](const Json& object, const Where& where) { sheets.add(object, where); });
  return sheets.complete(path);
}

Method method_of(const AnswerSheet& sheet, const Contract& contract) {
  Method method{};
  method.name = sheet.method;
  method.card = {.number = "unknown", .summary = "answers computed elsewhere", .reference = ""};
  method.contract = contract;
  method.tells_contact = method.tells_side = true;  // where it is said
  return method;
}

}  // namespace tribunal
