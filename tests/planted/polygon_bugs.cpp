#include "tests/planted/polygon_bugs.h"

namespace tribunal::planted {

Method polygon_method(const char* name, const char* what, PolygonDecision decide) {
  Method m = method(name, what, [](const Segment&, const Triangle&) { return refusal(Status::unsupported); });
  m.contract = {.triangles = Triangles::none, .polygons = Polygons::any, .exact = true};
  m.polygon = [decide](const Polygon& polygon) -> PreparedPolygon {
    return {.segment = [decide, polygon](const Segment& s) { return decide(s, polygon); },
            .ray = [decide, polygon](const Ray& r) { return decide(r, polygon); }};
  };
  return m;
}

Answer right(const Probe& probe, const Polygon& polygon) { return answer_by(EpickKernel{}, probe, polygon); }

Answer about(const Polygon& other, const Probe& probe, const Polygon& polygon) {
  Answer answer = right(probe, other);
  answer.planar = right(probe, polygon).planar;
  return answer;
}

Polygon first_rings(const Polygon& polygon, std::size_t rings) {
  const std::size_t size = polygon.ends[rings - 1];
  return {polygon.vertices.first(size), polygon.ends.first(rings)};
}

std::vector<Method> polygon_bugs() {
  std::vector<Method> all;
  for (const auto rows : {covering_bugs, many_bugs, polygon_range_bugs, polygon_ray_bugs}) {
    for (Method& m : rows()) all.push_back(std::move(m));
  }
  return all;
}

std::vector<Method> sound_polygons() {
  std::vector<Method> all = sound_polygon_range();
  all.push_back(sound_covering());
  return all;
}

}  // namespace tribunal::planted
