#include "exact/cases/case_io.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "exact/base/failure.h"
#include "exact/base/foreign_json.h"
#include "exact/base/lines.h"
#include "exact/base/record.h"
#include "exact/cases/case_line.h"
#include "exact/cases/case_scan.h"
#include "exact/classes/class_table.h"

namespace tribunal {
namespace {

std::string to_text(const Json& object, const char* key, const Where& where) { return Record(object, where).text(key); }

Format to_format(const Json& object, const Where& where) {
  if (!object.contains("fmt")) return Format::binary64;
  const std::string name = to_text(object, "fmt", where);
  if (name == "binary64") return Format::binary64;
  if (name == "binary32") return Format::binary32;
  where.key("fmt").fail("expected \"binary64\" or \"binary32\", found \"" + name + "\"");
}

template <std::size_t N>
std::array<Point3, N> to_points(const Json& value, Format format, const Where& where) {
  if (!value.is_array() || value.size() != N) where.fail("expected " + std::to_string(N) + " points");
  std::array<Point3, N> points;
  for (std::size_t i = 0; i < N; ++i) points[i] = to_any_point(value[i], format, where.index(i));
  return points;
}

Segment to_segment(const Json& value, Format format, const Where& where) {
  const auto v = to_points<2>(value, format, where);
  return {v[0], v[1]};
}

Triangle to_triangle(const Json& value, Format format, const Where& where) {
  const auto v = to_points<3>(value, format, where);
  return {v[0], v[1], v[2]};
}

PolygonData to_polygon(const Json& rings, Format format, const Where& where) {
  if (!rings.is_array() || rings.empty()) where.fail("expected an array of at least one ring");
  PolygonData polygon;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    const Where at = where.index(r);
    if (!rings[r].is_array() || rings[r].empty()) at.fail("expected an array of at least one point");
    for (std::size_t i = 0; i < rings[r].size(); ++i) {
      polygon.vertices.push_back(to_any_point(rings[r][i], format, at.index(i)));
    }
    polygon.ends.push_back(polygon.vertices.size());
  }
  return polygon;
}

Target to_target(const Json& object, Format format, const Where& where) {
  const bool triangle = object.contains("tri"), rings = object.contains("rings");
  if (triangle && rings) where.key("tri").fail("expected one of \"tri\" and \"rings\", found both");
  if (triangle) return to_triangle(object["tri"], format, where.key("tri"));
  if (rings) return to_polygon(object["rings"], format, where.key("rings"));
  where.fail("missing \"tri\" or \"rings\"");
}

/// "inf", and no hex float.
bool is_word(const std::string& text) { return text.find_first_of("xX") == std::string::npos; }

/// `[tmin, tmax]`: numbers of the case's format, the second perhaps "inf", which is none but says that there is no
/// bound. A number that rounds to infinity is a bound, and is not finite.
Bounds to_bounds(const Json& value, Format format, const Where& where) {
  if (!value.is_array() || value.size() != 2) where.fail("expected two numbers, tmin and tmax");
  Bounds bounds{.tmin = to_any_number(value[0], format, where.index(0)),
                .tmax = to_any_number(value[1], format, where.index(1))};
  const bool unbounded = bounds.tmax > 0 && value[1].is_string() && is_word(Record(value[1], where.index(1)).text());
  if (std::isinf(bounds.tmax) && !unbounded) bounds.tmax = std::numeric_limits<double>::quiet_NaN();
  if (!is_finite(bounds)) return bounds;
  if (bounds.tmin < 0) where.index(0).fail("expected tmin >= 0");
  if (bounds.tmax < bounds.tmin) where.index(1).fail("expected tmax >= tmin, or \"inf\"");
  return bounds;
}

std::optional<Bounds> to_bounds(const Json& object, const Query& query, Format format, const Where& where) {
  if (!is_of_ray(query) || !object["ray"].contains("t")) return {};
  const Where at = where.key("ray").key("t");
  if (query.operands() != Operands::triangles) at.fail("bounds are asked about triangles, expected \"tri\"");
  return to_bounds(object["ray"]["t"], format, at);
}

Ray to_ray(const Json& value, Format format, const Where& where) {
  require_keys(value, {"o", "d", "t"}, where);
  return {to_any_point(require(value, "o", where), format, where.key("o")),
          {to_any_point(require(value, "d", where), format, where.key("d"))}};
}

Probe to_probe(const Json& object, Format format, const Where& where) {
  const bool segment = object.contains("seg"), ray = object.contains("ray");
  if (segment == ray) where.fail("expected exactly one of \"seg\" and \"ray\"");
  if (segment) return to_segment(object["seg"], format, where.key("seg"));
  return to_ray(object["ray"], format, where.key("ray"));
}

std::optional<bool> to_expectation(const Json& object, const Where& where) {
  if (!object.contains("expect")) return {};
  const Json& value = object["expect"];
  if (value != 0 && value != 1) where.key("expect").fail("expected 0 or 1");
  return value == 1;
}

ClassId to_class(const Json& object, const Where& where) {
  if (!object.contains("class")) return 0;
  const std::string name = to_text(object, "class", where);
  const ClassId id = class_named(name);
  if (id == 0) {
    where.key("class").fail("expected a class C001 to C163 or, of a ray, R001 to R165, found \"" + name + "\"");
  }
  return id;
}

void add_probe(Json& object, const Probe& probe) {
  if (const auto* s = std::get_if<Segment>(&probe)) {
    object["seg"] = {from_point(s->p), from_point(s->q)};
  } else {
    const Ray& r = std::get<Ray>(probe);
    object["ray"] = {{"o", from_point(r.o)}, {"d", from_point(r.d.v)}};
  }
}

void add_bounds(Json& object, const Bounds& bounds) {
  object["ray"]["t"] = Json::array({hex_float(bounds.tmin), hex_float(bounds.tmax)});
}

void add_target(Json& object, const Triangle& t) {
  object["tri"] = {from_point(t.a), from_point(t.b), from_point(t.c)};
}

void add_target(Json& object, const Polygon& polygon) {
  Json rings = Json::array();
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    Json ring = Json::array();
    for (const Point3& v : polygon.ring(r)) ring.push_back(from_point(v));
    rings.push_back(std::move(ring));
  }
  object["rings"] = std::move(rings);
}

