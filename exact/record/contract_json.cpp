#include "exact/record/contract_json.h"

#include <algorithm>
#include <array>

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
void read(const Record& object, const char* key, const std::array<T, n>& values, T& value) {
  const std::string word = object.text(key);
  for (const T v : values) {
    if (word == name_of(v)) {
      value = v;
      return;
    }
  }
  object.fail_at(key, "no word of a contract: " + object.member(key).json().dump());
}

/// The same for a key that may be missing.
template <class T, std::size_t n>
void read_if_given(const Record& object, const char* key, const std::array<T, n>& values, T& value) {
  if (object.has(key)) read(object, key, values, value);
}

Json from_probes(const Probes& probes) {
  Json names = Json::array();
  if (probes.segments) names.push_back("segment");
  if (probes.rays) names.push_back("ray");
  if (probes.bounds) names.push_back("bounded ray");
  return names;
}

Probes to_probes(const Record& names) {
  Probes probes{.segments = false, .rays = false, .bounds = false};
  for (const Record& name : names.items()) {
    bool& given =
        *one_of<bool*>(name, {{"segment", &probes.segments}, {"ray", &probes.rays}, {"bounded ray", &probes.bounds}});
    if (given) name.fail("named twice");
    given = true;
  }
  return probes;
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

Contract to_contract(const Record& terms) {
  terms.keys({"probes", "triangles", "polygons", "coplanar", "boundary", "polygon_boundary", "ends", "bounds",
              "culling", "fmt", "exact"});
  Contract c;
  c.probes = to_probes(terms.member("probes"));
  read(terms, "triangles", all_triangles, c.triangles);
  read(terms, "polygons", all_polygons, c.polygons);
  read(terms, "coplanar", conventions, c.convention);
  read(terms, "boundary", boundaries, c.boundary);
  read(terms, "polygon_boundary", boundaries, c.polygon_boundary);
  read(terms, "ends", all_ends, c.ends);
  read_if_given(terms, "bounds", all_ends, c.bounds);  // older logs have none
  read(terms, "culling", cullings, c.culling);
  read(terms, "fmt", formats, c.format);
  c.exact = terms.truth("exact");
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

Contract readings_in(const Record& finding) {
  Contract c{.probes = {.segments = true, .rays = true, .bounds = true}, .polygons = Polygons::any};
  read_if_given(finding, "convention", conventions, c.convention);
  const std::optional<Record> readings = finding.find("readings");
  if (!readings) return c;
  readings->keys({"boundary", "polygon_boundary", "ends", "bounds", "culling"});
  read_if_given(*readings, "boundary", boundaries, c.boundary);
  read_if_given(*readings, "polygon_boundary", boundaries, c.polygon_boundary);
  read_if_given(*readings, "ends", all_ends, c.ends);
  read_if_given(*readings, "bounds", all_ends, c.bounds);
  read_if_given(*readings, "culling", cullings, c.culling);
  return c;
}

}  // namespace tribunal
