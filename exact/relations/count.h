// How often relations between answers were broken, whatever the operands.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "exact/harness/fuzz.h"
#include "exact/harness/parallel.h"
#include "exact/harness/progress.h"

namespace tribunal {

/// How often a method broke a relation, and the first case that shows it.
template <class Q>
struct BasicRelationCount {
  std::size_t method = 0, relation = 0;
  std::uint64_t asked = 0, broken = 0;
  std::vector<Q> witness{};                 ///< the queries of the first instance that broke it
  std::uint64_t first = ~std::uint64_t{0};  ///< the number of its case

  /// One instance, of case g.
  void add(bool holds, std::uint64_t g, const std::vector<Q>& queries) {
    ++asked;
    if (holds) return;
    ++broken;
    keep(g, queries);
  }

  BasicRelationCount& operator+=(const BasicRelationCount& other) {
    asked += other.asked;
    broken += other.broken;
    if (other.broken > 0) keep(other.first, other.witness);
    return *this;
  }

 private:
  void keep(std::uint64_t g, const std::vector<Q>& queries) {
    if (g >= first) return;
    first = g;
    witness = queries;
  }
};

/// Calls `run_case(g, counts)` for every case g of the plan, with one entry of counts for each method × relation.
/// Deterministic for any number of threads.
template <class On, class RunCase>
std::vector<BasicRelationCount<typename On::Query>> count_relations(const BasicFuzzPlan<On>& plan,
                                                                    std::size_t relations, const RunCase& run_case) {
  constexpr std::uint64_t block_size = On::block_size / 4;
  using Counts = std::vector<BasicRelationCount<typename On::Query>>;
  Counts empty;
  for (std::size_t m = 0; m < plan.methods.size(); ++m) {
    for (std::size_t r = 0; r < relations; ++r) empty.push_back({.method = m, .relation = r});
  }
  std::vector<Counts> workers(plan.threads, empty);
  Progress progress("relations", "cases", plan.cases);
  run_blocks((plan.cases + block_size - 1) / block_size, plan.threads, [&](std::size_t block, unsigned w) {
    const std::uint64_t end = std::min(plan.cases, (block + 1) * block_size);
    for (std::uint64_t g = block * block_size; g < end; ++g) run_case(g, workers[w]);
    progress.add(end - block * block_size);
  });
  for (const Counts& worker : workers) {
    for (std::size_t i = 0; i < empty.size(); ++i) empty[i] += worker[i];
  }
  return empty;
}

}  // namespace tribunal
