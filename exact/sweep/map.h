// Failure maps: what a method answers where one pair of coordinates of a contact is moved by units in the last place.
// Source: Kettner, Mehlhorn, Pion, Schirra & Yap, "Classroom examples of robustness problems in geometric
// computations", Computational Geometry 40(1), 2008, doi:10.1016/j.comgeo.2007.06.003.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "exact/base/json_fwd.h"
#include "exact/trial/fuzz.h"

namespace tribunal {

/// A contact of a segment and a triangle at the middle of a map. Its pixels move x and y of the probe's source: of the
/// segment, or of the ray from its source whose direction, which stays, is the rounded difference of its ends. The ray
/// meets the triangle in the same way.
struct MapContact {
  std::string_view name;   ///< on the command line
  std::string_view about;  ///< what touches what in the middle, and where the exact answer is a hit
  SegmentPair (*at)(Format);
};

std::span<const MapContact> all_map_contacts();

/// The contact of this name; nullptr if there is none.
const MapContact* find_map_contact(std::string_view name);

/// A point with x and y moved by units in the last place, which are the same across a map: the middle is at 0.75.
Point3 moved_on_map(const Point3& p, Format format, int x, int y);

/// What a map is of.
struct MapKind {
  const MapContact* contact = nullptr;
  ProbeKind probe = ProbeKind::segment;
  int size = 256;  ///< pixels on each side

  /// "edge" of segments, "edge-ray" of rays.
  std::string name() const;
};

/// The case of pixel (x, y) of a map; both count from 0, and the contact is that of the pixel (size / 2, size / 2).
Query query_of_pixel(const MapKind& map, Format format, int x, int y);

/// What one method answers, a character a pixel, rows upward.
struct MapPanel {
  std::size_t method;
  std::vector<std::string> pixels;
  std::map<Outcome, std::uint64_t> counts;
};

struct MapPlan {
  std::vector<Method> methods{};
  MapKind map{};
  unsigned threads = 1;
};

struct FailureMap {
  std::map<Format, std::vector<std::string>> truth{};  ///< 'h' for a hit of closed sets, '.' for none; of formats asked
  std::vector<MapPanel> panels{};
};

/// The characters of a panel: H and M right hits and misses, + a false hit, - a false miss, c a wrong contact, x a
/// fault, ? refused, and a space where nothing is owed.
char character_of(Outcome outcome, bool hit);

/// A method is asked in its own format. Deterministic. Fails with 128 + signal if interrupted.
FailureMap failure_map(const MapPlan& plan);

/// map-NAME.json, with the name of the map's kind: one row of pixels a line. With the case in the middle and the unit,
/// so that whoever reads it can make the case of any pixel.
std::string to_json_text(const MapPlan& plan, const FailureMap& map);

/// What the terminal shows.
std::string to_table(const MapPlan& plan, const FailureMap& map);

}  // namespace tribunal
