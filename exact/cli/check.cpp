// tribunal check: a method held against what a case file itself expects.
#include <algorithm>
#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/shown.h"
#include "exact/cli/command.h"
#include "exact/record/counterexample.h"
#include "exact/trial/describe.h"
#include "exact/trial/observe.h"

namespace tribunal {
namespace {

struct Options {
  std::string methods, file;
  bool exact = false;
};

/// How one method did on the cases that expect something and that it answered.
struct Score {
  std::uint64_t checked = 0, failed = 0, unanswered = 0;
};

std::string hit_or_miss(bool hit) { return hit ? "a hit" : "no hit"; }

/// The same for a case with numbers that are not finite, which expects to be refused.
std::string check_nonfinite(const Method& method, const Case& c, Score& score) {
  const Asked seen = try_ask(method, c.query);
  ++score.checked;
  if (!seen.fault && seen.answer.status == Status::nonfinite) return "";
  ++score.failed;
  return shown(c.id) + "  " + method.name + ": expected nonfinite, found " +
         (seen.fault ? describe(seen.fault) : std::string(name_of(seen.answer.status))) + "\n";
}

/// One line for a case that the method does not answer as the file expects; nothing if it does.
std::string check(const Method& method, const Case& c, Score& score) {
  if (!is_finite(c.query)) return check_nonfinite(method, c, score);
  const Asked seen = try_ask(method, c.query);
  if (!seen.fault && (seen.answer.status != Status::ok || !takes(method, c.format))) {
    ++score.unanswered;
    return "";
  }
  ++score.checked;
  if (!seen.fault && seen.answer.hit == *c.expect) return "";
  ++score.failed;
  return shown(c.id) + "  " + method.name + ": expected " + hit_or_miss(*c.expect) + ", found " +
         (seen.fault ? describe(seen.fault) : hit_or_miss(seen.answer.hit)) + "\n";
}

std::string summary_of(const Method& method, const Score& s) {
  return method.name + ": " + std::to_string(s.failed) + " of " + std::to_string(s.checked) +
         " answers are not what the file expects" +
         (s.unanswered == 0 ? "" : "; " + std::to_string(s.unanswered) + " cases beyond what it takes") + "\n";
}

/// What the file says of its own cases and the exact answer contradicts.
std::string contradictions(const std::vector<Case>& cases) {
  std::string text;
  for (const Case& c : cases) {
    if (!is_finite(c.query)) continue;
    if (const std::string mistake = mistaken_claim(c, exact_truth(c.query)); !mistake.empty()) {
      text += shown(c.id) + "  THE FILE IS WRONG: " + mistake + "\n";
    }
  }
  return text;
}

bool expects(const Case& c) { return c.expect || !is_finite(c.query); }

int run(const Options& o) {
  const std::vector<Method> methods = methods_on_trial(o.methods);
  const std::vector<Case> cases = read_cases(o.file);
  const auto silent = std::ranges::count_if(cases, [](const Case& c) { return !expects(c); });
  std::string text = o.exact ? contradictions(cases) : "", summaries;
  bool failed = !text.empty();
  for (const Method& method : methods) {
    Score score;
    for (const Case& c : cases) {
      if (expects(c)) text += check(method, c, score);
    }
    if (score.checked == 0)
      throw bad_input(o.file, 0, "nothing to check: no case expects anything that " + method.name + " answers");
    failed |= score.failed > 0;
    summaries += summary_of(method, score);
  }
  if (silent > 0)
    summaries += std::to_string(silent) + " of " + std::to_string(cases.size()) + " cases expect nothing\n";
  print(text + summaries);
  return code(failed ? Exit::disagreement : Exit::ok);
}

}  // namespace

Action declare_check(Arguments& arguments) {
  const auto o = std::make_shared<Options>();
  arguments.option("FILE", o->file, "case file (JSON Lines) with \"expect\"; - is standard input").required();
  add_methods_option(arguments, o->methods);
  arguments.flag("--exact", o->exact, "hold what the file expects against the exact answer too");
  return with_plugins(arguments, [o] { return run(*o); });
}

}  // namespace tribunal
