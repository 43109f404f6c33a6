#include "exact/io/case_io.h"

#include <algorithm>
#include <utility>

#include "exact/classes/class_table.h"
#include "exact/io/failure.h"
#include "exact/io/files.h"

namespace tribunal {
namespace {

constexpr std::size_t max_line = std::size_t{1} << 20;

std::string to_text(const Json& object, const char* key, const Where& where) {
  const Json& value = require(object, key, where);
  if (!value.is_string()) where.key(key).fail("expected a string");
  return value.get<std::string>();
}

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
  for (std::size_t i = 0; i < N; ++i) points[i] = to_point(value[i], format, where.index(i));
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

Ray to_ray(const Json& value, Format format, const Where& where) {
  require_keys(value, {"o", "d"}, where);
  return {to_point(require(value, "o", where), format, where.key("o")),
          {to_point(require(value, "d", where), format, where.key("d"))}};
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

bool is_blank(std::string_view line) { return line.find_first_not_of(" \t\r") == std::string_view::npos; }

}  // namespace

CaseHead to_case_head(const Json& object, const Where& where) {
  CaseHead head;
  head.id = to_text(object, "id", where);
  head.format = to_format(object, where);
  head.probe = to_probe(object, head.format, where);
  head.expect = to_expectation(object, where);
  if (object.contains("source")) head.source = to_text(object, "source", where);
  if (object.contains("finding")) head.finding = object["finding"];
  return head;
}

Case to_case(const Json& object, const Where& where) {
  require_keys(object, {"id", "fmt", "seg", "ray", "tri", "rings", "expect", "class", "source", "finding"}, where);
  if (object.contains("rings"))
    where.key("rings").fail("triangles are certified apart from polygons, expected \"tri\", or --polygons");
  CaseHead head = to_case_head(object, where);
  if (!object.contains("tri")) where.fail("missing \"tri\" or \"rings\"");
  const Triangle triangle = to_triangle(object["tri"], head.format, where.key("tri"));
  return {.id = std::move(head.id),
          .format = head.format,
          .query = {head.probe, triangle},
          .expect = head.expect,
          .class_id = to_class(object, where),
          .source = std::move(head.source),
          .finding = std::move(head.finding)};
}

void add_probe(Json& object, const Probe& probe) {
  if (const auto* s = std::get_if<Segment>(&probe)) {
    object["seg"] = {from_point(s->p), from_point(s->q)};
  } else {
    const Ray& r = std::get<Ray>(probe);
    object["ray"] = {{"o", from_point(r.o)}, {"d", from_point(r.d.v)}};
  }
}

Json from_case(const Case& c) {
  Json object;
  object["id"] = c.id;
  object["fmt"] = name_of(c.format);
  add_probe(object, c.query.probe);
  const Triangle& t = c.query.triangle;
  object["tri"] = {from_point(t.a), from_point(t.b), from_point(t.c)};
  if (c.expect) object["expect"] = *c.expect ? 1 : 0;
  if (c.class_id != 0) object["class"] = class_name(c.class_id);
  if (!c.source.empty()) object["source"] = c.source;
  if (!c.finding.is_null()) object["finding"] = c.finding;
  return object;
}

void for_each_line(const std::string& path, const std::function<void(const Json& object, const Where& where)>& visit) {
  const std::string text = read_file(path);
  std::size_t line_number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line(text.data() + begin, end - begin);
    begin = end + 1;
    const Where where{path, ++line_number};
    if (is_blank(line)) continue;
    if (line.size() > max_line) where.fail("line longer than 1 MiB, expected one JSON object");
    visit(parse_json(line, where), where);
  }
}

std::vector<Case> read_cases(const std::string& path) {
  std::vector<Case> cases;
  for_each_line(path, [&](const Json& object, const Where& where) { cases.push_back(to_case(object, where)); });
  if (cases.empty()) throw bad_input(path, 0, "holds no cases, expected one JSON object a line");
  return cases;
}

Json from_answer(const std::string& id, const Method& method, const Answer& answer) {
  Json object;
  object["id"] = id;
  object["method"] = method.name;
  if (answer.status == Status::ok) object["hit"] = answer.hit ? 1 : 0;
  object["status"] = name_of(answer.status);
  if (is_fault(answer.status)) object["fault"] = fault_name(answer.status);
  if (is_fault(answer.status) && method.last_fault) object["detail"] = method.last_fault();
  if (answer.class_id != 0) object["class"] = class_name(answer.class_id);
  if (answer.status == Status::ok && answer.contact != Contact::unsaid) object["contact"] = name_of(answer.contact);
  if (answer.at != At::unsaid) object["at"] = name_of(answer.at);
  if (answer.stage != Stage::none) object["stage"] = name_of(answer.stage);
  return object;
}

}  // namespace tribunal
