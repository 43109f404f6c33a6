// The populations of cases that a chart measures every method on.
#pragma once

#include <span>
#include <string_view>

#include "exact/trial/fuzz.h"

namespace tribunal {

/// One panel of the chart. Its family makes the cases, so that the fuzz harness judges them and timing repeats them.
struct Population {
  std::string_view key, title;
  std::string_view about;  ///< what a number measured on it is about
  Family family;
  std::span<const Format> formats;
};

/// The cases with a segment of a family that aims at classes: 163 of one level, then of the next.
Family segments_of(std::string_view name);

/// General position, exact degeneracies with full mantissas, and their neighbours some units in the last place off.
std::span<const Population> all_populations();

/// The format of the cases that stand for a method in the figure: its own, or the only one that the population has. A
/// binary64 method is also measured on the binary32 cases, so that it can be compared with a binary32 one case by case.
Format drawn_format(const Population& population, const Method& method);

}  // namespace tribunal
