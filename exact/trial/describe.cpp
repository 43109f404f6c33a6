#include "exact/trial/describe.h"

#include <cstdio>

#include "exact/classes/class_table.h"

namespace tribunal {
namespace {

std::string said(const Truth& truth) {
  return truth.hit() ? "hit (" + std::string(name_of(truth.contact)) + ")" : "no hit";
}

std::string line_of(const std::string& name, const Point3& p) {
  char line[120];
  std::snprintf(line, sizeof line, "  %s = (%.17g, %.17g, %.17g)\n", name.c_str(), p.x, p.y, p.z);
  return line;
}

std::string line_of(const Bounds& bounds) {
  char line[80];
  std::snprintf(line, sizeof line, "  t = %.17g to %.17g\n", bounds.tmin, bounds.tmax);
  return line;
}

std::string place_in_words(At at) { return at == At::source ? "tmin" : at == At::target ? "tmax" : "inside"; }

std::string points_of(const Segment& s) { return line_of("p", s.p) + line_of("q", s.q); }
std::string points_of(const Ray& r) { return line_of("o", r.o) + line_of("d", r.d.v); }
std::string points_of(const Triangle& t) { return line_of("a", t.a) + line_of("b", t.b) + line_of("c", t.c); }

std::string points_of(const Polygon& polygon) {
  std::string text;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const std::string name = r == 0 ? "outer" : "hole " + std::to_string(r);
    for (std::size_t i = 0; i < polygon.ring(r).size(); ++i) {
      text += line_of(name + "[" + std::to_string(i) + "]", polygon.ring(r)[i]);
    }
  }
  return text;
}

}  // namespace

std::string describe(const Truth& truth) {
  if (truth.operands() == Operands::polygons) return said(truth) + (truth.planar ? ", planar" : ", not planar");
  const ClassRow& row = class_row(truth.class_id);
  return class_name(truth.class_id) + ": " + said(truth) + "; triangle " + row.triangle + ", " +
         (truth.of_ray ? "ray " : "segment ") + row.probe +
         (truth.bounded ? ", without bounds meet in: " : ", meet in: ") + row.intersection +
         (truth.bounded && truth.at != At::unsaid ? ", met at its " + place_in_words(truth.at) : "");
}

std::string points_of(const Query& query) {
  const auto points = [](const auto& operand) { return points_of(operand); };
  const std::string bounds = query.bounds ? line_of(*query.bounds) : "";
  return std::visit(points, query.probe) + bounds + std::visit(points, query.target);
}

std::string id_part(const Truth& truth) {
  if (truth.operands() == Operands::triangles) return class_name(truth.class_id);
  return std::string(name_of(truth.contact)) + (truth.planar ? "" : "-not-planar");
}

}  // namespace tribunal
