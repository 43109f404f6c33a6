// Time per pair of sf-filtered, single and batched, and of its peers. `./run bench predicate` builds and runs it. All
// benchmarks run in random order, nine times each in each of three processes, so that a change of the machine's speed
// meets all of them. CPU time, since others may use the machine. The last lines are `ratio NAME VALUE`, of medians.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "core/kernel.h"
#include "core/rivals/adapter.h"
#include "core/rivals/moeller_trumbore.h"
#include "core/segura_feito.h"
#include "exact/filtered/batch.h"
#include "exact/filtered/filtered.h"
#include "exact/filtered/filtered_kernel.h"
#include "exact/kernels/expansion_kernel.h"
#include "exact/kernels/rational_kernel.h"
#include "exact/methods/cgal_kernels.h"
#include "exact/methods/methods.h"
#include "tests/bench/medians.h"
#include "tests/bench/predicate/pairs.h"
#include "tests/bench/predicate/peers.h"

namespace tribunal::bench {
namespace {

// Pairs; multiples of 8, but no powers of two: fifteen columns a multiple of 4 KB apart fight for the same cache lines.
constexpr std::size_t in_second_level_cache = 4000;  ///< 480 KB
constexpr std::size_t in_first_level_cache = 248;    ///< 30 KB
constexpr std::size_t in_memory = 1'000'000;         ///< 120 MB

std::string named(const std::string& method, const std::string& population) { return population + "/" + method; }

/// One test a pair; `meets` is inlined into the loop where it can be. The pairs come in another order each time: in
/// one order, a branch predictor learns the answers of some thousand pairs by heart, and tests that branch look three
/// times as fast as on pairs that are new.
template <class Meets>
void time_single(const std::string& method, const std::string& population, const PairTable& table, Meets meets) {
  benchmark::RegisterBenchmark(named(method, population).c_str(), [&table, meets](benchmark::State& state) {
    std::size_t step = 0;
    for (auto _ : state) {
      std::size_t count = 0;
      step = next_step(step, table.size());
      visit_by_steps(table.size(), step, [&](std::size_t i) {
        const Pair& p = table.pairs()[i];
        count += meets(p.segment, p.triangle);
      });
      benchmark::DoNotOptimize(count);
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * table.size()));
  });
}

/// All pairs in one call.
void time_batch(const std::string& method, const std::string& population, const PairTable& table,
                const std::string& target, const std::function<void(std::uint8_t*)>& test) {
  benchmark::RegisterBenchmark(named(method, population).c_str(), [&table, target, test](benchmark::State& state) {
    force_batch_target(target);
    std::vector<std::uint8_t> hit(table.size());
    for (auto _ : state) {
      test(hit.data());
      benchmark::DoNotOptimize(hit.data());
      benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * table.size()));
  });
}

void time_our_single(const std::string& population, const PairTable& table) {
  time_single("single", population, table, [](const Segment& s, const Triangle& t) { return hits(s, t); });
}

void time_scalar_mt(const std::string& population, const PairTable& table) {
  time_single("scalar_mt", population, table, [](const Segment& s, const Triangle& t) {
    return published::meet<published::MoellerTrumbore<double>>(s, t).has_value();
  });
}

bool runs_here(const VectorPeer& peer) {
  const auto here = batch_targets();
  return std::find(here.begin(), here.end(), peer.name) != here.end();
}

/// Times our batch and the uncertified peer on each instruction set of this machine; the widest comes first and has
/// the plain name.
void time_batches(const std::string& population, const PairTable& table, bool one_against_many = false) {
  std::string suffix;
  for (const VectorPeer* peer : {&moeller_trumbore_avx512, &moeller_trumbore_avx2, &moeller_trumbore_portable}) {
    if (!runs_here(*peer)) continue;
    const VectorTest test = one_against_many ? peer->one : peer->pairs;
    time_batch("simd_mt" + suffix, population, table, peer->name,
               [&table, test](std::uint8_t* hit) { test(table.columns().data(), table.size(), hit); });
    time_batch("batch" + suffix, population, table, peer->name, [&table, one_against_many](std::uint8_t* hit) {
      const std::span<std::uint8_t> out(hit, table.size());
      if (one_against_many) {
        hits(table.pairs()[0].segment, table.triangles(), out);
      } else {
        hits(table.segments(), table.triangles(), out);
      }
    });
    suffix = peer == &moeller_trumbore_avx512 ? "_avx2" : "_portable";
  }
}

