#include "tests/bench/medians.h"

#include <algorithm>
#include <cstdio>

namespace tribunal::bench {
namespace {

double quantile_of(std::vector<double> samples, double q) {
  std::sort(samples.begin(), samples.end());
  return samples[static_cast<std::size_t>(q * static_cast<double>(samples.size() - 1) + 0.5)];
}

}  // namespace

void Medians::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
    const double items = run.counters.at("items_per_second");
    add(run.run_name.function_name, 1e9 / items);
  }
}

double Medians::quantile(const std::string& name, double q) const { return quantile_of(samples_.at(name), q); }

void Medians::print(const char* item) const {
  std::printf("%-38s %10s %10s %10s  %s\n", item, "median", "lower q.", "upper q.", "repetitions");
  for (const auto& [name, samples] : samples_) {
    std::printf("%-38s %10.2f %10.2f %10.2f  %zu\n", name.c_str(), median(name), quantile(name, 0.25),
                quantile(name, 0.75), samples.size());
  }
}

void Medians::print_ratio(const std::string& name, const std::string& over, const std::string& under) const {
  if (!has(over) || !has(under)) return;
  const std::vector<double>&a = samples_.at(over), &b = samples_.at(under);
  std::vector<double> quotients;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) quotients.push_back(a[i] / b[i]);
  std::printf("ratio %s %.3f [%.3f, %.3f]\n", name.c_str(), median(over) / median(under), quantile_of(quotients, 0.25),
              quantile_of(quotients, 0.75));
}

int run_interleaved(int argc, char** argv, int repetitions, Medians& medians) {
  std::vector<std::string> defaults = {argv[0], "--benchmark_repetitions=" + std::to_string(repetitions),
                                       "--benchmark_min_time=0.02", "--benchmark_enable_random_interleaving=true"};
  for (int i = 1; i < argc; ++i) defaults.emplace_back(argv[i]);
  std::vector<char*> arguments;
  for (std::string& a : defaults) arguments.push_back(a.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  return benchmark::RunSpecifiedBenchmarks(&medians) == 0 ? 1 : 0;
}

}  // namespace tribunal::bench
