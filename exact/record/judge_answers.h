// Answers that were computed elsewhere, held against the exact ones.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "exact/cases/case_io.h"
#include "exact/trial/truth.h"

namespace tribunal {

/// One method's answers, one for each case and in the order of the cases. Only `hit`, `status` and, of hits that say
/// it, the contact are set. `numbers`: of hits that say it, t and the weights of b and c.
struct AnswerSheet {
  std::string method;
  std::vector<Answer> answers;
  std::vector<std::optional<HitAt>> numbers;

  bool gives_numbers() const {
    return std::ranges::any_of(numbers, [](const auto& n) { return n.has_value(); });
  }
};

/// A case file with its exact answers, in the file's order; a case that is not finite has none, and its truth no
/// meaning.
struct Exam {
  std::vector<Case> cases{};
  std::vector<Truth> truths{};
};

/// Reads a case file and answers it exactly. Fails with Exit::bad_input where two cases share an id or a case claims
/// something false of itself; with 128 + signal if interrupted.
Exam read_exam(const std::string& path, unsigned threads);

/// Reads an answer file: for every method that it names, in the order in which it names them, exactly one answer to
/// every case of the exam (by its id). Answers without a method belong to one called "answers". Fails with
/// Exit::bad_input at an unknown id, a second answer, an answer that says nothing; and, with their number, where
/// answers are missing.
std::vector<AnswerSheet> read_answers(const std::string& path, const Exam& exam);

/// The sheet as a method with this contract: to be judged and reported as one, not to be asked.
Method method_of(const AnswerSheet& sheet, const Contract& contract);

}  // namespace tribunal
