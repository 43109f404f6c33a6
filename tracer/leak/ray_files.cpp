#include "tracer/leak/ray_files.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <unordered_map>

#include "exact/base/failure.h"
#include "exact/base/foreign_json.h"
#include "exact/base/record.h"
#include "exact/base/shown.h"
#include "exact/cases/case_io.h"

namespace tribunal::leak {
namespace {

std::string text_at(const Json& object, const char* key, const Where& where) { return Record(object, where).name(key); }

/// "vertex 12", as in the findings of a trial.
void read_aim(const std::string& text, AimedRay& aimed, const Where& where) {
  const std::size_t space = text.find(' ');
  const std::string number = space == std::string::npos ? "" : text.substr(space + 1);
  for (const Aim a : all_aims) {
    const bool digits =
        !number.empty() && number.size() < 10 && number.find_first_not_of("0123456789") == std::string::npos;
    if (!digits || text.substr(0, space) != name_of(a)) continue;
    aimed.aim = a;
    aimed.at = static_cast<std::uint32_t>(std::stoul(number));
    return;
  }
  where.fail("expected \"vertex\", \"edge\" or \"face\" and a number, found \"" + text + "\"");
}

Format format_of(const Json& object, const Where& where) {
  if (!object.contains("fmt")) return Format::binary64;
  for (const Format f : {Format::binary64, Format::binary32}) {
    if (object["fmt"] == name_of(f)) return f;
  }
  where.key("fmt").fail("expected \"binary64\" or \"binary32\"");
}

AimedRay to_ray(const Json& object, Format format, const Where& where) {
  const Json& ray = require(object, "ray", where);
  require_keys(ray, {"o", "d"}, where.key("ray"));
  AimedRay aimed{{to_point(require(ray, "o", where.key("ray")), format, where.key("ray").key("o")),
                  {to_point(require(ray, "d", where.key("ray")), format, where.key("ray").key("d"))}},
                 Aim::unsaid,
                 0};
  if (aimed.ray.d.v == Point3(0)) where.key("ray").key("d").fail("expected a direction that is not 0");
  if (object.contains("aimed_at")) read_aim(text_at(object, "aimed_at", where), aimed, where.key("aimed_at"));
  return aimed;
}

// --- answers ---------------------------------------------------------------------------------------------------------

/// What a method may be asked of a ray, as the keys of an answer name it.
enum class Kind : std::uint8_t { closest, any, all, inside };
constexpr std::array<const char*, 4> kind_names = {"closest", "any", "all", "inside"};

/// A number, finite or not: what a test computed.
double computed_number(const Json& value, const Where& where) { return to_any_number(value, Format::binary64, where); }

Point3 computed_point(const Json& value, const Where& where) {
  if (!value.is_array() || value.size() != 3) where.fail("expected three numbers");
  Point3 p;
  for (int i = 0; i < 3; ++i) p[i] = computed_number(value[static_cast<std::size_t>(i)], where);
  return p;
}

bool to_bool(const Json& value, const Where& where) {
  if (value != 0 && value != 1) where.fail("expected 0 or 1, found " + value.dump());
  return value == 1;
}

Reported to_reported(const Json& value, const Surface& surface, const Where& where) {
  require_keys(value, {"face", "t", "normal", "side"}, where);
  Reported reported{static_cast<std::uint32_t>(Record(value, where).count("face", surface.face_count() - 1))};
  if (value.contains("t")) reported.t = computed_number(value["t"], where.key("t"));
  if (value.contains("normal")) reported.normal = computed_point(value["normal"], where.key("normal"));
  if (!value.contains("side")) return reported;
  const std::string side = text_at(value, "side", where);
  if (side != "front" && side != "back")
    where.key("side").fail("expected \"front\" or \"back\", found \"" + side + "\"");
  reported.side = side == "front" ? Facing::front : Facing::back;
  return reported;
}

std::vector<Reported> to_list(const Json& value, const Surface& surface, const Where& where) {
  if (!value.is_array()) where.fail("expected an array of hits");
  std::vector<Reported> list;
  for (const Json& hit : value) list.push_back(to_reported(hit, surface, where));
  return list;
}

void read_kind(Kind kind, const Json& value, const Surface& surface, const Where& where, Testimony& said) {
  switch (kind) {
    case Kind::closest:
      said.closest = value.is_null() ? std::nullopt : std::optional(to_reported(value, surface, where));
      return;
    case Kind::any:
      said.any = to_bool(value, where);
      return;
    case Kind::all:
      said.hits = to_list(value, surface, where);
      return;
    case Kind::inside:
      said.inside = to_bool(value, where);
  }
}

Fault to_fault(const Json& object, const Where& where) {
  if (text_at(object, "status", where) != "failed") where.key("status").fail("expected \"failed\"");
  Fault fault{Status::gave_no_answer};
  if (object.contains("fault")) fault.kind = fault_named(text_at(object, "fault", where));
  if (!is_fault(fault.kind)) where.key("fault").fail("expected one that docs/formats.md lists");
  if (object.contains("detail")) fault.detail = shown(text_at(object, "detail", where));
  return fault;
}

/// All answers of one method, by ray.
struct Sheet {
  std::string method;
  std::vector<std::optional<Testimony>> said;
  std::array<bool, kind_names.size()> gives{};
  bool gives_t = false, gives_normals = false;
};

bool has(const Testimony& said, Kind kind) {
  switch (kind) {
    case Kind::closest:
      return said.closest.has_value();
    case Kind::any:
      return said.any.has_value();
    case Kind::all:
      return said.hits.has_value();
    case Kind::inside:
      return said.inside.has_value();
  }
  return false;
}

/// The part of an answer that is of one kind.
Testimony part_of(const Testimony& said, Kind kind) {
  Testimony part{.fault = said.fault};
  if (said.fault) return part;
  if (kind == Kind::closest) part.closest = said.closest;
  if (kind == Kind::any) part.any = said.any;
  if (kind == Kind::all) part.hits = said.hits;
  if (kind == Kind::inside) part.inside = said.inside;
  return part;
}

class Sheets {
 public:
  Sheets(const RayFile& rays, const Surface& surface) : rays_(rays), surface_(surface) {
    for (std::size_t i = 0; i < rays.ids.size(); ++i) places_.emplace(rays.ids[i], i);
  }

