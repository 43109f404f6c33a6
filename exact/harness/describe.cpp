#include "exact/harness/describe.h"

#include <cstdio>

#include "exact/classes/class_table.h"

namespace tribunal {
namespace {

template <class T>
std::string said(const T& truth) {
  return truth.hit() ? "hit (" + std::string(name_of(truth.contact)) + ")" : "no hit";
}

std::string line_of(const std::string& name, const Point3& p) {
  char line[120];
  std::snprintf(line, sizeof line, "  %s = (%.17g, %.17g, %.17g)\n", name.c_str(), p.x, p.y, p.z);
  return line;
}

std::string points_of(const Probe& probe) {
  if (const auto* s = std::get_if<Segment>(&probe)) return line_of("p", s->p) + line_of("q", s->q);
  const Ray& r = std::get<Ray>(probe);
  return line_of("o", r.o) + line_of("d", r.d.v);
}

}  // namespace

std::string describe(const Truth& truth) {
  if (truth.class_id == 0) return said(truth);
  const ClassRow& row = class_row(truth.class_id);
  return class_name(truth.class_id) + ": " + said(truth) + "; triangle " + row.triangle + ", " +
         (is_ray_class(truth.class_id) ? "ray " : "segment ") + row.probe + ", meet in: " + row.intersection;
}

std::string describe(const PolygonTruth& truth) { return said(truth) + (truth.planar ? ", planar" : ", not planar"); }

std::string points_of(const Query& query) {
  const Triangle& t = query.triangle;
  return points_of(query.probe) + line_of("a", t.a) + line_of("b", t.b) + line_of("c", t.c);
}

std::string points_of(const PolygonQuery& query) {
  std::string text = points_of(query.probe);
  const Polygon polygon = query.polygon;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const std::string name = r == 0 ? "outer" : "hole " + std::to_string(r);
    for (std::size_t i = 0; i < polygon.ring(r).size(); ++i) {
      text += line_of(name + "[" + std::to_string(i) + "]", polygon.ring(r)[i]);
    }
  }
  return text;
}

std::string id_part(const Truth& truth) { return class_name(truth.class_id); }

std::string id_part(const PolygonTruth& truth) {
  return std::string(name_of(truth.contact)) + (truth.planar ? "" : "-not-planar");
}

}  // namespace tribunal