constexpr std::size_t lines_at_once = 1024, bytes_at_once = std::size_t{1} << 18;

bool next_block(LineReader& reader, LineBlock& block) { return reader.next(block, lines_at_once, bytes_at_once); }

void for_each_line_of(LineReader reader, const std::string& path,
                      const std::function<void(const Json& object, const Where& where)>& visit) {
  const auto read = [&](std::string_view line, std::size_t number) {
    const Where where{path, number};
    visit(parse_json_beyond(line, where), where);
  };
  for (LineBlock block; next_block(reader, block);) block.for_each(path, read);
}

/// All cases that the reader has lines of.
std::vector<Case> cases_of(LineReader reader, const std::string& path) {
  std::vector<Case> cases;
  const auto read = [&](std::string_view line, std::size_t number) {
    Case& c = cases.emplace_back();
    if (scan_case(line, c)) return;
    const Where where{path, number};
    c = to_case(parse_json_beyond(line, where), where);
  };
  for (LineBlock block; next_block(reader, block);) block.for_each(path, read);
  if (cases.empty()) throw bad_input(path, 0, "holds no cases, expected one JSON object a line");
  return cases;
}

/// A case whose numbers are not all finite has neither answer nor class.
void require_silence(const Json& object, const Where& where) {
  for (const char* key : {"expect", "class"}) {
    if (object.contains(key)) where.key(key).fail("given of a case with a number that is not finite, expected none");
  }
}

}  // namespace

Case to_case(const Json& object, const Where& where) {
  require_keys(object, {"id", "fmt", "seg", "ray", "tri", "rings", "expect", "class", "source", "finding"}, where);
  Case c;
  c.id = to_text(object, "id", where);
  c.format = to_format(object, where);
  c.query = {to_probe(object, c.format, where), to_target(object, c.format, where)};
  c.query.bounds = to_bounds(object, c.query, c.format, where);
  c.expect = to_expectation(object, where);
  c.class_id = to_class(object, where);
  if (object.contains("rings") && object.contains("class")) {
    where.key("class").fail("a case with \"rings\" has no class, expected none");
  }
  if (!is_finite(c.query)) require_silence(object, where);
  if (object.contains("source")) c.source = to_text(object, "source", where);
  if (object.contains("finding")) c.finding = object["finding"];
  return c;
}

Json from_case(const Case& c) {
  Json object;
  object["id"] = c.id;
  object["fmt"] = name_of(c.format);
  add_probe(object, c.query.probe);
  if (c.query.bounds) add_bounds(object, *c.query.bounds);
  std::visit([&](const auto& target) { add_target(object, target); }, c.query.target);
  if (c.expect) object["expect"] = *c.expect ? 1 : 0;
  if (c.class_id != 0) object["class"] = class_name(c.class_id);
  if (!c.source.empty()) object["source"] = c.source;
  if (!c.finding.is_null()) object["finding"] = c.finding;
  return object;
}

std::string case_line(const std::string& id, const Query& query) {
  return from_case({.id = id, .query = query}).dump();
}

void for_each_line(const std::string& path, const std::function<void(const Json& object, const Where& where)>& visit) {
  for_each_line_of(LineReader(bytes_of(path)), path, visit);
}

void for_each_line_in(std::string_view text, const std::string& path,
                      const std::function<void(const Json& object, const Where& where)>& visit) {
  for_each_line_of(LineReader(bytes_in(text)), path, visit);
}

std::vector<Case> cases_in(std::string_view text, const std::string& path) {
  return cases_of(LineReader(bytes_in(text)), path);
}

std::vector<Case> read_cases(const std::string& path) { return cases_of(LineReader(bytes_of(path)), path); }

Json from_answer(const Case& c, const Method& method, const Answer& answer) {
  Json object;
  object["id"] = c.id;
  object["method"] = method.name;
  const bool answered = answer.status == Status::ok;
  if (answered) object["hit"] = answer.hit ? 1 : 0;
  object["status"] = name_of(answer.status);
  if (is_fault(answer.status)) object["fault"] = fault_name(answer.status);
  if (is_fault(answer.status) && method.last_fault) object["detail"] = method.last_fault();
  if (answer.class_id != 0) object["class"] = class_name(answer.class_id);
  if (answered && answer.contact != Contact::unsaid) object["contact"] = name_of(answer.contact);
  if (answer.at != At::unsaid) object["at"] = name_of(answer.at);
  if (method.tells_side && answer.facing != Facing::unsaid) object["side"] = name_of(answer.facing);
  if (answer.stage != Stage::none) object["stage"] = name_of(answer.stage);
  const bool tells_planar = c.query.operands() == Operands::polygons && method.contract.polygons == Polygons::any;
  if (answered && tells_planar) object["planar"] = answer.planar;
  return object;
}

}  // namespace tribunal
