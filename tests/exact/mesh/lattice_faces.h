// Faces on a coarse lattice, simple ones and degenerate ones, and the even-odd region of their rings in integers.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "exact/cases/families/draw.h"
#include "exact/mesh/mesh.h"

namespace tribunal {

struct Place {
  std::int64_t x, y;
};

using Outline = std::vector<Place>;

inline std::int64_t turn(Place a, Place b, Place c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

inline bool is_on(Place q, Place a, Place b) {
  return turn(a, b, q) == 0 && std::min(a.x, b.x) <= q.x && q.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= q.y &&
         q.y <= std::max(a.y, b.y);
}

/// Whether q is in the even-odd region; on an edge the answer is either.
inline bool is_inside(const std::vector<Outline>& rings, Place q, bool& on_edge) {
  bool inside = false;
  for (const Outline& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Place a = ring[i], b = ring[(i + 1) % ring.size()];
      on_edge |= is_on(q, a, b);
      if ((a.y > q.y) != (b.y > q.y) && (b.y > a.y) == (turn(a, b, q) > 0)) inside = !inside;
    }
  }
  return inside;
}

/// Whether q is in the triangle, and not on its edges.
inline bool is_within(Place q, Place a, Place b, Place c) {
  const auto s = turn(a, b, q), t = turn(b, c, q), u = turn(c, a, q);
  return (s > 0 && t > 0 && u > 0) || (s < 0 && t < 0 && u < 0);
}

/// A face on a coarse lattice, with edges of four units, so that points between are off most lines.
struct Face {
  std::vector<Outline> rings;
  Outline all;
  Rings indices;
  std::vector<Point3> points;

  void add(const Outline& ring, const std::array<Point3, 2>& plane) {
    rings.push_back(ring);
    indices.emplace_back();
    for (const Place p : ring) {
      indices.back().push_back(static_cast<std::uint32_t>(all.size()));
      all.push_back(p);
      points.push_back(plane[0] * static_cast<double>(p.x) + plane[1] * static_cast<double>(p.y));
    }
  }

  std::string words() const {
    std::string text;
    for (const Outline& ring : rings) {
      for (const Place p : ring) text += "(" + std::to_string(p.x) + "," + std::to_string(p.y) + ") ";
      text += "| ";
    }
    return text;
  }
};

inline constexpr std::int64_t cell = 4;

inline Face draw_face(Draw& draw, std::size_t holes) {
  const auto side = draw.between(2, 4);
  const auto ring = [&](std::uint64_t count, std::int64_t step) {
    Outline outline(count);
    for (Place& p : outline) {
      p.x = step * draw.between(0, cell * side / step);
      p.y = step * draw.between(0, cell * side / step);
    }
    return outline;
  };
  constexpr std::array<std::array<double, 6>, 3> planes = {
      {{1, 0, 0, 0, 1, 0}, {2, 1, -3, 1, 5, 2}, {0, 0x1p200, 0, 0x1p-200, 0, 1}}};
  const auto& p = planes[draw.below(planes.size())];
  const std::array<Point3, 2> plane = {Point3(p[0], p[1], p[2]), Point3(p[3], p[4], p[5])};
  Face face;
  face.add(ring(3 + draw.below(6), cell), plane);
  for (std::size_t h = 0; h < holes; ++h) face.add(ring(3, cell / 2), plane);
  return face;
}

/// That each point off the rings is in one triangle if it is in the region, and in none if it is not.
inline void expect_tiles(const Face& face, const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  for (std::int64_t x = 0; x <= 4 * cell; ++x) {
    for (std::int64_t y = 0; y <= 4 * cell; ++y) {
      bool on_edge = false;
      const bool due = is_inside(face.rings, {x, y}, on_edge);
      if (on_edge) continue;
      int within = 0, on_side = 0;
      for (const auto& t : triangles) {
        const Place a = face.all[t[0]], b = face.all[t[1]], c = face.all[t[2]];
        within += is_within({x, y}, a, b, c);
        on_side += turn(a, b, c) != 0 && (is_on({x, y}, a, b) || is_on({x, y}, b, c) || is_on({x, y}, c, a));
      }
      ASSERT_EQ(within + on_side > 0, due) << face.words() << "at " << x << "," << y;
      ASSERT_LE(within, 1) << face.words() << "at " << x << "," << y;
    }
  }
}

}  // namespace tribunal
