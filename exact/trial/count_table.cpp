#include "exact/trial/count_table.h"

namespace tribunal {

CountTable::CountTable(std::size_t methods, std::size_t streams, std::size_t levels, SlotRange slots)
    : streams_(streams), levels_(levels), slots_(slots), rows_(methods * streams * levels) {}

Count& CountTable::at(const Cell& c) {
  std::vector<Count>& row = rows_[(c.method * streams_ + c.stream) * levels_ + c.level];
  if (row.empty()) row.resize(slots_.size());
  return row[static_cast<std::size_t>(c.slot - slots_.first)];
}

CountTable& CountTable::operator+=(const CountTable& other) {
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    if (other.rows_[r].empty()) continue;
    rows_[r].resize(slots_.size());
    for (std::size_t i = 0; i < rows_[r].size(); ++i) rows_[r][i] += other.rows_[r][i];
  }
  return *this;
}

void CountTable::for_each(const std::function<void(const Cell&, const Count&)>& visit) const {
  for (std::size_t r = 0; r < rows_.size(); ++r) {
    for (std::size_t i = 0; i < rows_[r].size(); ++i) {
      if (rows_[r][i].asked == 0) continue;
      visit({r / levels_ / streams_, r / levels_ % streams_, r % levels_, static_cast<Slot>(slots_.first + i)},
            rows_[r][i]);
    }
  }
}

}  // namespace tribunal
