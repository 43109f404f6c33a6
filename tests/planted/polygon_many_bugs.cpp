// Bugs that show only where there are many vertices or rings.
#include <algorithm>

#include "tests/planted/polygon_bugs.h"

namespace tribunal::planted {
namespace {

/// Rings are copied into a buffer of 64 vertices.
Answer buffer_of_64(const Probe& probe, const Polygon& polygon) {
  PolygonData cut;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const Ring ring = polygon.ring(r);
    cut.add({ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(ring.size(), 64))});
  }
  return about(cut, probe, polygon);
}

Answer four_rings(const Probe& probe, const Polygon& polygon) {
  return about(first_rings(polygon, std::min<std::size_t>(polygon.rings(), 4)), probe, polygon);
}

/// One ring is lost where there are many.
Answer a_hole_cut_off(const Probe& probe, const Polygon& polygon) {
  PolygonData cut;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const Ring ring = polygon.ring(r);
    if (r == 0 || r != polygon.rings() / 2) cut.add({ring.begin(), ring.end()});
  }
  return about(cut, probe, polygon);
}

PolygonData with_open_rings(const Polygon& polygon, std::size_t longer_than) {
  PolygonData there_and_back;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    std::vector<Point3> ring(polygon.ring(r).begin(), polygon.ring(r).end());
    if (ring.size() > longer_than) ring.insert(ring.end(), ring.rbegin(), ring.rend());
    there_and_back.add(ring);
  }
  return there_and_back;
}

/// The last vertex of a ring with more vertices than these has no edge back to the first.
template <std::size_t longer_than>
Answer rings_not_closed(const Probe& probe, const Polygon& polygon) {
  Answer answer = right(probe, polygon);
  if (answer.contact != Contact::edge) return answer;
  answer.hit = right(probe, with_open_rings(polygon, longer_than)).hit;
  return answer;
}

}  // namespace

std::vector<Method> many_bugs() {
  return {
      polygon_method("planted-open-rings", "the edge back to the first vertex is excluded", rings_not_closed<0>),
      polygon_method("planted-last-edge", "the last edge of a ring of more than 100 vertices is forgotten",
                     rings_not_closed<100>),
      polygon_method("planted-64-vertices", "rings are cut off after 64 vertices", buffer_of_64),
      polygon_method("planted-four-rings", "only four rings are looked at", four_rings),
      polygon_method("planted-hole-cut-off", "one of many rings is lost", a_hole_cut_off),
  };
}

}  // namespace tribunal::planted
