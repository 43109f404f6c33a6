// A drawing of a class: its representative seen from where most can be told apart.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exact/base/json_fwd.h"
#include "exact/classes/class_table.h"

namespace tribunal {

/// A place in a drawing of 120 × 90 units, x to the right and y downward.
struct Spot {
  double x = 0, y = 0;
};

/// A line from one place to another, which may be the same.
struct Stroke {
  Spot from, to;
};

/// One place where points lie, and their names: "a", or "bp" where b and p coincide.
struct Dot {
  Spot at;
  std::string names;
};

/// The triangle, the probe and what they have in common. A ray is drawn up to some way behind its last point in common,
/// with an arrow. Where all lies on one line, the probe is drawn beside the triangle: `apart`.
struct Drawing {
  std::array<Spot, 3> triangle{};
  Stroke probe{};
  bool arrow = false, apart = false;
  std::vector<Dot> dots{};
  std::optional<Stroke> meet{};    ///< on the probe; nothing of a miss
  std::optional<Stroke> hidden{};  ///< the part of the probe behind the triangle
};

/// A pure function of the class. Computed in double from small integers: it draws, and decides nothing.
Drawing drawing_of(const ClassRow& row);

Json to_json(const Drawing& drawing);

}  // namespace tribunal
