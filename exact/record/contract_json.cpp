#include "exact/record/contract_json.h"

#include <algorithm>
#include <array>

#include "exact/base/json.h"

namespace tribunal {
namespace {

constexpr std::array conventions = {Convention::closed, Convention::transversal, Convention::unspecified};
constexpr std::array all_triangles = {Triangles::none, Triangles::any, Triangles::proper};
constexpr std::array all_polygons = {Polygons::none, Polygons::any, Polygons::planar};
constexpr std::array boundaries = {Boundary::closed, Boundary::open, Boundary::half_open, Boundary::unspecified};
constexpr std::array all_ends = {Ends::closed, Ends::open, Ends::unspecified};
constexpr std::array cullings = {Culling::none, Culling::back_faces};
constexpr std::array formats = {Format::binary32, Format::binary64};

/// Sets `value` to the one that the word at the key names.
template <class T, std::size_t n>
void read(const Json& object, const char* key, const std::array<T, n>& values, const Where& where, T& value) {
  const Json& word = require(object, key, where);
  for (const T v : values) {
    if (word == name_of(v)) {
      value = v;
      return;
    }
  }
  where.key(key).fail("no word of a contract: " + word.dump());
}

/// The same for a key that may be missing.
template <class T, std::size_t n>
void read_if_given(const Json& object, const char* key, const std::array<T, n>& values, const Where& where, T& value) {
  if (object.contains(key)) read(object, key, values, where, value);
}

Json from_probes(const Probes& probes) {
  Json names = Json::array();
  if (probes.segments) names.push_back("segment");
  if (probes.rays) names.push_back("ray");
  if (probes.bounds) names.push_back("bounded ray");
  return names;
}

Probes to_probes(const Json& names, const Where& where) {
  const auto has = [&](const char* name) { return std::ranges::find(names, Json(name)) != names.end(); };
  if (!names.is_array() || names.size() != static_cast<std::size_t>(has("segment") + has("ray") + has("bounded ray"))) {
    where.fail("expected a list of \"segment\", \"ray\" and \"bounded ray\"");
  }
  return {.segments = has("segment"), .rays = has("ray"), .bounds = has("bounded ray")};
}

}  // namespace

Json from_contract(const Contract& c) {
  return {{"probes", from_probes(c.probes)},
          {"triangles", name_of(c.triangles)},
          {"polygons", name_of(c.polygons)},
          {"coplanar", name_of(c.convention)},
          {"boundary", name_of(c.boundary)},
          {"polygon_boundary", name_of(c.polygon_boundary)},
          {"ends", name_of(c.ends)},
          {"bounds", name_of(c.bounds)},
          {"culling", name_of(c.culling)},
          {"fmt", name_of(c.format)},
          {"exact", c.exact}};
}

Json methods_json(std::span<const Method> methods) {
  Json rows = Json::array();
  for (const Method& m : methods) {
    rows.push_back({{"name", m.name},
                    {"number", m.card.number},
                    {"fmt", name_of(m.contract.format)},
                    {"convention", name_of(m.contract.convention)},
                    {"exact", m.contract.exact}});
  }
  return rows;
}

Contract to_contract(const Json& object, const Where& where) {
  if (!object.is_object()) where.fail("expected an object");
  Contract c;
  c.probes = to_probes(require(object, "probes", where), where.key("probes"));
  read(object, "triangles", all_triangles, where, c.triangles);
  read(object, "polygons", all_polygons, where, c.polygons);
  read(object, "coplanar", conventions, where, c.convention);
  read(object, "boundary", boundaries, where, c.boundary);
  read(object, "polygon_boundary", boundaries, where, c.polygon_boundary);
  read(object, "ends", all_ends, where, c.ends);
  read_if_given(object, "bounds", all_ends, where, c.bounds);  // older logs have none
  read(object, "culling", cullings, where, c.culling);
  read(object, "fmt", formats, where, c.format);
  const Json& exact = require(object, "exact", where);
  if (!exact.is_boolean()) where.key("exact").fail("expected true or false");
  c.exact = exact;
  return c;
}

void add_readings(Json& finding, const Contract& c) {
  finding["convention"] = name_of(c.convention);
  const Contract usual;
  Json readings = Json::object();
  if (c.boundary != usual.boundary) readings["boundary"] = name_of(c.boundary);
  if (c.polygon_boundary != usual.polygon_boundary) readings["polygon_boundary"] = name_of(c.polygon_boundary);
  if (c.ends != usual.ends) readings["ends"] = name_of(c.ends);
  if (c.bounds != usual.bounds) readings["bounds"] = name_of(c.bounds);
  if (c.culling != usual.culling) readings["culling"] = name_of(c.culling);
  if (!readings.empty()) finding["readings"] = readings;
}

Contract readings_in(const Json& finding, const Where& where) {
  Contract c{.probes = {.segments = true, .rays = true, .bounds = true}, .polygons = Polygons::any};
  read_if_given(finding, "convention", conventions, where, c.convention);
  if (!finding.contains("readings")) return c;
  const Json& readings = finding["readings"];
  read_if_given(readings, "boundary", boundaries, where.key("readings"), c.boundary);
  read_if_given(readings, "polygon_boundary", boundaries, where.key("readings"), c.polygon_boundary);
  read_if_given(readings, "ends", all_ends, where.key("readings"), c.ends);
  read_if_given(readings, "bounds", all_ends, where.key("readings"), c.bounds);
  read_if_given(readings, "culling", cullings, where.key("readings"), c.culling);
  return c;
}

}  // namespace tribunal