/// The same of rays.
void time_rays(const std::string& population, const PairTable& table) {
  const auto time_one = [&](const std::string& method, auto meets) {
    benchmark::RegisterBenchmark(named(method, population).c_str(), [&table, meets](benchmark::State& state) {
      std::size_t step = 0;
      for (auto _ : state) {
        std::size_t count = 0;
        step = next_step(step, table.size());
        visit_by_steps(table.size(), step, [&](std::size_t i) {
          const Pair& p = table.pairs()[i];
          count += meets(ray_of(p), p.triangle);
        });
        benchmark::DoNotOptimize(count);
      }
      state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * table.size()));
    });
  };
  time_one("scalar_mt", [](const Ray& r, const Triangle& t) {
    return published::meet<published::MoellerTrumbore<double>>(r, t).has_value();
  });
  time_one("single", [](const Ray& r, const Triangle& t) { return hits(r, t); });
  std::string suffix;
  for (const VectorPeer* peer : {&moeller_trumbore_avx512, &moeller_trumbore_avx2, &moeller_trumbore_portable}) {
    if (!runs_here(*peer)) continue;
    time_batch("simd_mt" + suffix, population, table, peer->name,
               [&table, test = peer->rays](std::uint8_t* hit) { test(table.columns().data(), table.size(), hit); });
    time_batch("batch" + suffix, population, table, peer->name, [&table](std::uint8_t* hit) {
      hits(table.rays(), table.triangles(), {hit, table.size()});
    });
    suffix = peer == &moeller_trumbore_avx512 ? "_avx2" : "_portable";
  }
}

template <Kernel K>
void time_kernel(const std::string& method, const std::string& population, const PairTable& table, const K& k) {
  time_single(method, population, table,
              [k](const Segment& s, const Triangle& t) { return segura_feito(s, t, k).hit; });
}

/// The five exact arithmetics under one source, `segura_feito`.
void time_exact_kernels(const std::string& population, const PairTable& table) {
  time_kernel("sf_filtered", population, table, FilteredKernel{});
  time_kernel("sf_epick", population, table, EpickKernel{});
  time_kernel("sf_epeck", population, table, EpeckKernel{});
  time_kernel("sf_expansion", population, table, ExpansionKernel{});
  time_kernel("sf_rational", population, table, RationalKernel{});
}

void time_exact_peers(const std::string& population, const PairTable& table) {
  time_single("epick", population, table, epick);
  time_single("epeck", population, table, epeck);
  time_exact_kernels(population, table);
}

/// Stores a table that lives as long as the benchmarks do.
const PairTable& kept(std::vector<Pair> pairs) {
  static std::deque<PairTable> tables;
  return tables.emplace_back(std::move(pairs));
}

void register_all() {
  for (const int percent : {7, 0, 50, 100}) {
    const std::string population = "hits_" + std::to_string(percent);
    const PairTable& table = kept(random_pairs(in_second_level_cache, percent));
    time_scalar_mt(population, table);
    time_our_single(population, table);
    time_batches(population, table);
    time_single("epick", population, table, epick);
    if (percent != 7) continue;
    time_single("epeck", population, table, epeck);
    time_single(
        "epick_checked", population, table,
        [test = find_method("cgal-epick")->segment](const Segment& s, const Triangle& t) { return test(s, t).hit; });
    time_kernel("sf_double", population, table, FormulaKernel<double>{});
    time_exact_kernels(population, table);
  }
  time_rays("rays_7", kept(random_rays(in_second_level_cache, 7)));
  time_batches("one_against_many", kept(one_segment_pairs(in_second_level_cache)), true);
  time_batches("first_level_cache", kept(random_pairs(in_first_level_cache, 7)));
  time_batches("memory", kept(random_pairs(in_memory, 7)));

  for (const auto& [population, pairs] : {std::pair{"degenerate", degenerate_pairs(in_second_level_cache, 50)},
                                          std::pair{"near_degenerate", near_pairs(in_second_level_cache)}}) {
    const PairTable& table = kept(pairs);
    time_our_single(population, table);
    time_scalar_mt(population, table);
    time_batch("batch", population, table, "", [&table](std::uint8_t* hit) {
      hits(table.segments(), table.triangles(), {hit, table.size()});
    });
    time_exact_peers(population, table);
  }
  for (const int bits : {8, 16, 20, 30, 40, 50}) {
    const PairTable& table = kept(degenerate_pairs(in_second_level_cache, bits));
    time_our_single("mantissa_fill_" + std::to_string(bits), table);
    time_single("epick", "mantissa_fill_" + std::to_string(bits), table, epick);
  }
  for (const int percent : {1, 10, 30, 100}) {
    const PairTable& table = kept(mixed_pairs(in_second_level_cache, percent));
    time_our_single("share_degenerate_" + std::to_string(percent), table);
    time_single("epick", "share_degenerate_" + std::to_string(percent), table, epick);
  }
}

