// Outcomes and causes: a method that is wrong in one way is said to be wrong in that way, everywhere.
#include <gtest/gtest.h>

#include <algorithm>

#include "exact/cases/case_io.h"
#include "exact/cases/family_table.h"
#include "exact/certificate/verify.h"
#include "exact/record/checkpoint.h"
#include "exact/record/counterexample.h"
#include "exact/record/sample_row.h"
#include "exact/trial/fuzz.h"
#include "tests/exact/certificate_support.h"
#include "tests/planted/bugs.h"

namespace tribunal {
namespace {

using testing_certificates::CertificateTest;
using testing_certificates::method;
using testing_certificates::tiny;

constexpr Triangle floor_of_ten{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};
const Query on_edge{Segment{{2, 0, 1}, {2, 0, -1}}, floor_of_ten};

/// A method that gives `change` of the reference's answer to a segment.
Method changed(const char* name, const std::function<Answer(Answer)>& change) {
  Method m = method("sf-rational");
  m.name = name;
  m.ray = [](const Ray&, const Triangle&) { return refusal(Status::unsupported); };
  m.contract.probes.rays = false;
  m.polygon = nullptr;
  m.contract.polygons = Polygons::none;
  m.segment = [change](const Segment& s, const Triangle& t) { return change(reference_method().segment(s, t)); };
  return m;
}

struct OneWay {
  Outcome outcome;
  Method method;
};

std::vector<OneWay> wrong_in_one_way() {
  return {
      {Outcome::false_hit, changed("hits", [](Answer a) { return a.hit ? a : hit_at(Contact::interior); })},
      {Outcome::false_miss, changed("misses", [](Answer a) { return a.contact == Contact::edge ? miss() : a; })},
      {Outcome::wrong_contact, changed("tells", [](Answer a) { return a.hit ? hit_at(Contact::interior) : a; })},
      {Outcome::fault, changed("faults", [](Answer a) { return a.hit ? refusal(Status::gave_no_answer) : a; })},
      {Outcome::refused, changed("declines", [](Answer a) { return a.hit ? refusal(Status::unsupported) : a; })},
  };
}

Count total_of(const FuzzReport& report, std::size_t method) {
  Count total;
  report.counts.for_each([&](const Cell& c, const Count& count) {
    if (c.method == method) total += count;
  });
  return total;
}

FuzzPlan plan_of(std::vector<Method> methods, const std::string& family, std::uint64_t cases) {
  const Family* const f = find_family(family);
  return {.methods = std::move(methods),
          .streams = {{f, Format::binary64}, {f, Format::binary32}},
          .seed = 5,
          .cases = cases,
          .threads = 2};
}

TEST(Outcomes, EachWayOfBeingWrongIsCountedAsThatAndNothingElse) {
  for (const OneWay& row : wrong_in_one_way()) {
    const FuzzReport report = fuzz(plan_of({row.method}, "affine", 6'000));
    const Count c = total_of(report, 0);
    EXPECT_GT(c.not_owed(), 1'000U) << "rays";
    for (const Outcome o : wrong_outcomes) EXPECT_EQ(c.at(o) > 0, o == row.outcome) << row.method.name;
    EXPECT_EQ(c.refused > 0, row.outcome == Outcome::refused) << row.method.name;
    EXPECT_EQ(c.unsaid(), 0U);
    EXPECT_EQ(c.wrong, row.outcome == Outcome::refused ? 0 : c.at(row.outcome)) << "wrong is the sum";
    for (const Finding& f : report.findings) EXPECT_EQ(f.outcome, row.outcome) << row.method.name;
  }
}

/// A method owes the contact only if it claims to tell it; an answer without a contact is not a wrong contact.
TEST(Outcomes, ContactsAreOwedByThoseWhoTellThem) {
  const Truth truth = exact_truth(on_edge);
  Method m = method("sf-double");
  EXPECT_EQ(judge(m, truth, hit_at(Contact::interior)), Outcome::wrong_contact);
  EXPECT_EQ(judge(m, truth, hit_at(Contact::edge)), Outcome::right);
  EXPECT_EQ(judge(m, truth, hit_at(Contact::unsaid)), Outcome::right);
  m.tells_contact = false;
  EXPECT_EQ(judge(m, truth, hit_at(Contact::interior)), Outcome::right);
}

TEST(Causes, PublishedFailuresAreLogicAndNaiveErrorsAreRounding) {
  Method tolerant = method("mt-eps-double");
  const Query small{Segment{{2e-4, 3e-4, 1e-3}, {2e-4, 3e-4, -1e-3}}, Triangle{{0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}}};
  const Truth truth = exact_truth(small);
  const Outcome outcome = judge(tolerant, truth, tolerant.ask(small));
  EXPECT_EQ(outcome, Outcome::false_miss) << "its tolerance is absolute";
  EXPECT_EQ(cause_of(tolerant, small, truth, outcome), Cause::logic);
  tolerant.exact_twin = nullptr;
  EXPECT_EQ(cause_of(tolerant, small, truth, outcome), Cause::unknown);
  const FuzzReport report = fuzz(plan_of({method("sf-double"), method("mt-double")}, "flip", 6'000));
  for (const std::size_t m : {0U, 1U}) {
    EXPECT_GT(total_of(report, m).rounding, 20U);
    EXPECT_EQ(total_of(report, m).logic, 0U);
  }
}

/// The witnesses of docs/findings.md: the planted methods have the published faults on exact numbers, and so are their
/// own twins.
TEST(Causes, WitnessesOfPublishedFailuresAreLogic) {
  int wrong = 0;
  for (Method m : planted::published_bugs()) {
    m.exact_twin = [m](const Query& query) { return m.ask(query); };
    for (const Case& c : read_cases("data/cases/published-rivals.jsonl")) {
      const Truth truth = exact_truth(c.query);
      const Outcome outcome = judge(m, truth, m.ask(c.query));
      if (!is_wrong(outcome)) continue;
      ++wrong;
      EXPECT_EQ(outcome, Outcome::false_miss) << c.id;
      EXPECT_EQ(cause_of(m, c.query, truth, outcome), Cause::logic) << c.id;
    }
  }
  EXPECT_EQ(wrong, 4);
}

/// Walls in a coordinate plane lose plain hits: the family that nothing sound fails on finds it, and nothing ranks
/// before it.
TEST(Causes, AFaultOfLogicInPlainPositionRanksFirst) {
  std::vector<Method> bugs = planted::published_bugs();
  Method chirkov = *std::ranges::find(bugs, "planted-chirkov-root", &Method::name);
  chirkov.exact_twin = [chirkov](const Query& query) { return chirkov.ask(query); };
  FuzzPlan plan = plan_of({method("sf-double"), chirkov}, "plain", 12'000);
  plan.streams.push_back({find_family("flip"), Format::binary64});
  plan.streams.push_back({find_family("size"), Format::binary64});
  FuzzReport report = fuzz(plan);
  EXPECT_GT(total_of(report, 1).at(Severity::plain), 100U);
  EXPECT_GT(total_of(report, 1).logic, 100U);
  ask_again(plan, report);
  ASSERT_GT(report.findings.size(), 20U);
  EXPECT_TRUE(std::ranges::is_sorted(report.findings, {}, &Finding::rank));
  const Finding& first = report.findings.front();
  EXPECT_EQ(first.method, 1U);
  EXPECT_EQ(first.severity, Severity::plain);
  EXPECT_EQ(first.cause, Cause::logic);
  EXPECT_TRUE(first.naive_right);
  EXPECT_EQ(report.findings.back().severity, Severity::extreme);
  const Case c = to_counterexample(plan, first);
  EXPECT_EQ(c.finding["severity"], "plain") << "shrinking keeps it as bad as it was";
  EXPECT_EQ(c.finding["outcome"], "false miss");
  EXPECT_EQ(c.finding["cause"], "logic");
  EXPECT_EQ(c.finding["in_words"],
            "misses a hit that is due, in plain general position; logic: it is wrong without rounding too");
}

Count count_of(Outcome o, Severity s, Cause cause) {
  Count c;
  c.add(o, Stage::none);
  if (is_wrong(o)) c.add_wrong(s, cause);
  return c;
}

TEST(Headline, SaysTheWorstAndKeepsPopulationsApart) {
  const Count right = count_of(Outcome::right, {}, {});
  const Count plain = count_of(Outcome::false_hit, Severity::plain, Cause::logic);
  const Count boundary = count_of(Outcome::false_miss, Severity::boundary, Cause::rounding);
  const Count extreme = count_of(Outcome::fault, Severity::extreme, Cause::unknown);
  const Count declined = count_of(Outcome::refused, {}, {});
  EXPECT_EQ(headline({{"a", right}, {"b", right}}), "nothing wrong of 1 (a), 1 (b)");
  EXPECT_EQ(headline({{"a", declined}}), "nothing was judged");
  EXPECT_EQ(headline({{"a", extreme}, {"b", right}}), "wrong at extreme scales only: 1 of 1 (a)");
  EXPECT_EQ(headline({{"a", Count(extreme) += boundary}}), "wrong on boundaries: 1 of 2 (a); in all 2 of 2 (a)");
  EXPECT_EQ(headline({{"a", boundary}, {"b", right}}), "wrong on boundaries only: 1 of 1 (a)");
  EXPECT_EQ(headline({{"a", Count(boundary) += plain}, {"b", plain}}),
            "wrong in plain general position: 1 of 2 (a), 1 of 1 (b); in all 2 of 2 (a), 1 of 1 (b)");
  EXPECT_EQ(breakdown((Count(plain) += boundary) += declined),
            "1 false hit, 1 false miss; 1 plain, 1 boundary; 1 logic, 1 rounding; 1 refused");
}

TEST(Counts, OfOlderLogsSayWhatTheySay) {
  const Json of_old = Json::parse("[10,3,1]");
  const Count old = to_count({of_old, {"old"}});
  EXPECT_EQ(old.wrong, 3U);
  EXPECT_EQ(old.unsaid(), 3U);
  EXPECT_EQ(breakdown(old), "3 of a kind not said");
  EXPECT_EQ(headline({{"a", old}}), "wrong: 3 of 9 (a); in what position is not said");
  EXPECT_EQ(to_array(old), Json::parse("[10,3,1]"));
}

TEST(Counts, RecordsGoThereAndBack) {
  Count c;
  for (const Outcome o : {Outcome::right, Outcome::false_hit, Outcome::false_miss, Outcome::wrong_contact,
                          Outcome::fault, Outcome::refused, Outcome::not_owed}) {
    c += count_of(o, Severity::boundary, o == Outcome::false_hit ? Cause::logic : Cause::unknown);
  }
  const Json array = to_array(c);
  EXPECT_EQ(to_count({array, {"test"}}), c);
  Json too_many = to_array(c);
  too_many[11] = 1;  // more severities than wrong answers
  EXPECT_THROW(to_count({too_many, {"test"}}), Failure);
  Json other = to_array(c);
  other[7] = 2;  // more outcomes
  EXPECT_THROW(to_count({other, {"test"}}), Failure);
}

/// A wrong contact refutes like any wrong answer, is confirmed by the oracles, and is not taken for a wrong hit.
TEST_F(CertificateTest, AWrongContactIsConfirmedAsSuch) {
  Method m =
      changed("tells-wrongly", [](Answer a) { return a.contact == Contact::vertex ? hit_at(Contact::edge) : a; });
  const Certificate c = write({.method = m, .budget = tiny, .threads = 2});
  EXPECT_EQ(c.verdict, Verdict::refuted);
  ASSERT_GT(c.counterexamples, 0U);
  for (const Json& line : counterexamples()) {
    EXPECT_EQ(line["finding"]["outcome"], "wrong contact");
    EXPECT_EQ(line["finding"]["answered"], line["finding"]["expected"]);
  }
  const Verification v = verify(directory_);
  EXPECT_EQ(v.confirmed, c.counterexamples);
  forge([](std::vector<Json>& records) {
    for (Json& r : records) {
      if (r["record"] == "counterexample") r["case"]["finding"]["contact_told"] = r["case"]["finding"]["contact"];
    }
  });
  EXPECT_EQ(verify(directory_).confirmed, 0U);
}

TEST_F(CertificateTest, SaysTheWorstFirst) {
  const Certificate c = write({.method = method("sf-double"), .budget = tiny, .threads = 2});
  EXPECT_TRUE(to_summary(c).starts_with("sf-double: refuted; wrong on boundaries: ")) << to_summary(c);
  EXPECT_TRUE(to_markdown(c).starts_with("# sf-double: refuted; wrong on boundaries: "));
  std::vector<Rank> ranks;
  for (const Json& line : counterexamples()) ranks.push_back(rank_of(to_case(line, {"test"})));
  EXPECT_TRUE(std::ranges::is_sorted(ranks));
  forge([](std::vector<Json>& records) {
    for (Json& r : records) {
      if (r["record"] == "counterexample") r["case"]["finding"]["severity"] = "plain";
    }
  });
  EXPECT_EQ(verify(directory_).confirmed, 0U) << "how bad a case is follows from its numbers";
}

/// The log as version 1 had it: counts of six numbers at most, findings that say no more than the answer.
void make_old(std::vector<Json>& records) {
  const auto shorten = [](Json& count) {
    while (count.size() > 6) count.erase(count.size() - 1);
    while (count.size() > 1 && count.back() == 0) count.erase(count.size() - 1);
  };
  for (Json& r : records) {
    r.erase("version");
    if (r.contains("count")) shorten(r["count"]);
    if (r["record"] == "sample") {
      for (auto& item : r["counts"].items()) shorten(item.value());
    }
    if (r["record"] != "counterexample") continue;
    for (const char* key : {"outcome", "severity", "cause", "naive_right", "in_words"}) r["case"]["finding"].erase(key);
  }
}

/// Rays of the smallest set are right, so that the record of this set is the same in both versions.
TEST_F(CertificateTest, OlderLogsLoadAndVerify) {
  write({.method = method("mt-double"), .budget = tiny, .threads = 2});
  forge(make_old);
  const Verification v = verify(directory_);
  for (const std::string& fault : v.faults) ADD_FAILURE() << fault;
  EXPECT_EQ(v.confirmed, v.certificate.counterexamples);
  EXPECT_FALSE(v.certificate.says_outcomes());
  EXPECT_NE(to_summary(v.certificate).find("in what position is not said"), std::string::npos);
  EXPECT_EQ(to_markdown(v.certificate).find("not said"), std::string::npos) << "the words of its time";
}

}  // namespace
}  // namespace tribunal
