// Certificates: what they say, that they follow from their log, and that a changed log is noticed.
#include "exact/certificate/certificate.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "exact/certificate/certify.h"
#include "exact/certificate/small_scope.h"
#include "exact/certificate/verify.h"
#include "exact/io/failure.h"
#include "exact/io/files.h"
#include "exact/methods.h"

namespace tribunal {
namespace {

Method method(const char* name) { return *find_method(name); }

/// Few cases a class: what is tested is the certificate.
const Budget tiny{"tiny", 16, false};

class CertificateTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    directory_ = (std::filesystem::temp_directory_path() / (std::string("tribunal-") + test->name())).string();
    make_directory(directory_);
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  Certificate write(const CertifyPlan& plan) {
    ChainedLog log = certify(plan);
    return write_certificate(directory_, log);
  }

  std::string file(const char* name) const { return directory_ + "/" + name; }

  /// The log with the records changed and the chain made again, as a forger would.
  void forge(const std::function<void(std::vector<Json>&)>& change) {
    std::vector<Json> records = read_log(file("log.jsonl")).records;
    change(records);
    ChainedLog log;
    for (const Json& r : records) log.add(r);
    write_certificate(directory_, log);
  }

  std::string directory_;
};

TEST_F(CertificateTest, RefutesDoubleAndSaysWhy) {
  const Certificate c = write({.method = method("sf-double"), .budget = tiny, .threads = 2});
  EXPECT_EQ(c.verdict, Verdict::refuted);
  ASSERT_EQ(c.proved.size(), 2U);
  EXPECT_EQ(c.proved[0].size, 93'888U);
  EXPECT_EQ(c.proved[0].count.wrong, 0U);
  EXPECT_EQ(c.proved[1].size, 14'348'907U);
  EXPECT_EQ(c.proved[1].count.asked, 14'348'907U);
  EXPECT_EQ(c.proved[1].classes, 114U);
  EXPECT_EQ(c.coverage.classes(Format::binary32), 163);
  EXPECT_EQ(c.coverage.classes(Format::binary64), 163);
  EXPECT_GT(c.counterexamples.size(), 50U);
  const Json json = to_json(c);
  for (const Json& row : json["sampled"]) {
    ASSERT_LE(row["k"].get<double>() / row["n"].get<double>(), row["upper_95"].get<double>());
    ASSERT_LE(row["upper_95"].get<double>(), row["upper_95_simultaneous"].get<double>());
  }
  for (const Gap& gap : c.gaps) EXPECT_TRUE(gap.explained) << gap.what;
  EXPECT_TRUE(verify(directory_).faults.empty());
  EXPECT_EQ(verify(directory_).confirmed, c.counterexamples.size());
}

TEST_F(CertificateTest, ACaseOfTheUsersOwnRefutesToo) {
  Case own;
  own.id = "mine";
  own.query = {Segment{{0.5, 0.25, 0}, {0.5, 0.25, 1}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  Method lazy = method("sf-rational");
  lazy.name = "lazy";
  lazy.segment = [](const Segment& s, const Triangle& t) {
    return s.q == Point3(0.5, 0.25, 1) ? miss() : find_method("sf-epick")->segment(s, t);
  };
  const Certificate c =
      write({.method = lazy, .budget = tiny, .threads = 2, .cases = {own}, .truths = {exact_truth(own.query)}});
  EXPECT_EQ(c.sampled().wrong, 1U);
  EXPECT_EQ(c.verdict, Verdict::refuted);
  EXPECT_FALSE(verify(directory_).asked_again) << "an unknown method";
}

/// Every digit of every record's counts, changed alone, breaks the chain.
TEST_F(CertificateTest, ANumberEditedInTheLogIsNoticed) {
  write({.method = method("sf-float"), .budget = {"tiny", 1, false}, .threads = 2});
  const std::string log = read_file(file("log.jsonl"));
  int edited = 0;
  for (std::size_t i = 0; i < log.size(); i += 997) {
    const std::size_t digit = log.find_first_of("0123456789", i);
    if (digit == std::string::npos) break;
    std::string changed = log;
    changed[digit] = changed[digit] == '9' ? '8' : static_cast<char>(changed[digit] + 1);
    write_file(file("log.jsonl"), changed);
    EXPECT_THROW(read_log(file("log.jsonl")), Failure) << "at byte " << digit;
    ++edited;
  }
  EXPECT_GT(edited, 50);
}

TEST_F(CertificateTest, ALogCutShortIsNoticed) {
  write({.method = method("sf-float"), .budget = {"tiny", 1, false}, .threads = 2});
  const std::string log = read_file(file("log.jsonl"));
  write_file(file("log.jsonl"), log.substr(0, log.rfind('\n', log.size() - 2) + 1));
  EXPECT_THROW(read_log(file("log.jsonl")), Failure);
}

TEST_F(CertificateTest, ANumberEditedInTheCertificateIsNoticed) {
  write({.method = method("sf-float"), .budget = {"tiny", 1, false}, .threads = 2});
  for (const char* name : {"certificate.json", "certificate.md", "counterexamples.jsonl"}) {
    const std::string text = read_file(file(name));
    std::string changed = text;
    changed[changed.find_first_of("12345678")] = '9';
    write_file(file(name), changed);
    EXPECT_EQ(verify(directory_).faults.size(), 1U) << name;
    write_file(file(name), text);
  }
  EXPECT_TRUE(verify(directory_).faults.empty());
}

/// Planted: a certificate that drops a failing stratum, chain and all made again. The cases no longer add up.
TEST_F(CertificateTest, ADroppedStratumMakesAHole) {
  write({.method = method("sf-rational"), .budget = {"tiny", 1, false}, .threads = 2});
  forge([](std::vector<Json>& records) {
    for (Json& r : records) {
      if (r["record"] == "sample" && r["method"] == "sf-rational" && r["counts"].contains("C017")) {
        r["counts"].erase("C017");
        return;
      }
    }
  });
  const Certificate c = verify(directory_).certificate;
  EXPECT_EQ(c.verdict, Verdict::incomplete);
}

/// Planted: a merge of threads that loses counts.
TEST_F(CertificateTest, LostCountsMakeAHole) {
  write({.method = method("sf-rational"), .budget = {"tiny", 1, false}, .threads = 2});
  EXPECT_EQ(verify(directory_).certificate.verdict, Verdict::not_refuted);
  forge([](std::vector<Json>& records) {
    for (Json& r : records) {
      if (r["record"] != "sample" || r["method"] != "sf-rational") continue;
      for (auto& item : r["counts"].items()) {
        if (item.value()[0] > 1) {
          item.value()[0] = item.value()[0].get<std::uint64_t>() - 1;
          return;
        }
      }
    }
  });
  EXPECT_EQ(verify(directory_).certificate.verdict, Verdict::incomplete);
}

/// A method that answers nothing has no certificate.
TEST_F(CertificateTest, NoAnswersAreAHole) {
  const Certificate c = write({.method = method("haines-double"), .budget = {"tiny", 1, false}, .threads = 2});
  EXPECT_EQ(c.sampled().judged(), 0U);
  EXPECT_EQ(c.verdict, Verdict::incomplete);
}

TEST(SmallScope, LinesAndTheLatticeHaveEveryClass) {
  const ScopeResult lines = line_run(method("sf-rational"));
  EXPECT_EQ(lines.count.asked, 40'625U);
  EXPECT_EQ(lines.count.wrong, 0U);
  EXPECT_TRUE(lines.complete);
  const ScopeResult lattice = lattice_run(method("sf-double"), 2, 2);
  EXPECT_EQ(lattice.count.asked, 32'768U);
  EXPECT_EQ(lattice.answers_hash, lattice_run(method("sf-rational"), 2, 1).answers_hash);
}

}  // namespace
}  // namespace tribunal
