// The part of kill_verdicts.cpp that is about causes, counts and their texts.
#include <string>
#include <vector>

#include "exact/classes/class_table.h"
#include "exact/trial/count.h"
#include "exact/trial/outcome.h"
#include "tests/mutation/kill.h"

using namespace tribunal;
using killing::require;

namespace {

const Query of_triangle{Segment{}, Triangle{}};
const Query of_polygon{Segment{}, PolygonData{}};
const Truth missed{.class_id = 1};

/// A method whose twin answers so, and counts how often it is asked.
Method with_twin(const Answer& answer, int& asked) {
  Method m;
  m.contract.polygons = Polygons::any;
  m.exact_twin = [&asked, answer](const Query&) {
    ++asked;
    return answer;
  };
  return m;
}

void check_causes() {
  int asked = 0;
  const Method wrong = with_twin(hit_at(Contact::interior), asked), right = with_twin(miss(), asked);
  require(cause_of(wrong, of_triangle, missed, Outcome::false_hit) == Cause::logic, "logic");
  require(cause_of(right, of_triangle, missed, Outcome::false_hit) == Cause::rounding, "rounding");
  require(cause_of(Method{}, of_triangle, missed, Outcome::false_hit) == Cause::unknown, "no twin");
  require(asked == 2, "asked once each");
  require(cause_of(wrong, of_triangle, missed, Outcome::fault) == Cause::unknown && asked == 2, "a fault has no cause");
}

/// Those about which the twin is asked, of 40 wrong answers.
std::vector<int> asked_of(const Query& query, Severity severity, std::uint64_t early, int first) {
  int asked = 0;
  const Method m = with_twin(miss(), asked);
  TwinQuota quota{.early = early};
  std::vector<int> which;
  for (int k = first; k < first + 40; ++k) {
    const int before = asked;
    const Cause cause = quota.cause_of(m, query, missed, Outcome::false_hit, severity, static_cast<std::uint64_t>(k));
    require((cause == Cause::rounding) == (asked > before) && (asked > before || cause == Cause::unknown), "quota");
    if (asked > before) which.push_back(k);
  }
  return which;
}

void check_quota() {
  require(TwinQuota{}.early == 4 && TwinQuota::one_in == 17, "the shares");
  require(asked_of(of_triangle, Severity::boundary, 4, 1) == std::vector<int>{1, 2, 3, 4, 17, 34}, "of triangles");
  require(asked_of(of_triangle, Severity::extreme, 0, 1) == std::vector<int>{17, 34}, "no early ones");
  require(asked_of(of_polygon, Severity::boundary, 4, 1) == std::vector<int>{17, 34}, "of polygons");
  require(asked_of(of_polygon, Severity::plain, 0, 1).size() == 40, "all that are plain");
}

void check_names() {
  constexpr const char* names[] = {"right", "false hit", "false miss", "wrong contact", "fault", "refused", "not owed"};
  int wrong = 0;
  for (int i = 0; i < 7; ++i) {
    const auto o = static_cast<Outcome>(i);
    require(name_of(o) == names[i] && is_wrong(o) == (i >= 1 && i <= 4) && is_judged(o) == (i <= 4), "outcomes");
    const auto named = outcome_named(names[i]);
    require(named.has_value() == is_wrong(o) && (!named || *named == o), "by name");
    if (is_wrong(o)) require(wrong_outcomes[static_cast<std::size_t>(wrong++)] == o, "wrong ones, in order");
  }
  require(!outcome_named("hit") && all_severities.size() == 3, "no other");
  constexpr const char* severities[] = {"plain", "boundary", "extreme"};
  constexpr const char* causes[] = {"logic", "rounding", "unknown"};
  for (int i = 0; i < 3; ++i) {
    require(name_of(static_cast<Severity>(i)) == severities[i] && name_of(static_cast<Cause>(i)) == causes[i], "names");
    require(all_severities[static_cast<std::size_t>(i)] == static_cast<Severity>(i), "the worst first");
  }
  const Rank plain{Severity::plain, true, true, Cause::unknown}, hit{Severity::boundary, false, true, Cause::unknown};
  const Rank naive{Severity::boundary, false, false, Cause::unknown},
      logic{Severity::boundary, false, false, Cause::logic};
  require(plain < hit && naive < hit && logic < naive && hit < Rank{}, "ranks");
  require(Rank{} > hit && hit > naive && naive > logic && hit > plain && !(hit < hit) && hit <= hit,
          "the other way round");
  const Rank contact{Severity::boundary, true, false, Cause::logic};
  require(naive < contact && contact > naive && naive > logic && logic <= naive && contact != naive,
          "wrong contacts last");
}

void check_words() {
  require(in_words(Outcome::right, Severity::plain, Cause::logic) ==
              "is right, in plain general position; logic: it is wrong without rounding too",
          "right");
  require(in_words(Outcome::false_hit, Severity::boundary, Cause::rounding) ==
              "reports a hit where a miss is due, degenerate or nearly, at everyday scale; rounding: without it, it is "
              "right",
          "false hit");
  require(in_words(Outcome::false_miss, Severity::extreme, Cause::unknown) ==
              "misses a hit that is due, at an extreme scale; cause unknown: there is no exact twin to ask",
          "false miss");
  require(in_words(Outcome::fault, Severity::plain, Cause::unknown) ==
              "did something else than answer, in plain general position",
          "fault");
  const auto begins = [](Outcome o, const char* words) {
    return in_words(o, Severity::plain, Cause::logic).starts_with(words);
  };
  require(begins(Outcome::wrong_contact, "is right about the hit and tells a wrong contact,") &&
              begins(Outcome::refused, "declined, although its contract takes the case,") &&
              begins(Outcome::not_owed, "owes no answer,"),
          "the others");
}

Count added(std::initializer_list<Outcome> outcomes, Severity severity, Cause cause) {
  Count c;
  for (const Outcome o : outcomes) {
    c.add(o, Stage::filter);
    if (is_wrong(o)) c.add_wrong(severity, cause);
  }
  return c;
}

void check_sums() {
  const auto all = {Outcome::right,      Outcome::right,         Outcome::false_hit, Outcome::false_miss,
                    Outcome::false_miss, Outcome::wrong_contact, Outcome::fault,     Outcome::refused,
                    Outcome::not_owed,   Outcome::not_owed};
  Count c = added(all, Severity::boundary, Cause::logic);
  require(c.asked == 10 && c.wrong == 5 && c.unsupported == 3 && c.refused == 1 && c.judged() == 7 && c.not_owed() == 2,
          "counts");
  require(c.at(Stage::filter) == 7 && c.at(Stage::exact) == 0 && c.at(Outcome::false_hit) == 1 &&
              c.at(Outcome::false_miss) == 2 && c.at(Outcome::wrong_contact) == 1 && c.at(Outcome::fault) == 1,
          "by kind");
  require(c.at(Severity::boundary) == 5 && c.logic == 5 && c.rounding == 0 && c.unsaid() == 0, "by severity and cause");
  const Count one = c;
  Count other;
  other.add(Outcome::false_hit, Stage::exact);
  other.add_wrong(Severity::plain, Cause::rounding);
  other.add(Outcome::false_hit, Stage::integers);
  other.add_wrong(Severity::extreme, Cause::unknown);
  other.add(Outcome::refused, Stage::none);
  c += other;
  require(c.asked == 13 && c.wrong == 7 && c.unsupported == 4 && c.refused == 2 && c.logic == 5 && c.rounding == 1,
          "sums");
  require(c.by_stage == std::array<std::uint64_t, stage_count>{0, 7, 1, 1} &&
              c.by_outcome == std::array<std::uint64_t, 4>{3, 2, 1, 1} &&
              c.by_severity == std::array<std::uint64_t, 3>{1, 5, 1},
          "sums of each kind");
  require(one == added(all, Severity::boundary, Cause::logic) && !(one == c), "equal counts");
  const auto differs = [&one](std::uint64_t& (*number)(Count&)) {
    Count changed = one;
    ++number(changed);
    return !(changed == one);
  };
  require(differs([](Count& x) -> std::uint64_t& { return x.asked; }) &&
              differs([](Count& x) -> std::uint64_t& { return x.wrong; }) &&
              differs([](Count& x) -> std::uint64_t& { return x.unsupported; }) &&
              differs([](Count& x) -> std::uint64_t& { return x.refused; }) &&
              differs([](Count& x) -> std::uint64_t& { return x.by_stage[3]; }) &&
              differs([](Count& x) -> std::uint64_t& { return x.by_outcome[3]; }) &&
              differs([](Count& x) -> std::uint64_t& { return x.by_severity[2]; }) &&
              differs([](Count& x) -> std::uint64_t& { return x.logic; }) &&
              differs([](Count& x) -> std::uint64_t& { return x.rounding; }),
          "every number counts");
}

void check_breakdown() {
  require(breakdown({}).empty() && breakdown(added({Outcome::right}, {}, {})).empty(), "nothing to say");
  const Count few = added({Outcome::false_hit, Outcome::false_miss, Outcome::wrong_contact, Outcome::fault},
                          Severity::plain, Cause::logic);
  require(breakdown(few) == "1 false hit, 1 false miss, 1 wrong contact, 1 fault; 4 plain; 4 logic", "one of each");
  Count many = few;
  many += few;
  many.refused = 3;
  require(breakdown(many) == "2 false hits, 2 false misses, 2 wrong contacts, 2 faults; 8 plain; 8 logic; 3 refused",
          "two");
  many.rounding = 1;
  many.logic = 2;
  require(breakdown(many).find("; 2 logic, 1 rounding of 3 asked; 3 refused") != std::string::npos, "some asked");
  Count old;
  old.asked = old.wrong = 5;
  require(breakdown(old) == "5 of a kind not said", "an older count");
  old.refused = 1;
  require(breakdown(old) == "5 of a kind not said; 1 refused", "an older count with refusals");
  old.wrong = 0;
  require(breakdown(old) == "1 refused", "refused alone");
  old.wrong = 5;
  old.by_severity = {1, 1, 1};
  require(breakdown(old) == "1 plain, 1 boundary, 1 extreme; 2 of a kind not said; 1 refused", "in part");
}

void check_headline() {
  const auto at = [](Severity s) { return added({Outcome::right, Outcome::false_hit}, s, Cause::unknown); };
  const Count right = added({Outcome::right, Outcome::right}, {}, {}), none;
  require(headline({}) == "nothing was judged" && headline({{"binary64", none}}) == "nothing was judged",
          "nothing judged");
  require(headline({{"binary64", right}, {"sets", none}, {"binary32", right}}) ==
              "nothing wrong of 2 (binary64), 2 (binary32)",
          "nothing wrong");
  require(headline({{"a", right}, {"b", at(Severity::plain)}}) == "wrong in plain general position: 1 of 2 (b)",
          "plain");
  require(headline({{"a", at(Severity::boundary)}, {"b", right}}) == "wrong on boundaries only: 1 of 2 (a)",
          "boundary");
  require(headline({{"a", at(Severity::extreme)}, {"b", at(Severity::extreme)}}) ==
              "wrong at extreme scales only: 1 of 2 (a), 1 of 2 (b)",
          "extreme");
  require(headline({{"a", at(Severity::extreme)}, {"b", at(Severity::boundary)}}) ==
              "wrong on boundaries: 1 of 2 (b); in all 1 of 2 (a), 1 of 2 (b)",
          "the worst first");
  Count old;
  old.asked = 9, old.wrong = 4;
  require(headline({{"a", at(Severity::plain)}, {"b", old}}) ==
              "wrong: 1 of 2 (a), 4 of 9 (b); in what position is not said",
          "older counts");
}

}  // namespace

void check_counts() {
  check_causes();
  check_quota();
  check_names();
  check_words();
  check_sums();
  check_breakdown();
  check_headline();
}
