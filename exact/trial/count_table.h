// Counts of a fuzz run, by where they belong.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "exact/trial/judge.h"
#include "exact/trial/slot.h"

namespace tribunal {

/// Where a count belongs. Indices into the plan.
struct Cell {
  std::size_t method, stream, level;
  Slot slot;
};

/// Counts by method × stream × level × slot. Only the rows in which something was counted take room.
class CountTable {
 public:
  CountTable(std::size_t methods, std::size_t streams, std::size_t levels, SlotRange slots);
  Count& at(const Cell& cell);
  CountTable& operator+=(const CountTable& other);

  /// All cells in which something was asked, in index order, with their counts.
  void for_each(const std::function<void(const Cell&, const Count&)>& visit) const;

  friend bool operator==(const CountTable& a, const CountTable& b) { return a.rows_ == b.rows_; }

 private:
  std::size_t streams_, levels_;
  SlotRange slots_;
  std::vector<std::vector<Count>> rows_;
};

}  // namespace tribunal
