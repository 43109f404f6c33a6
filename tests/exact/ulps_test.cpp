// Errors of t and of the weights in units in the last place: the definition, planted methods, merging, judging.
#include "exact/trial/ulps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact/base/output.h"
#include "exact/cases/family_table.h"
#include "exact/certificate/judge_files.h"
#include "exact/certificate/verify.h"
#include "exact/methods/methods.h"
#include "exact/record/checkpoint.h"
#include "exact/record/errors_json.h"
#include "exact/trial/exact_hit.h"
#include "tests/exact/certificate_support.h"
#include "tests/exact/exact_parameter.h"

namespace tribunal {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Ulps one(double computed, double num, double den = 1, Format format = Format::binary64) {
  Ulps u;
  u.add(computed, {Dyadic(num), Dyadic(den)}, format, 7);
  return u;
}

TEST(Ulps, TheUnitIsThatOfTheExactValue) {
  EXPECT_EQ(one(1, 1), (Ulps{.equal = 1, .most_at = 7}));
  EXPECT_EQ(one(std::nextafter(1, 2), 1).most, 1) << "the neighbour above 1";
  EXPECT_EQ(one(std::nextafter(1, 0), 1).most, 0.5) << "the neighbour below 1 is half a unit of 1 away";
  EXPECT_EQ(one(1, std::nextafter(1, 0)).most, 1) << "and 1 a whole unit of that";
  EXPECT_EQ(one(-std::nextafter(1, 2), -1).most, 1);
  EXPECT_EQ(one(1 + 0x1p-23, 1, 1, Format::binary32).most, 1);
  EXPECT_EQ(one(1 + 0x1p-23, 1).most, 0x1p29);
  const Ulps third = one(1.0 / 3, 1, 3);
  EXPECT_NEAR(third.most, 1.0 / 3, 1e-15) << "1/3 rounds by a third of a unit";
  EXPECT_EQ(third.up_to[0], 1U);
  EXPECT_EQ(one(-1.0 / 3, 1, 3).bound_of(50), 0x1p54) << "of another sign: twice the value";
}

TEST(Ulps, BinsEndAtPowersOfTwo) {
  for (const auto& [ulps, bin] : {std::pair(1, 1), {2, 2}, {3, 3}, {4, 3}, {5, 4}, {8, 4}}) {
    const Ulps u = one(1 + ulps * 0x1p-52, 1);
    EXPECT_EQ(u.up_to[static_cast<std::size_t>(bin)], 1U) << ulps;
    EXPECT_EQ(u.bound_of(99), std::ldexp(0.5, bin));
  }
  EXPECT_EQ(one(1e300, 1e-300).up_to.back(), 1U);
  EXPECT_EQ(one(1e300, 1e-300).bound_of(50), infinity);
  EXPECT_EQ(one(1 + 5 * 0x1p-52, 1).bound_of(99), 8);
  EXPECT_NE(in_words(one(1 + 5 * 0x1p-52, 1)).find("99 % within 5, at most 5 ulps"), std::string::npos);
  EXPECT_TRUE(std::isfinite(one(1e300, 1e-300).most));
}

TEST(Ulps, SubnormalsShareOneUnit) {
  EXPECT_EQ(one(0, 0x1p-1074).most, 1);
  EXPECT_EQ(one(0x1p-1074, 0x1p-1074, 4).most, 0.75) << "a quarter of the least number, given as one";
  EXPECT_EQ(one(0x1p-1022 + 0x1p-1074, 0x1p-1022).most, 1);
  EXPECT_EQ(one(0, 0x1p-149, 1, Format::binary32).most, 1);
  EXPECT_EQ(one(0x1p-140 + 0x1p-149, 0x1p-140, 1, Format::binary32).most, 1);
}

TEST(Ulps, ZeroAndWhatIsBeyondHaveNoUnit) {
  EXPECT_EQ(one(0, 0), (Ulps{.zeros = 1}));
  EXPECT_EQ(one(-0.0, 0), (Ulps{.zeros = 1}));
  EXPECT_EQ(one(1e-300, 0), (Ulps{.zeros = 1, .zeros_missed = 1}));
  EXPECT_EQ(one(std::nan(""), 0), (Ulps{.zeros = 1, .zeros_missed = 1}));
  EXPECT_EQ(one(infinity, 0x1p1023, 0.25), (Ulps{.beyond = 1}));
  EXPECT_EQ(one(infinity, 1), (Ulps{.not_finite = 1}));
  EXPECT_EQ(one(std::nan(""), 1), (Ulps{.not_finite = 1}));
  EXPECT_EQ(one(0x1p127, 0x1p128, 1, Format::binary32), (Ulps{.beyond = 1}));
}

TEST(Ulps, AddInAnyOrder) {
  Ulps a = one(1 + 0x1p-52, 1), b = one(1 + 0x1p-50, 1), c = one(0, 0);
  a.most_at = 5;
  Ulps same = b;
  b.most_at = 9;
  same.most_at = 3;
  Ulps left = a, right = same;
  left += b;
  left += same;
  left += c;
  right += c;
  right += b;
  right += a;
  EXPECT_EQ(left, right);
  EXPECT_EQ(left.most_at, 3U) << "the lowest case that has the maximum";
  EXPECT_EQ(left.measured(), 3U);
  EXPECT_EQ(left.all(), 4U);
}

/// Against a formula that shares no code with it, in lowest terms.
TEST(Ulps, ExactHitsAreThoseOfAnotherFormula) {
  int hits = 0;
  for (const Family& family : families_of(Operands::triangles)) {
    for (std::uint64_t k = 0; k < 60; ++k) {
      const Query query = family.make(Format::binary64, 3, k).query;
      const Ray* ray = std::get_if<Ray>(&query.probe);
      if (ray == nullptr) continue;
      const testing::ExactParameter t(*ray, query.triangle());
      if (t.parallel) continue;
      const ExactHit hit = exact_hit(*ray, query.triangle());
      const auto fraction = [](const ExactRatio& r) { return mpq_class(r.num.fraction() / r.den.fraction()); };
      ASSERT_EQ(fraction(hit.t), t.value);
      const mpq_class b = fraction(hit.b), c = fraction(hit.c), a = 1 - b - c;
      for (int i = 0; i < 3; ++i) {
        const mpq_class on_ray = mpq_class(ray->o[i]) + t.value * mpq_class(ray->d.v[i]);
        const Triangle& v = query.triangle();
        ASSERT_EQ(on_ray, a * mpq_class(v.a[i]) + b * mpq_class(v.b[i]) + c * mpq_class(v.c[i]));
      }
      ++hits;
    }
  }
  EXPECT_GT(hits, 250);
}

// --- planted ---------------------------------------------------------------------------------------------------------

double rounded(const ExactRatio& r) {
  const mpq_class x = r.num.fraction() / r.den.fraction();
  return x.get_d();  // towards zero: within one unit
}

/// A right test whose numbers are the exact ones, rounded, and then changed.
Method with_numbers(const std::function<void(HitAt&)>& change) {
  Method m = *find_method("sf-epick");
  m.name = "planted";
  m.hit = [change](const Ray& r, const Triangle& t) {
    const ExactHit exact = exact_hit(r, t);
    HitAt at{rounded(exact.t), BarycentricWeights{rounded(exact.b), rounded(exact.c)}};
    change(at);
    return std::optional<HitAt>(at);
  };
  return m;
}

FuzzPlan plan_of(const Method& method, unsigned threads = 2) {
  FuzzPlan plan{.methods = {method}, .streams = {}, .seed = 1, .cases = 40'000, .threads = threads};
  for (const Stream& s : streams_of(Operands::triangles)) {
    if (s.family->name == "plain") plan.streams.push_back(s);
  }
  return plan;
}

HitErrors errors_of(const Method& method) {
  const FuzzReport report = fuzz(plan_of(method));
  EXPECT_TRUE(report.findings.empty()) << "hit and miss are right";
  HitErrors all;
  for (const HitErrors& e : report.errors) all += e;
  return all;
}

TEST(Ulps, PlantedErrorsShow) {
  const HitErrors good = errors_of(with_numbers([](HitAt&) {}));
  ASSERT_GT(good.hits, 200U);
  EXPECT_EQ(good.withheld, 0U);
  EXPECT_LT(good.t.most, 1);
  EXPECT_LT(good.weights.most, 1);
  EXPECT_EQ(good.weights.all(), 2 * good.hits);

  const HitErrors off = errors_of(with_numbers([](HitAt& at) { at.t = std::nextafter(at.t, infinity); }));
  EXPECT_EQ(off.hits, good.hits);
  EXPECT_GT(off.t.bound_of(50), 0) << "no t is exact any more";
  EXPECT_LE(off.t.most, 2);
  EXPECT_NE(off.t, good.t);
  EXPECT_EQ(off.weights, good.weights) << "t alone is off";

  const HitErrors swapped = errors_of(with_numbers([](HitAt& at) { std::swap(at.weights->b, at.weights->c); }));
  EXPECT_EQ(swapped.t, good.t) << "the weights alone are off";
  EXPECT_GT(swapped.weights.bound_of(50), 0x1p40);

  const HitErrors bad = errors_of(with_numbers([](HitAt& at) { at.weights->b *= 1 + 0x1p-40; }));
  EXPECT_EQ(bad.t, good.t);
  EXPECT_GT(bad.weights.most, 0x1p11);
  EXPECT_LT(bad.weights.most, 0x1p14);

  Method shy = with_numbers([](HitAt&) {});
  shy.hit = [](const Ray&, const Triangle&) { return std::optional<HitAt>(); };
  EXPECT_EQ(errors_of(shy).withheld, good.hits);
}

TEST(Ulps, TheFlagshipIsWithinHalfAUnitAndBinary32IsMeasuredInItsOwn) {
  FuzzPlan plan = plan_of(*find_method("sf-filtered"));
  plan.methods.push_back(*find_method("mt-float"));
  const FuzzReport report = fuzz(plan);
  for (std::size_t s = 0; s < plan.streams.size(); ++s) {
    const HitErrors& exact = report.errors[plan.errors_at(0, s)];
    EXPECT_GT(exact.t.measured(), 50U);
    EXPECT_LE(exact.t.most, 0.5);
    const HitErrors& single = report.errors[plan.errors_at(1, s)];
    if (plan.streams[s].format == Format::binary64) {
      EXPECT_EQ(single.hits, 0U) << "not asked beyond its format";
    } else {
      EXPECT_GT(single.hits, 50U);
      EXPECT_LT(single.t.bound_of(50), 8) << "in units of binary32";
    }
  }
}

TEST(Ulps, ThreadsAndCheckpointsDoNotShow) {
  const Method method = *find_method("mt-double");
  const FuzzReport whole = fuzz(plan_of(method, 1));
  EXPECT_EQ(fuzz(plan_of(method, 5)).errors, whole.errors);

  FuzzPlan plan = plan_of(method, 2);
  const std::uint64_t all = plan.cases;
  plan.cases = 4096 * 3;
  FuzzReport part = fuzz(plan);
  plan.cases = all;
  const std::string directory = (std::filesystem::temp_directory_path() / "tribunal-ulps-checkpoint").string();
  make_directory(directory);
  save_checkpoint(directory, plan, part);
  const auto loaded = load_checkpoint(directory, plan);
  std::filesystem::remove_all(directory);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->errors, part.errors);
  EXPECT_EQ(fuzz(plan, *loaded, {}).errors, whole.errors);
}

TEST(Ulps, JsonKeepsThemAndRefusesWhatCannotBe) {
  HitErrors e;
  for (const double x : {1.0, 1 + 0x1p-52, 1 + 0x1p-44, infinity}) {
    ++e.hits;
    e.t.add(x, {Dyadic(1.0), Dyadic(1.0)}, Format::binary64, e.hits);
    e.weights.add(x, {Dyadic(), Dyadic(1.0)}, Format::binary64, e.hits);
  }
  const Json json = from_errors(e);
  EXPECT_EQ(to_errors({json, {"x"}}), e);
  Json fewer = json;
  fewer["hits"] = 2;
  EXPECT_THROW(to_errors({fewer, {"x"}}), Failure);
  Json smaller = json;
  smaller["t"]["most"] = 1.0;
  EXPECT_THROW(to_errors({smaller, {"x"}}), Failure) << "the histogram says more";
}

// --- certificates, and answers from files ----------------------------------------------------------------------------

using ErrorsInCertificates = testing_certificates::CertificateTest;

TEST_F(ErrorsInCertificates, AreLoggedVerifiedAndOwed) {
  const Certificate c = write({.method = *find_method("mt-double"), .budget = {"tiny", 2, false}, .threads = 2});
  ASSERT_EQ(c.errors.size(), c.streams.size());
  EXPECT_TRUE(to_json(c).contains("errors"));
  EXPECT_NE(to_summary(c).find("  ulps     t, binary64: "), std::string::npos);
  EXPECT_NE(to_markdown(c).find("## Errors of t and of the weights"), std::string::npos);
  EXPECT_TRUE(verify(directory_).faults.empty());
  forge([](std::vector<Json>& all) {
    std::erase_if(all, [](const Json& r) { return r["record"] == "errors" && r["family"] == "sliver"; });
  });
  EXPECT_FALSE(verify(directory_).faults.empty());
}

TEST_F(ErrorsInCertificates, OfAnswersFromAFile) {
  write_file(file("cases.jsonl"), R"({"id":"a","ray":{"o":[0.25,0.25,3],"d":[0,0,-1]},"tri":[[0,0,0],[1,0,0],[0,1,0]]})"
                                  "\n"
                                  R"({"id":"b","ray":{"o":[5,5,3],"d":[0,0,-1]},"tri":[[0,0,0],[1,0,0],[0,1,0]]})"
                                  "\n");
  const auto judged = [&](const std::string& of_a) {
    write_file(file("answers.jsonl"), "{\"id\":\"a\",\"hit\":1" + of_a + "}\n{\"id\":\"b\",\"hit\":0}\n");
    const Rereadable cases(file("cases.jsonl")), answers(file("answers.jsonl"));
    return std::move(judge_files(cases, answers, {}, 1).methods.front());
  };
  const JudgedAnswers answers = judged(R"(,"t":3.0000000000000004,"weights":[0.25,"0x1p-2"])");
  ChainedLog log;
  log_plan(log, answers.method, Operands::triangles, "the cases of a file", 0);
  log_own_cases(log, answers.method, answers.counts);
  const Certificate c = write_certificate(directory_, log);
  ASSERT_EQ(c.errors.size(), 1U);
  EXPECT_EQ(c.errors[0].errors.hits, 1U);
  EXPECT_EQ(c.errors[0].errors.t.most, 1);
  EXPECT_EQ(c.errors[0].errors.weights.equal, 2U);
  EXPECT_TRUE(verify(directory_).faults.empty());
  EXPECT_FALSE(judged("").counts.gives_numbers);
  EXPECT_EQ(judged(R"(,"t":"nan")").counts.parts[0].errors.t.not_finite, 1U);
  EXPECT_THROW(judged(R"(,"weights":[0.25,0.25])"), Failure) << "without t";
  EXPECT_THROW(judged(R"(,"t":3,"weights":[0.25])"), Failure);
}

}  // namespace
}  // namespace tribunal
