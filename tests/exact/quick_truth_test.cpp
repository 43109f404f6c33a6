// The certified class that judges most cases of `fuzz`, and the audit that judges it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "exact/base/failure.h"
#include "exact/cases/family_table.h"
#include "exact/classes/classify.h"
#include "exact/kernels/product_sum.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/methods/methods.h"
#include "exact/trial/fuzz.h"

namespace tribunal {
namespace {

FuzzPlan plan_of(const char* method, std::uint64_t cases, ClassBy quick) {
  FuzzPlan plan{.methods = {*find_method(method)}, .streams = streams_of(Operands::triangles), .cases = cases};
  plan.quick = quick;
  return plan;
}

/// The class by this kernel, which may round.
template <class K>
ClassId class_by(const Query& query) {
  return std::visit([&](const auto& probe) { return class_of(probe, query.triangle(), K{}); }, query.probe);
}

TEST(QuickTruth, IsTheClassByTheReferenceOnAllFamilies) {
  std::uint64_t cases = 0;
  for (const Stream& s : streams_of(Operands::triangles)) {
    for (std::uint64_t k = 0; k < 2500; ++k, ++cases) {
      const Query query = s.family->make(s.format, 5, k).query;
      const ClassId expected = class_by<RationalKernel>(query);
      ASSERT_EQ(certified_class(query), expected) << name_of(s) << " " << k;
      ASSERT_EQ(class_by<ProductSumKernel>(query), expected) << name_of(s) << " " << k;
    }
  }
  EXPECT_GT(cases, 90'000U);
}

/// Sums whose sign is decided by the last of many products, or by none, with carries through all words.
TEST(ProductSum, TheLeastProductDecides) {
  for (const int gap : {1, 52, 53, 54, 63, 64, 65, 105, 106, 159, 160, 168, 500, 2000}) {
    for (const double least : {1.0, -1.0, 0x1.fffffffffffffp52, -0x1.fffffffffffffp52}) {
      ProductSum sum;
      const double big = 0x1.fffffffffffffp0;
      for (int i = 0; i < 8; ++i) sum.add(big * 0x1p400, big * 0x1p300, std::ldexp(big, gap - 1000), i % 2 == 0);
      sum.add(least, 0x1p-300, 0x1p-400, false);
      for (int i = 0; i < 8; ++i) sum.add(-big * 0x1p300, big * 0x1p300, std::ldexp(big, gap - 900), i % 2 == 1);
      EXPECT_EQ(sum.sign(), sign_of(least)) << gap << " " << least;
    }
  }
  ProductSum nothing;
  EXPECT_EQ(nothing.sign(), Sign::zero);
}

/// The audit takes no regular stride: all classes, levels and kinds of probe come up, each as often as it should.
TEST(Audit, LeavesNoResidueOut) {
  for (const std::uint64_t modulus : {2U, 3U, 16U, 163U, 328U}) {
    std::vector<std::uint64_t> audited(modulus);
    for (std::uint64_t k = 0; k < 4'000'000; ++k) audited[k % modulus] += is_audited(1, 3, k) ? 1 : 0;
    const auto due = static_cast<double>(4'000'000 / audit_period / modulus);
    const auto [least, most] = std::ranges::minmax(audited);
    EXPECT_GT(static_cast<double>(least), due - 5 * std::sqrt(due)) << modulus;
    EXPECT_LT(static_cast<double>(most), due + 5 * std::sqrt(due)) << modulus;
  }
}

/// Tried with a method that culls too, for which the class alone does not decide.
TEST(Audit, IsCountedAndChangesNoFigure) {
  for (const char* method : {"sf-double", "mt-cull-double"}) {
    const FuzzReport by_oracles = fuzz(plan_of(method, 30'000, nullptr));
    const FuzzPlan plan = plan_of(method, 30'000, certified_class);
    const FuzzReport quick = fuzz(plan);
    EXPECT_TRUE(by_oracles.counts == quick.counts);
    ASSERT_EQ(by_oracles.findings.size(), quick.findings.size());
    for (std::size_t i = 0; i < quick.findings.size(); ++i) {
      EXPECT_EQ(by_oracles.findings[i].k, quick.findings[i].k);
      EXPECT_EQ(by_oracles.findings[i].truth.class_id, quick.findings[i].truth.class_id);
    }
    std::uint64_t due = 0;
    for (std::uint64_t g = 0; g < quick.cases; ++g) {
      due += is_audited(plan.seed, g % plan.streams.size(), g / plan.streams.size()) ? 1 : 0;
    }
    EXPECT_EQ(by_oracles.audited, due);
    EXPECT_EQ(quick.audited, due);
    EXPECT_GT(quick.audited, 30'000 / audit_period / 2);
  }
}

/// A faulty class: wrong only where an edge is met.
ClassId faulty_at_edges(const Query& query) {
  const ClassId id = certified_class(query);
  return id == 12 ? ClassId{13} : id;
}

/// A faulty class: wrong where products overflow or underflow, as it would be without its guard.
ClassId faulty_at_extremes(const Query& query) { return class_by<FormulaKernel<double>>(query); }

TEST(Audit, FindsAFaultInTheQuickTruth) {
  for (const ClassBy faulty : {faulty_at_edges, faulty_at_extremes}) {
    try {
      fuzz(plan_of("sf-double", 400'000, faulty));
      FAIL() << "a faulty truth has gone unnoticed";
    } catch (const Failure& f) {
      EXPECT_EQ(f.exit(), Exit::oracles_contradict);
      EXPECT_NE(std::string(f.what()).find("certified"), std::string::npos) << f.what();
    }
  }
}

TEST(Audit, WhatPromisesToBeExactIsJudgedByTheOraclesAlone) {
  for (const Method& m : all_methods()) {
    EXPECT_EQ(quick_class_for({m}, Operands::triangles) == nullptr, m.contract.exact) << m.name;
    EXPECT_EQ(quick_class_for({m, flagship_method()}, Operands::triangles), nullptr) << m.name;
    EXPECT_EQ(quick_class_for({m}, Operands::polygons), nullptr) << m.name;
  }
}

}  // namespace
}  // namespace tribunal
