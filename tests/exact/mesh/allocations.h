// How much memory a piece of code takes: the global `operator new` of this program counts.
#pragma once

#include <cstddef>

namespace tribunal::testing {

/// Counts the bytes that this thread holds by `new`, from its construction to its destruction. One at a time a thread.
class AllocationPeak {
 public:
  AllocationPeak();
  ~AllocationPeak();
  AllocationPeak(const AllocationPeak&) = delete;
  AllocationPeak& operator=(const AllocationPeak&) = delete;

  /// The most that was held at once so far.
  std::size_t bytes() const;
};

}  // namespace tribunal::testing