void print_ratios(const Medians& m) {
  for (const char* target : {"", "_avx2", "_portable"}) {
    const std::string batch = std::string("hits_7/batch") + target;
    m.print_ratio(std::string("epick_over_batch") + target, "hits_7/epick", batch);
    m.print_ratio(std::string("batch_over_simd_mt") + target, batch, std::string("hits_7/simd_mt") + target);
  }
  m.print_ratio("single_over_scalar_mt", "hits_7/single", "hits_7/scalar_mt");
  m.print_ratio("epick_checked_over_batch", "hits_7/epick_checked", "hits_7/batch");
  m.print_ratio("epick_over_single", "hits_7/epick", "hits_7/single");
  m.print_ratio("epeck_over_single", "hits_7/epeck", "hits_7/single");
  m.print_ratio("expansion_over_single", "hits_7/sf_expansion", "hits_7/single");
  m.print_ratio("rational_over_single", "hits_7/sf_rational", "hits_7/single");
  m.print_ratio("sf_double_over_single", "hits_7/sf_double", "hits_7/single");
  for (const char* percent : {"0", "50", "100"}) {
    const std::string at = std::string("hits_") + percent + "/";
    m.print_ratio(std::string("batch_over_simd_mt_hits_") + percent, at + "batch", at + "simd_mt");
    m.print_ratio(std::string("single_over_scalar_mt_hits_") + percent, at + "single", at + "scalar_mt");
    m.print_ratio(std::string("epick_over_batch_hits_") + percent, at + "epick", at + "batch");
  }
  m.print_ratio("single_over_scalar_mt_rays", "rays_7/single", "rays_7/scalar_mt");
  for (const char* target : {"", "_avx2", "_portable"}) {
    const std::string batch = std::string("rays_7/batch") + target;
    m.print_ratio(std::string("batch_over_simd_mt_rays") + target, batch, std::string("rays_7/simd_mt") + target);
  }
  for (const char* where : {"one_against_many", "first_level_cache", "memory"}) {
    const std::string at = std::string(where) + "/";
    m.print_ratio(std::string("batch_over_simd_mt_") + where, at + "batch", at + "simd_mt");
  }
  for (const char* population : {"degenerate", "near_degenerate"}) {
    const std::string at = std::string(population) + "/";
    m.print_ratio(std::string("epick_over_single_") + population, at + "epick", at + "single");
    m.print_ratio(std::string("epick_over_batch_") + population, at + "epick", at + "batch");
    m.print_ratio(std::string("rational_over_single_") + population, at + "sf_rational", at + "single");
  }
}

/// How many random pairs go past the filter: a count, not a time.
void print_share_past_the_filter() {
  constexpr std::size_t n = 1U << 20, rounds = 16;
  Tally tally;
  std::vector<std::uint8_t> hit(n);
  for (std::uint64_t round = 0; round < rounds; ++round) {
    std::vector<Pair> pairs;
    for (std::uint64_t k = 0; k < n; ++k) pairs.push_back(random_pair((round + 1) << 32 | k));
    const PairTable table(std::move(pairs));
    tally += hits(table.segments(), table.triangles(), hit);
  }
  std::printf("past the filter: %llu of %zu random pairs\n",
              static_cast<unsigned long long>(tally[Stage::integers] + tally[Stage::exact]), n * rounds);
}

}  // namespace
}  // namespace tribunal::bench

int main(int argc, char** argv) {
  using namespace tribunal::bench;
  register_all();
  return run_benchmarks(argc, argv, {.repetitions = 9}, "ns a pair", [](const Medians& medians) {
    print_share_past_the_filter();
    print_ratios(medians);
  });
}
