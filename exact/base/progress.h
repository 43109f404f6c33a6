// One line of progress on standard error, only where that is a terminal.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace tribunal {

/// Thread-safe. `label  42 %  1.2 M cases  3.1 M/s  12 s left  2 findings`, at most five times a second.
class Progress {
 public:
  /// `total` 0: unknown.
  Progress(std::string label, std::string unit, std::uint64_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void add(std::uint64_t done, std::uint64_t findings = 0);

  /// Seconds since construction.
  double elapsed() const;

 private:
  void draw();

  using Clock = std::chrono::steady_clock;
  const std::string label_, unit_;
  const std::uint64_t total_;
  const bool terminal_;
  const Clock::time_point start_ = Clock::now();
  std::atomic<std::uint64_t> done_{0}, findings_{0};
  std::mutex drawing_;
  Clock::time_point drawn_{};
};

/// 1234567 → "1.23 M".
std::string compact(double x);

}  // namespace tribunal
