// The paper's claim on triangles: is a test by signs faster than Möller–Trumbore and Badouel where there is no hit, and
// about as fast where the point is wanted? The same source is timed as compilers of today build it for any x86-64
// (sse2), for this machine (native), and for the floating-point unit that the paper's authors had (x87). Beside them
// tests whose papers claim to be faster than Möller–Trumbore. `./run bench paper` builds and runs it. The last lines
// are `ratio NAME VALUE`, of medians.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "exact/chart/pairs.h"
#include "exact/filtered/filtered.h"
#include "tests/bench/medians.h"
#include "tests/bench/paper/contenders.h"

namespace tribunal::bench {
namespace {

/// Pairs that share a percentage of hits.
struct Population {
  std::string name;
  std::size_t size;
  int percent;
};

constexpr std::size_t in_second_level_cache = 4000, in_memory = 400'000;
const Population populations[] = {{"hits_0", in_second_level_cache, 0},
                                  {"hits_7", in_second_level_cache, 7},
                                  {"hits_50", in_second_level_cache, 50},
                                  {"hits_100", in_second_level_cache, 100},
                                  {"memory", in_memory, 7}};

struct Build {
  std::string name;
  std::span<const Contender> contenders;
};

const Build builds[] = {{"sse2", contenders_sse2()}, {"native", contenders_native()}, {"x87", contenders_x87()}};

std::string name_of(const Build& build, const Population& population, const char* contender, const char* what) {
  return build.name + "/" + population.name + "/" + contender + "/" + what;
}

void time_run(const std::string& name, const Run& run, std::size_t n) {
  benchmark::RegisterBenchmark(name.c_str(), [run, n](benchmark::State& state) {
    std::size_t step = 0;
    for (auto _ : state) {
      step = next_step(step, n);
      Pass pass = run(step);
      benchmark::DoNotOptimize(pass);
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * n));
  });
}

/// A contender that is wrong on general pairs would be timed for another task.
void require_right(const std::string& name, const Run& run, const std::vector<SegmentPair>& pairs) {
  std::size_t hit = 0;
  for (const SegmentPair& p : pairs) hit += hits(p.segment, p.triangle);
  if (run(1).hits == hit) return;
  std::fprintf(stderr, "paper_bench: %s finds %zu hits, there are %zu\n", name.c_str(), run(1).hits, hit);
  std::exit(1);
}

void register_contender(const Build& build, const Population& population, const Contender& contender,
                        const std::vector<SegmentPair>& pairs) {
  for (const auto& [what, make] : {std::pair{"asks", contender.asks}, std::pair{"point", contender.point}}) {
    const std::string name = name_of(build, population, contender.name, what);
    const Run run = make(pairs);
    require_right(name, run, pairs);
    time_run(name, run, pairs.size());
  }
}

void register_all() {
  for (const Population& population : populations) {
    const std::vector<SegmentPair> pairs = random_pairs(population.size, population.percent);
    for (const Build& build : builds) {
      if (population.size == in_memory && build.name == "x87") continue;
      for (const Contender& contender : build.contenders) register_contender(build, population, contender, pairs);
    }
  }
}

void print_ratios(const Medians& m) {
  constexpr std::pair<const char*, const char*> quotients[] = {
      {"sf", "mt"},          {"sf", "badouel"},           {"sf_prepared", "badouel_prepared"},
      {"sf_prepared", "mt"}, {"jimenez", "mt"},           {"badouel_prepared", "mt"},
      {"chirkov2", "mt"},    {"chirkov3_prepared", "mt"}, {"baldwin_weber_prepared", "mt"}};
  for (const Build& build : builds) {
    for (const char* what : {"asks", "point"}) {
      for (const Population& population : populations) {
        for (const auto& [over, under] : quotients) {
          m.print_ratio(name_of(build, population, over, what) + "_over_" + under,
                        name_of(build, population, over, what), name_of(build, population, under, what));
        }
      }
    }
  }
}

}  // namespace
}  // namespace tribunal::bench

int main(int argc, char** argv) {
  using namespace tribunal::bench;
  register_all();
  return run_benchmarks(argc, argv, {.repetitions = 7, .seconds = 0.01}, "ns a pair", print_ratios);
}
