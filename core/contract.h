// What a method promises, in types: the operands it takes, and how it reads contacts.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/answer.h"
#include "core/format.h"

namespace tribunal {

/// The probes that a method takes.
struct Probes {
  bool segments = true;
  bool rays = true;
  bool bounds = false;  ///< rays with bounds on t, against triangles

  friend bool operator==(const Probes&, const Probes&) = default;
};

/// The triangles that a method takes. `proper`: triangles that have an area, and no probe that is a point.
enum class Triangles : std::uint8_t { none, any, proper };

/// The polygons that a method takes. `planar`: polygons whose vertices lie in one plane exactly.
enum class Polygons : std::uint8_t { none, any, planar };

/// What a method makes of a probe that meets the boundary of its target and is not in its plane. `closed`: a hit.
/// `open`: a miss. `half_open`: where faces share an edge or a vertex, exactly one of them is hit, so nothing is
/// promised of a face alone. `unspecified`: nothing is promised.
enum class Boundary : std::uint8_t { closed, open, half_open, unspecified };

/// What a method makes of a probe that meets its target with an end alone: t = 0, or t = 1 of a segment.
/// `closed`: a hit. `open`: a miss. `unspecified`: nothing is promised.
enum class Ends : std::uint8_t { closed, open, unspecified };

/// Which triangles a method does not hit, although the probe meets them. `back_faces`: those whose vertices run
/// clockwise as seen from the source of the probe.
enum class Culling : std::uint8_t { none, back_faces };

/// What a method promises. It is judged by this and by nothing else.
struct Contract {
  Probes probes{};
  Triangles triangles = Triangles::any;
  Polygons polygons = Polygons::none;
  Convention convention = Convention::closed;    ///< the reading of coplanar contacts
  Boundary boundary = Boundary::closed;          ///< the reading of a triangle's boundary
  Boundary polygon_boundary = Boundary::closed;  ///< the reading of ring edges
  Ends ends = Ends::closed;                      ///< the reading of a probe's ends
  Ends bounds = Ends::closed;                    ///< the reading of tmin and tmax, where a ray has bounds
  Culling culling = Culling::none;   ///< which triangles are not hit; if any, pierced polygons are not judged
  Format format = Format::binary64;  ///< coordinates beyond this format are rounded on entry
  bool exact = false;                ///< promises the right answer to every query in its contract

  friend bool operator==(const Contract&, const Contract&) = default;
};

/// Whether an answer in the contract depends on the two point sets alone: not on which way the vertices run, which
/// faces are neighbours, or which points of the sets are left out.
constexpr bool reads_point_sets(const Contract& c) {
  return c.convention != Convention::unspecified && c.boundary == Boundary::closed && c.ends == Ends::closed &&
         c.bounds == Ends::closed && c.culling == Culling::none;
}

/// Whether an answer that is owed depends on the two point sets alone; where the boundary is not closed, it may be owed
/// to some probes only.
constexpr bool reads_as_sets(const Contract& c) {
  return c.convention != Convention::unspecified && c.ends == Ends::closed && c.culling == Culling::none;
}

/// Whether a contract takes any polygon and promises an answer to every probe.
constexpr bool promises_all_polygons(const Contract& c) {
  return c.polygons == Polygons::any && c.polygon_boundary == Boundary::closed && reads_point_sets(c);
}

/// The operands and the restrictions in words: "segment, ray; any triangle or polygon". The only way in which a
/// contract becomes prose; the reading of coplanar contacts has a column of its own wherever this is printed.
std::string in_words(const Contract& c);

constexpr std::string_view name_of(Triangles t) {
  constexpr std::string_view names[] = {"none", "any", "proper"};
  return names[static_cast<int>(t)];
}

constexpr std::string_view name_of(Polygons p) {
  constexpr std::string_view names[] = {"none", "any", "planar"};
  return names[static_cast<int>(p)];
}

constexpr std::string_view name_of(Boundary b) {
  constexpr std::string_view names[] = {"closed", "open", "half-open", "unspecified"};
  return names[static_cast<int>(b)];
}

constexpr std::string_view name_of(Ends e) {
  constexpr std::string_view names[] = {"closed", "open", "unspecified"};
  return names[static_cast<int>(e)];
}

constexpr std::string_view name_of(Culling c) { return c == Culling::none ? "none" : "back faces"; }

}  // namespace tribunal