  void add(const Json& object, const Where& where) {
    require_keys(object, {"id", "method", "closest", "any", "all", "inside", "status", "fault", "detail"}, where);
    const std::string id = text_at(object, "id", where);
    const auto place = places_.find(id);
    if (place == places_.end()) where.fail("answers \"" + id + "\", which is no ray's id");
    Sheet& sheet = sheet_of(object.contains("method") ? name_at(object, "method", where) : "answers");
    if (sheet.said[place->second])
      where.fail("a second answer of " + sheet.method + " to \"" + id + "\", expected one");
    sheet.said[place->second] = testimony(object, sheet, where);
  }

  const std::vector<Sheet>& complete(const std::string& path) const {
    if (sheets_.empty()) throw bad_input(path, 0, "holds no answers, expected one JSON object a line");
    for (const Sheet& s : sheets_) require_all(s, path);
    return sheets_;
  }

 private:
  Sheet& sheet_of(const std::string& method) {
    for (Sheet& s : sheets_) {
      if (s.method == method) return s;
    }
    return sheets_.emplace_back(Sheet{method, std::vector<std::optional<Testimony>>(rays_.ids.size())});
  }

  Testimony testimony(const Json& object, Sheet& sheet, const Where& where) const {
    Testimony said;
    bool gives_any = false;
    for (std::size_t kind = 0; kind < kind_names.size(); ++kind) {
      if (!object.contains(kind_names[kind])) continue;
      read_kind(static_cast<Kind>(kind), object[kind_names[kind]], surface_, where.key(kind_names[kind]), said);
      sheet.gives[kind] = gives_any = true;
    }
    if (object.contains("status")) {
      if (gives_any) where.fail("has an answer and a status, expected one of them");
      said.fault = to_fault(object, where);
    } else if (!gives_any) {
      where.fail("expected \"closest\", \"any\", \"all\" or \"inside\"");
    }
    if (said.closest && *said.closest) sheet.gives_normals |= (*said.closest)->normal || (*said.closest)->side;
    return said;
  }

  void require_all(const Sheet& sheet, const std::string& path) const {
    if (sheet.gives == std::array<bool, kind_names.size()>{}) {
      throw bad_input(path, 0, "every answer of " + sheet.method + " is a failure, nothing to judge");
    }
    for (std::size_t kind = 0; kind < kind_names.size(); ++kind) {
      std::size_t missing = 0, first = 0;
      for (std::size_t i = 0; i < sheet.said.size() && sheet.gives[kind]; ++i) {
        const bool there = sheet.said[i] && (sheet.said[i]->fault || has(*sheet.said[i], static_cast<Kind>(kind)));
        if (!there && missing++ == 0) first = i;
      }
      if (missing == 0) continue;
      throw bad_input(path, 0,
                      std::to_string(missing) + " of " + std::to_string(sheet.said.size()) + " answers of " +
                          sheet.method + " are missing or lack \"" + kind_names[kind] + "\", the first to \"" +
                          rays_.ids[first] + "\"");
    }
  }

