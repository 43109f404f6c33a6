// The populations of cases that a chart measures every method on.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "exact/trial/fuzz.h"

namespace tribunal {

/// The figure that a population is drawn in: the one that people quote, that of other shares of hits, or that of
/// polygons.
enum class Figure : std::uint8_t { main, shares, polygons };

/// One panel of a figure for each format. Its family makes the cases, so that the fuzz harness judges them and timing
/// repeats them.
struct Population {
  std::string_view key, title;
  std::string about;  ///< what a number measured on it is about
  Family family;
  Figure figure = Figure::main;
  std::optional<int> percent_hits{};  ///< that it is dealt to have; else as many as there are

  bool of_polygons() const { return family.operands == Operands::polygons; }
};

/// The cases with a segment of a family that aims at classes: 163 of one level, then of the next.
Family segments_of(std::string_view name);

/// General position at some shares of hits, exact degeneracies with full mantissas, and their neighbours some units in
/// the last place off; the same two of polygons. Each has cases in either format, which are never added up.
std::span<const Population> all_populations();

/// Whether the contract takes the population's operands.
bool takes(const Method& method, const Population& population);

}  // namespace tribunal
