// What the benchmark programs share: they run all benchmarks interleaved, collect the repetitions, and print ratios of
// medians with their spread.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace tribunal::bench {

/// Collects the time of every repetition of every benchmark, in nanoseconds per item, besides the table on the
/// console. Times are CPU times, since other programs may use the machine.
class Medians : public benchmark::ConsoleReporter {
 public:
  Medians() : ConsoleReporter(OO_None) {}

  void ReportRuns(const std::vector<Run>& runs) override;

  /// Adds a repetition that was timed elsewhere.
  void add(const std::string& name, double nanoseconds) { samples_[name].push_back(nanoseconds); }

  /// Adds the samples of the file, if it is there, and writes all to it; does nothing without a file. So several
  /// processes make one result: where a process's memory lies moves its times by more than its repetitions show.
  void pool(const char* file);

  bool has(const std::string& name) const { return samples_.count(name) > 0; }
  double median(const std::string& name) const { return quantile(name, 0.5); }

  /// Prints the median, the tenth and ninetieth percentile and the number of repetitions of each benchmark; `item`
  /// names one item.
  void print(const char* item) const;

  /// Prints `ratio NAME VALUE [LOW, HIGH]` if both were measured: the quotient of two medians, and those of opposite
  /// percentiles, tenth over ninetieth and the other way.
  void print_ratio(const std::string& name, const std::string& over, const std::string& under) const;

 private:
  double quantile(const std::string& name, double q) const;

  std::map<std::string, std::vector<double>> samples_;
};

/// How often each benchmark is run by one process, and the least time of each run.
struct Repetition {
  int repetitions;
  double seconds = 0.02;
};

/// All that the main function of a benchmark does once its benchmarks are registered. Runs them in random order, with
/// these repetitions unless Google Benchmark's arguments say otherwise; lets `also` add what is timed elsewhere; pools
/// the samples, prints them, an item of which is called `item`, and then what `print` makes of them. Returns the exit
/// code: 0; 1 if nothing ran; 2 if an argument is unknown.
int run_benchmarks(
    int argc, char** argv, Repetition repetition, const char* item, const std::function<void(const Medians&)>& print,
    const std::function<void(Medians&)>& also = [](Medians&) {});

}  // namespace tribunal::bench
