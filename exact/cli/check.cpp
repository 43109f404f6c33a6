// tribunal check: a method held against what a case file itself expects.
#include <memory>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/shown.h"
#include "exact/base/spool.h"
#include "exact/cases/case_blocks.h"
#include "exact/cli/command.h"
#include "exact/record/counterexample.h"
#include "exact/trial/describe.h"
#include "exact/trial/observe.h"

namespace tribunal {
namespace {

struct Options {
  std::string methods, file;
  bool exact = false;
  unsigned threads = 1;
};

/// How one method did on the cases that expect something and that it answered: counts, and a line for each failure.
template <class Text>
struct Score {
  std::uint64_t checked = 0, failed = 0, unanswered = 0;
  Text failures{};
};

/// Of some cases. `Text` is what their lines are kept in.
template <class Text>
struct Checked {
  std::uint64_t cases = 0, silent = 0;
  std::vector<Score<Text>> scores{};  ///< by method
  Text contradictions{};              ///< what the file says of its own cases and the exact answer contradicts
};

std::string hit_or_miss(bool hit) { return hit ? "a hit" : "no hit"; }

/// The same for a case with numbers that are not finite, which expects to be refused.
void check_nonfinite(const Method& method, const Case& c, Score<std::string>& score) {
  const Asked seen = try_ask(method, c.query);
  ++score.checked;
  if (!seen.fault && seen.answer.status == Status::nonfinite) return;
  ++score.failed;
  score.failures += shown(c.id) + "  " + method.name + ": expected nonfinite, found " +
                    (seen.fault ? describe(seen.fault) : std::string(name_of(seen.answer.status))) + "\n";
}

/// Counts the case, and adds a line where the method does not answer as the file expects.
void check(const Method& method, const Case& c, Score<std::string>& score) {
  if (!is_finite(c.query)) return check_nonfinite(method, c, score);
  const Asked seen = try_ask(method, c.query);
  if (!seen.fault && (seen.answer.status != Status::ok || !takes(method, c.format))) {
    ++score.unanswered;
    return;
  }
  ++score.checked;
  if (!seen.fault && seen.answer.hit == *c.expect) return;
  ++score.failed;
  score.failures += shown(c.id) + "  " + method.name + ": expected " + hit_or_miss(*c.expect) + ", found " +
                    (seen.fault ? describe(seen.fault) : hit_or_miss(seen.answer.hit)) + "\n";
}

bool expects(const Case& c) { return c.expect || !is_finite(c.query); }

void check(const std::vector<Method>& methods, bool exact, const Case& c, Checked<std::string>& checked) {
  ++checked.cases;
  checked.silent += expects(c) ? 0 : 1;
  checked.scores.resize(methods.size());
  for (std::size_t m = 0; expects(c) && m < methods.size(); ++m) check(methods[m], c, checked.scores[m]);
  if (!exact || !is_finite(c.query)) return;
  if (const std::string mistake = mistaken_claim(c, exact_truth(c.query)); !mistake.empty()) {
    checked.contradictions += shown(c.id) + "  THE FILE IS WRONG: " + mistake + "\n";
  }
}

void add(Checked<Spool>& all, const Checked<std::string>& block) {
  all.cases += block.cases;
  all.silent += block.silent;
  all.contradictions.write(block.contradictions);
  for (std::size_t m = 0; m < block.scores.size(); ++m) {
    const Score<std::string>& score = block.scores[m];
    all.scores[m].checked += score.checked;
    all.scores[m].failed += score.failed;
    all.scores[m].unanswered += score.unanswered;
    all.scores[m].failures.write(score.failures);
  }
}

std::string summary_of(const Method& method, const Score<Spool>& s) {
  return method.name + ": " + std::to_string(s.failed) + " of " + std::to_string(s.checked) +
         " answers are not what the file expects" +
         (s.unanswered == 0 ? "" : "; " + std::to_string(s.unanswered) + " cases beyond what it takes") + "\n";
}

void print_all(const Spool& text) {
  text.for_each_piece([](std::string_view piece) { print(piece); });
}

int run(const Options& o) {
  const std::vector<Method> methods = methods_on_trial(o.methods);
  Checked<Spool> all;
  for (std::size_t m = 0; m < methods.size(); ++m) all.scores.emplace_back();
  const auto work = [&](const Case& c, CasePlace, Checked<std::string>& block) { check(methods, o.exact, c, block); };
  for_each_case<Checked<std::string>>(o.file, {o.threads, "nothing was checked"}, work,
                                      [&](const Checked<std::string>& block) { add(all, block); });
  bool failed = all.contradictions.size() > 0;
  std::string summaries;
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const Score<Spool>& score = all.scores[m];
    if (score.checked == 0) {
      throw bad_input(o.file, 0, "nothing to check: no case expects anything that " + methods[m].name + " answers");
    }
    failed |= score.failed > 0;
    summaries += summary_of(methods[m], score);
  }
  if (all.silent > 0)
    summaries += std::to_string(all.silent) + " of " + std::to_string(all.cases) + " cases expect nothing\n";
  print_all(all.contradictions);
  for (const Score<Spool>& score : all.scores) print_all(score.failures);
  print(summaries);
  return code(failed ? Exit::disagreement : Exit::ok);
}

}  // namespace

Action declare_check(Arguments& arguments) {
  const auto o = std::make_shared<Options>();
  arguments.option("FILE", o->file, "case file (JSON Lines) with \"expect\"; - is standard input").required();
  add_methods_option(arguments, o->methods);
  arguments.flag("--exact", o->exact, "hold what the file expects against the exact answer too");
  add_threads_option(arguments, o->threads);
  return with_plugins(arguments, [o] { return run(*o); });
}

}  // namespace tribunal
