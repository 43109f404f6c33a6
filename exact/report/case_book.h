// The counterexamples of a report: read from every run, the worst and most diverse of them chosen, each shown with what
// decides it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "exact/cases/case_io.h"
#include "exact/trial/outcome.h"

namespace tribunal {

/// A case of a run, and where it was read.
struct FoundCase {
  std::size_t run = 0;
  std::string file{};
  std::size_t line = 0;  ///< from 1
  Case c{};
  Rank rank{};
};

/// The text of a key, or "" if the value is no object, lacks the key or has something else there: findings come from
/// files.
std::string text_in(const Json& object, const char* key);

/// Chooses at most `most` of the cases, and returns their indices. Cases of one run, method, outcome, severity, family
/// and class are a group. First comes the worst of each group, then the second worst of each, and so on; among those,
/// the worst first. So a rare failure stays beside thousands of a common one.
std::vector<std::size_t> worst_and_most_diverse(const std::vector<FoundCase>& found, std::size_t most);

class CaseBook {
 public:
  /// Reads a case file of this run; an empty one holds no cases. A case of more than `longest_line` bytes is counted
  /// and left out.
  void read(std::size_t run, const std::string& file);

  /// Chooses, and numbers what was chosen, the worst first.
  void choose(std::size_t most);

  /// The number of the case with this id in this run, if it was chosen.
  std::optional<std::size_t> number_of(std::size_t run, const std::string& id) const;

  /// Numbers of a run's cases, the worst first.
  std::vector<std::size_t> numbers_of(std::size_t run) const;

  /// How many cases the run's files hold.
  std::size_t found_in(std::size_t run) const;

  /// The chosen ones as the report shows them, by number.
  Json shown() const;

  /// Names of the methods in the order of the letters of `answers`.
  Json answer_methods() const { return answer_methods_; }

  const FoundCase& at(std::size_t number) const { return found_[chosen_[number]]; }
  std::size_t size() const { return chosen_.size(); }

  static constexpr std::size_t longest_line = 40'000;

 private:
  void note_answers(const Case& c);

  std::vector<FoundCase> found_;
  std::vector<std::size_t> chosen_;
  std::map<std::pair<std::size_t, std::string>, std::size_t> numbers_;
  std::map<std::size_t, std::size_t> not_shown_;
  std::vector<std::string> answer_methods_;
};

}  // namespace tribunal
