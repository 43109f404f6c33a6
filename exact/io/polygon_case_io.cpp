#include "exact/io/polygon_case_io.h"

#include <utility>

#include "exact/io/failure.h"

namespace tribunal {
PolygonData to_polygon(const Json& rings, Format format, const Where& where) {
  if (!rings.is_array() || rings.empty()) where.fail("expected an array of at least one ring");
  PolygonData polygon;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Where at = where.index(r);
    if (!rings[r].is_array() || rings[r].empty()) at.fail("expected an array of at least one point");
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      polygon.vertices.push_back(to_point(rings[r][i], format, at.index(i)));
    }
    polygon.ends.push_back(polygon.vertices.size());
  }
  return polygon;
}

Json from_polygon(const Polygon& polygon) {
  Json rings = Json::array();
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    Json ring = Json::array();
    for (const Point3& v : polygon.ring(r)) ring.push_back(from_point(v));
    rings.push_back(std::move(ring));
  }
  return rings;
}

PolygonCase to_polygon_case(const Json& object, const Where& where) {
  require_keys(object, {"id", "fmt", "seg", "ray", "tri", "rings", "expect", "class", "source", "finding"}, where);
  if (object.contains("tri")) where.key("tri").fail("expected one of \"tri\" and \"rings\", found both");
  if (object.contains("class")) where.key("class").fail("a case with \"rings\" has no class, expected none");
  CaseHead head = to_case_head(object, where);
  PolygonData polygon = to_polygon(require(object, "rings", where), head.format, where.key("rings"));
  return {.id = std::move(head.id),
          .format = head.format,
          .query = {head.probe, std::move(polygon)},
          .expect = head.expect,
          .source = std::move(head.source),
          .finding = std::move(head.finding)};
}

Json from_case(const PolygonCase& c) {
  Json object;
  object["id"] = c.id;
  object["fmt"] = name_of(c.format);
  add_probe(object, c.query.probe);
  object["rings"] = from_polygon(c.query.polygon);
  if (c.expect) object["expect"] = *c.expect ? 1 : 0;
  if (!c.source.empty()) object["source"] = c.source;
  if (!c.finding.is_null()) object["finding"] = c.finding;
  return object;
}

AnyCase to_any_case(const Json& object, const Where& where) {
  if (object.is_object() && object.contains("rings")) return to_polygon_case(object, where);
  return to_case(object, where);
}

std::vector<AnyCase> read_any_cases(const std::string& path) {
  std::vector<AnyCase> cases;
  for_each_line(path, [&](const Json& object, const Where& where) { cases.push_back(to_any_case(object, where)); });
  if (cases.empty()) throw bad_input(path, 0, "holds no cases, expected one JSON object a line");
  return cases;
}

std::vector<PolygonCase> read_polygon_cases(const std::string& path) {
  std::vector<PolygonCase> cases;
  for_each_line(path, [&](const Json& object, const Where& where) {
    if (object.is_object() && object.contains("tri") && !object.contains("rings")) {
      where.key("tri").fail("polygons are certified apart from triangles, expected \"rings\"");
    }
    cases.push_back(to_polygon_case(object, where));
  });
  if (cases.empty()) throw bad_input(path, 0, "holds no cases, expected one JSON object a line");
  return cases;
}

Json from_answer(const std::string& id, const Method& method, const PolygonAnswer& answer) {
  Json object = from_answer(id, method, answer.answer);
  if (answer.answer.status == Status::ok && method.contract.polygons == Polygons::any) object["planar"] = answer.planar;
  return object;
}

}  // namespace tribunal
