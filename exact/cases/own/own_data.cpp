#include "exact/cases/own/own_data.h"

#include <algorithm>

#include "exact/base/failure.h"
#include "exact/base/files.h"
#include "exact/base/sha256.h"
#include "exact/cases/case_io.h"
#include "exact/mesh/read_mesh.h"
#include "exact/mesh/triangulate.h"

namespace tribunal {
namespace {

const char* name_of(Operands operands) { return operands == Operands::triangles ? "triangles" : "polygons"; }

Operands operands_of(const std::vector<Case>& cases) {
  const bool triangles =
      std::ranges::any_of(cases, [](const Case& c) { return c.query.operands() == Operands::triangles; });
  return triangles ? Operands::triangles : Operands::polygons;
}

}  // namespace

OwnData read_own_cases(const std::string& file, std::optional<Operands> wanted) {
  const std::string bytes = read_file(file);
  const std::vector<Case> cases = cases_in(bytes, file);
  const Operands operands = wanted.value_or(operands_of(cases));
  OwnData data{.kind = OwnKind::cases, .file = file, .sha256 = sha256(bytes)};
  for (const Case& c : cases) {
    if (c.query.operands() != operands) {
      ++data.other_operands;
    } else if (!is_finite(c.query)) {
      ++data.nonfinite;
    } else {
      data.queries.push_back({c.query, c.format});
    }
  }
  if (data.queries.empty()) {
    throw bad_input(file, 0, std::string("holds no case about ") + name_of(operands) + " with finite numbers");
  }
  return data;
}

OwnData read_own_mesh(const std::string& file) {
  const std::string bytes = read_file(file);
  const Mesh mesh = triangulated(mesh_of(read_soup(file, bytes)), file);
  OwnData data{.kind = OwnKind::mesh, .file = file, .sha256 = sha256(bytes)};
  data.triangles.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) data.triangles.push_back(mesh.triangle(i));
  if (data.triangles.empty()) throw bad_input(file, 0, "holds no faces");
  return data;
}

}  // namespace tribunal
