// What every benchmark program here does: run all benchmarks interleaved, gather their repetitions, print ratios of
// medians with their spread.
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace tribunal::bench {

/// Collects the repetitions of every benchmark, in nanoseconds an item, while the console shows its own table. Times
/// are CPU times, since others may use the machine.
class Medians : public benchmark::ConsoleReporter {
 public:
  Medians() : ConsoleReporter(OO_None) {}

  void ReportRuns(const std::vector<Run>& runs) override;

  /// Adds a repetition that was timed elsewhere.
  void add(const std::string& name, double nanoseconds) { samples_[name].push_back(nanoseconds); }

  bool has(const std::string& name) const { return samples_.count(name) > 0; }
  double median(const std::string& name) const { return quantile(name, 0.5); }

  /// Median, quartiles and number of repetitions of each benchmark; `item` says what one item is.
  void print(const char* item) const;

  /// `ratio NAME VALUE [LOW, HIGH]`, if both were measured: the quotient of two medians, and of opposite quartiles.
  void print_ratio(const std::string& name, const std::string& over, const std::string& under) const;

 private:
  double quantile(const std::string& name, double q) const;

  std::map<std::string, std::vector<double>> samples_;
};

/// How often each benchmark is run, and how long at least each time.
struct Repetition {
  int repetitions;
  double seconds = 0.02;
};

/// Runs all that was registered, in random order, repeated like this unless the arguments (Google Benchmark's) say
/// otherwise. Returns the exit code for main: 0, or 2 where an argument is unknown, or 1 where nothing ran.
int run_interleaved(int argc, char** argv, Repetition repetition, Medians& medians);

}  // namespace tribunal::bench
