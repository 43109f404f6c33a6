#include "tests/bench/medians.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace tribunal::bench {

void Medians::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
    const double items = run.counters.at("items_per_second");
    add(run.run_name.function_name, 1e9 / items);
  }
}

void Medians::pool(const char* file) {
  if (file == nullptr) return;
  std::string name;
  double nanoseconds = 0;
  for (std::ifstream in(file); in >> name >> nanoseconds;) add(name, nanoseconds);
  std::ofstream out(file);
  out.precision(17);
  for (const auto& [benchmark, samples] : samples_) {
    for (const double sample : samples) out << benchmark << ' ' << sample << '\n';
  }
}

double Medians::quantile(const std::string& name, double q) const {
  std::vector<double> sorted = samples_.at(name);
  std::sort(sorted.begin(), sorted.end());
  return sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1) + 0.5)];
}

void Medians::print(const char* item) const {
  std::printf("%-38s %10s %10s %10s  %s\n", item, "median", "tenth", "ninetieth", "repetitions");
  for (const auto& [name, samples] : samples_) {
    std::printf("%-38s %10.2f %10.2f %10.2f  %zu\n", name.c_str(), median(name), quantile(name, 0.1),
                quantile(name, 0.9), samples.size());
  }
}

void Medians::print_ratio(const std::string& name, const std::string& over, const std::string& under) const {
  if (!has(over) || !has(under)) return;
  std::printf("ratio %s %.3f [%.3f, %.3f]\n", name.c_str(), median(over) / median(under),
              quantile(over, 0.1) / quantile(under, 0.9), quantile(over, 0.9) / quantile(under, 0.1));
}

namespace {

/// `./run bench` names the file by which its processes pool their samples.
const char* pooled_samples() { return std::getenv("TRIBUNAL_BENCH_SAMPLES"); }

int run_interleaved(int argc, char** argv, Repetition repetition, Medians& medians) {
  std::vector<std::string> defaults = {argv[0], "--benchmark_repetitions=" + std::to_string(repetition.repetitions),
                                       "--benchmark_min_time=" + std::to_string(repetition.seconds),
                                       "--benchmark_enable_random_interleaving=true"};
  for (int i = 1; i < argc; ++i) defaults.emplace_back(argv[i]);
  std::vector<char*> arguments;
  for (std::string& a : defaults) arguments.push_back(a.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  return benchmark::RunSpecifiedBenchmarks(&medians) == 0 ? 1 : 0;
}

}  // namespace

int run_benchmarks(int argc, char** argv, Repetition repetition, const char* item,
                   const std::function<void(const Medians&)>& print, const std::function<void(Medians&)>& also) {
  Medians medians;
  if (const int failed = run_interleaved(argc, argv, repetition, medians)) return failed;
  also(medians);
  medians.pool(pooled_samples());
  medians.print(item);
  print(medians);
  return 0;
}

}  // namespace tribunal::bench