  const RayFile& rays_;
  const Surface& surface_;
  std::unordered_map<std::string, std::size_t> places_{};
  std::vector<Sheet> sheets_{};
};

Subject subject_of(const Sheet& sheet, Kind kind, const Promises& promises) {
  const auto answers = std::make_shared<std::vector<Testimony>>();
  for (const auto& said : sheet.said) answers->push_back(part_of(*said, kind));
  const bool closest = kind == Kind::closest, inside = kind == Kind::inside;
  return {.name = sheet.method + "/" + kind_names[static_cast<std::size_t>(kind)],
          .contract = promises.contract,
          .told = "answers from a file",
          .tells_hits = !inside,
          .tells_parity = inside,
          .tells_closest = closest,
          .sorted = kind == Kind::all && promises.sorted,
          .parity_where_touching = inside,
          .tells_normals = closest && sheet.gives_normals,
          .sense = promises.sense,
          .most_ulps = closest ? promises.most_ulps : 0,
          .most_degrees = closest ? promises.most_degrees : 0,
          .ask = [answers](std::span<const AskedRay> asked, std::span<Testimony> said) {
            for (std::size_t i = 0; i < asked.size(); ++i) said[i] = (*answers)[asked[i].k];
          }};
}

}  // namespace

std::string to_off(const Surface& surface) {
  std::string text =
      "OFF\n" + std::to_string(surface.vertices().size()) + " " + std::to_string(surface.face_count()) + " 0\n";
  char line[200];
  for (const Point3& p : surface.vertices()) {
    std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", p.x, p.y, p.z);
    text += line;
  }
  for (std::uint32_t f = 0; f < surface.face_count(); ++f) {
    const auto& c = surface.corners(f);
    std::snprintf(line, sizeof line, "3 %u %u %u\n", c[0], c[1], c[2]);
    text += line;
  }
  return text;
}

std::string to_line(const Surface& surface, const AimedRay& aimed, std::uint64_t k) {
  Json object = {{"id", std::to_string(k)},
                 {"fmt", name_of(surface.format())},
                 {"ray", {{"o", from_point(aimed.ray.o)}, {"d", from_point(aimed.ray.d.v)}}}};
  if (aimed.aim != Aim::unsaid) object["aimed_at"] = std::string(name_of(aimed.aim)) + " " + std::to_string(aimed.at);
  return object.dump() + "\n";
}

RayFile read_rays(const std::string& path) {
  RayFile file;
  std::unordered_map<std::string, std::size_t> lines;
  for_each_line(path, [&](const Json& object, const Where& where) {
    require_keys(object, {"id", "fmt", "ray", "aimed_at"}, where);
    const std::string id = text_at(object, "id", where);
    const auto [first, fresh] = lines.emplace(id, where.line);
    if (!fresh) where.fail("id \"" + id + "\" again, it was on line " + std::to_string(first->second));
    const Format format = format_of(object, where);
    if (file.ids.empty()) file.format = format;
    if (format != file.format) where.key("fmt").fail("expected " + std::string(name_of(file.format)) + ", as before");
    file.ids.push_back(id);
    file.rays.push_back(to_ray(object, format, where));
  });
  if (file.rays.empty()) throw bad_input(path, 0, "holds no rays, expected one JSON object a line");
  return file;
}

std::vector<Subject> subjects_in(const std::string& path, const RayFile& rays, const Surface& surface,
                                 const Promises& promises) {
  Sheets sheets(rays, surface);
  for_each_line(path, [&](const Json& object, const Where& where) { sheets.add(object, where); });
  std::vector<Subject> subjects;
  for (const Sheet& sheet : sheets.complete(path)) {
    for (const Kind kind : {Kind::closest, Kind::any, Kind::all, Kind::inside}) {
      const bool judged = kind != Kind::inside || surface.topology().closed();
      if (sheet.gives[static_cast<std::size_t>(kind)] && judged) subjects.push_back(subject_of(sheet, kind, promises));
    }
  }
  if (subjects.empty()) throw bad_input(path, 0, "answers \"inside\" alone, and the mesh is not closed");
  return subjects;
}

}  // namespace tribunal::leak
