// Collects the repetitions of every benchmark, in nanoseconds a query, while the console shows its own table.
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace tribunal::bench {

class Medians : public benchmark::ConsoleReporter {
 public:
  explicit Medians(const char* unit) : ConsoleReporter(OO_None), unit_(unit) {}

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const double queries = run.counters.at("items_per_second");
      samples_[run.run_name.function_name].push_back(1e9 / queries);
    }
  }

  bool has(const std::string& name) const { return samples_.count(name) > 0; }
  double median(const std::string& name) const { return quantile(name, 0.5); }

  double quantile(const std::string& name, double q) const {
    std::vector<double> sorted = samples_.at(name);
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1) + 0.5)];
  }

  /// ns a query: median, quartiles, repetitions.
  void print() const {
    std::printf("%-44s %10s %10s %10s  %s\n", unit_, "median", "lower q.", "upper q.", "repetitions");
    for (const auto& [name, samples] : samples_) {
      std::printf("%-44s %10.2f %10.2f %10.2f  %zu\n", name.c_str(), median(name), quantile(name, 0.25),
                  quantile(name, 0.75), samples.size());
    }
  }

 private:
  const char* unit_;
  std::map<std::string, std::vector<double>> samples_;
};

/// numerator / denominator, if both were measured.
inline void print_ratio(const Medians& m, const std::string& name, const std::string& over, const std::string& under) {
  if (m.has(over) && m.has(under)) std::printf("ratio %s %.3f\n", name.c_str(), m.median(over) / m.median(under));
}

}  // namespace tribunal::bench
