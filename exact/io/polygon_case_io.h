// Cases with polygons ("rings"), alone or among cases with triangles, as docs/formats.md describes them.
#pragma once

#include <variant>

#include "exact/io/case_io.h"

namespace tribunal {

/// A polygon query with a name.
struct PolygonCase {
  std::string id{};
  Format format = Format::binary64;
  PolygonQuery query{};
  std::optional<bool> expect{};
  std::string source{};
  Json finding{};
};

using AnyCase = std::variant<Case, PolygonCase>;

/// "rings": at least one ring, each of at least one vertex.
PolygonData to_polygon(const Json& rings, Format format, const Where& where);

Json from_polygon(const Polygon& polygon);

PolygonCase to_polygon_case(const Json& object, const Where& where);

Json from_case(const PolygonCase& c);

/// By its "rings" or "tri".
AnyCase to_any_case(const Json& object, const Where& where);

/// As read_cases, but with polygons too.
std::vector<AnyCase> read_any_cases(const std::string& path);

/// Every line must have "rings".
std::vector<PolygonCase> read_polygon_cases(const std::string& path);

/// With "planar".
Json from_answer(const std::string& id, const Method& method, const PolygonAnswer& answer);

}  // namespace tribunal
