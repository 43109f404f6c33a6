#include "exact/trial/outcome.h"

#include "exact/trial/judge.h"

namespace tribunal {
namespace {

const char* words_of(Outcome o) {
  constexpr const char* words[] = {"is right",
                                   "reports a hit where a miss is due",
                                   "misses a hit that is due",
                                   "is right about the hit and tells a wrong contact",
                                   "did something else than answer",
                                   "declined, although its contract takes the case",
                                   "owes no answer"};
  return words[static_cast<int>(o)];
}

const char* words_of(Severity s) {
  constexpr const char* words[] = {"in plain general position", "degenerate or nearly, at everyday scale",
                                   "at an extreme scale"};
  return words[static_cast<int>(s)];
}

const char* words_of(Cause c) {
  constexpr const char* words[] = {"logic: it is wrong without rounding too", "rounding: without it, it is right",
                                   "cause unknown: there is no exact twin to ask"};
  return words[static_cast<int>(c)];
}

}  // namespace

Cause cause_of(const Method& method, const Query& query, const Truth& truth, Outcome outcome) {
  if (!method.exact_twin || outcome == Outcome::fault) return Cause::unknown;
  return is_wrong(judge(method, truth, method.exact_twin(query))) ? Cause::logic : Cause::rounding;
}

std::string in_words(Outcome outcome, Severity severity, Cause cause) {
  const std::string text = std::string(words_of(outcome)) + ", " + words_of(severity);
  return outcome == Outcome::fault ? text : text + "; " + words_of(cause);
}

}  // namespace tribunal
