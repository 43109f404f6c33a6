#include "exact/sweep/thresholds.h"

#include <algorithm>

namespace tribunal {
namespace {

constexpr AxisSide sides[] = {AxisSide::up, AxisSide::down};
constexpr ProbeKind probe_kinds[] = {ProbeKind::segment, ProbeKind::ray};
constexpr Format formats[] = {Format::binary32, Format::binary64};

/// The marks from the easiest value outward, where anything could fail.
std::vector<Mark> marks_of(const SweepPlan& plan, const Sweep& sweep, const Threshold& t) {
  std::vector<Mark> marks;
  for (const int value : values_outward(*plan.axes[t.axis], t.format, t.side)) {
    const auto found = sweep.counts.find({t.method, t.axis, t.format, value, t.probe});
    if (found == sweep.counts.end()) continue;
    const Mark mark{value, found->second.failures(t.outcome), found->second.chances(t.outcome)};
    if (mark.chances > 0) marks.push_back(mark);
  }
  return marks;
}

bool fails_completely(const Mark& m) { return m.failures == m.chances; }

/// Sets the marks; false if nothing failed.
bool find_marks(const std::vector<Mark>& marks, Threshold& t) {
  const auto first = std::ranges::find_if(marks, [](const Mark& m) { return m.failures > 0; });
  if (first == marks.end()) return false;
  t.first = *first;
  if (first != marks.begin()) t.before = *std::prev(first);
  const auto last_right = std::find_if_not(marks.rbegin(), marks.rend(), fails_completely);
  if (last_right != marks.rbegin()) t.all = *last_right.base();
  return true;
}

}  // namespace

std::vector<int> values_outward(const StressAxis& axis, Format format, AxisSide side) {
  const std::span<const int> all = axis.values(format);
  std::vector<int> values(all.begin(), all.end());
  const int easiest = axis.easiest(format);
  std::erase_if(values, [&](int v) { return side == AxisSide::up ? v < easiest : v > easiest; });
  if (side == AxisSide::down) std::ranges::reverse(values);
  if (values.size() == 1) values.clear();
  return values;
}

std::vector<Threshold> thresholds_of(const SweepPlan& plan, const Sweep& sweep) {
  std::vector<Threshold> rows;
  for (std::size_t method = 0; method < plan.methods.size(); ++method) {
    for (std::size_t axis = 0; axis < plan.axes.size(); ++axis) {
      for (const Format format : formats) {
        for (const AxisSide side : sides) {
          for (const SweptOutcome outcome : swept_outcomes) {
            for (const ProbeKind probe : probe_kinds) {
              Threshold t{method, axis, format, side, probe, outcome};
              if (find_marks(marks_of(plan, sweep, t), t)) rows.push_back(t);
            }
          }
        }
      }
    }
  }
  return rows;
}

}  // namespace tribunal
