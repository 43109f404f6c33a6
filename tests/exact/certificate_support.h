// What tests of certificates share: a folder of their own, certificates of few cases, and logs that are forged.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/output.h"
#include "exact/certificate/certificate.h"
#include "exact/certificate/certify.h"
#include "exact/methods/methods.h"

namespace tribunal::testing_certificates {

inline Method method(const char* name) { return *find_method(name); }

/// A budget with few cases per class, since these tests are about the certificate.
inline const Budget tiny{"tiny", 16, false};

class CertificateTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    directory_ = (std::filesystem::temp_directory_path() /
                  ("tribunal-" + std::string(test->name()) + "-" + std::to_string(getpid())))
                     .string();
    make_directory(directory_);
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  Certificate write(const CertifyPlan& plan) {
    ChainedLog log = certify(plan);
    return write_certificate(directory_, log);
  }

  Certificate write_polygons(const char* name, std::uint64_t rounds) {
    return write(
        {.method = method(name), .operands = Operands::polygons, .budget = {"tiny", 0, false, rounds}, .threads = 2});
  }

  /// What counterexamples.jsonl holds.
  std::vector<Json> counterexamples() const {
    std::vector<Json> lines;
    for_each_line(file("counterexamples.jsonl"), [&](const Json& line, const Where&) { lines.push_back(line); });
    return lines;
  }

  std::string file(const char* name) const { return directory_ + "/" + name; }

  /// Changes the records of the log and computes its hash chain anew, as a forger would.
  void forge(const std::function<void(std::vector<Json>&)>& change) {
    std::vector<Json> records = read_log(file("log.jsonl")).records;
    change(records);
    ChainedLog log;
    for (const Json& r : records) log.add(r);
    write_certificate(directory_, log);
  }

  /// Changes one digit of the log at a time, `step` bytes apart, and expects that each change breaks the hash chain.
  void expect_edits_noticed(std::size_t step) {
    const std::string log = read_file(file("log.jsonl"));
    int edited = 0;
    for (std::size_t i = 0; i < log.size(); i += step) {
      const std::size_t digit = log.find_first_of("0123456789", i);
      if (digit == std::string::npos) break;
      std::string changed = log;
      changed[digit] = changed[digit] == '9' ? '8' : static_cast<char>(changed[digit] + 1);
      write_file(file("log.jsonl"), changed);
      EXPECT_THROW(read_log(file("log.jsonl")), Failure) << "at byte " << digit;
      ++edited;
    }
    EXPECT_GT(edited, 50);
    write_file(file("log.jsonl"), log);
  }

  std::string directory_;
};

}  // namespace tribunal::testing_certificates
