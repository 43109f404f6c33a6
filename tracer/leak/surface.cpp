#include "tracer/leak/surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/base/failure.h"
#include "exact/filtered/filtered_kernel.h"
#include "exact/mesh/merged_points.h"

namespace tribunal::leak {
namespace {

bool has_no_area(const Triangle& t) {
  const FilteredKernel k;
  return std::ranges::all_of(all_axes, [&](Axis dropped) { return k.orient2d(dropped, t.a, t.b, t.c) == Sign::zero; });
}

/// The margin of boxes: 2048 unit roundoffs of the largest number that occurs with rays from around the box. It only
/// selects the faces that subjects are asked about; the exact truth does not depend on it.
double margin_about(const Box& b, Format format) {
  double most = 0;
  for (int axis = 0; axis < 3; ++axis) most = std::max({most, std::abs(b.lo[axis]), std::abs(b.hi[axis])});
  return std::min(std::ldexp(most, format == Format::binary32 ? -13 : -42), std::numeric_limits<double>::max() / 4);
}

}  // namespace

Incidence::Incidence(std::size_t row_count, std::span<const std::uint32_t> rows, std::span<const std::uint32_t> values)
    : first_(row_count + 1), values_(values.size()) {
  for (const std::uint32_t row : rows) ++first_[row + 1];
  for (std::size_t row = 0; row < row_count; ++row) first_[row + 1] += first_[row];
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < rows.size(); ++i) values_[next[rows[i]]++] = values[i];
}

Surface::Surface(const Mesh& mesh, Format format, const std::string& file) : format_(format) {
  if (mesh.triangles.empty()) throw bad_input(file, 0, "holds no faces");
  add_faces(mesh, file);
  find_edges();
  mark_openings();
  topology_ = topology_of({vertices_, corners_});
  for (const Point3& p : vertices_) bounds_.add(p);
  boxes_ = FaceBoxes(triangles_, margin_about(bounds_, format));
  tree_ = TriangleTree(triangles_);
}

void Surface::add_faces(const Mesh& mesh, const std::string& file) {
  MergedPoints merged(vertices_);
  std::vector<std::uint32_t> rows, faces;
  for (const auto& t : mesh.triangles) {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point3 p = in_format(mesh.vertices[t[i]], format_);
      if (!is_finite(p)) throw bad_input(file, 0, "has a coordinate beyond " + std::string(name_of(format_)));
      corners[i] = merged.index_of(p);
      rows.push_back(corners[i]);
      faces.push_back(static_cast<std::uint32_t>(corners_.size()));
    }
    corners_.push_back(corners);
    triangles_.push_back({vertices_[corners[0]], vertices_[corners[1]], vertices_[corners[2]]});
    flat_.push_back(has_no_area(triangles_.back()));
  }
  of_vertex_ = Incidence(vertices_.size(), rows, faces);
}

void Surface::find_edges() {
  struct Use {
    Edge edge;
    std::uint32_t face;
  };
  std::vector<Use> uses;
  for (std::uint32_t f = 0; f < corners_.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(corners_[f][i], corners_[f][(i + 1) % 3]);
      if (low != high) uses.push_back({{low, high}, f});
    }
  }
  std::ranges::stable_sort(uses, {}, &Use::edge);
  std::vector<std::uint32_t> rows, faces;
  for (const Use& use : uses) {
    if (edges_.empty() || edges_.back() != use.edge) edges_.push_back(use.edge);
    rows.push_back(static_cast<std::uint32_t>(edges_.size() - 1));
    faces.push_back(use.face);
  }
  of_edge_ = Incidence(edges_.size(), rows, faces);
}

void Surface::mark_openings() {
  at_opening_.resize(vertices_.size());
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    if (of_edge_[e].size() % 2 == 0) continue;
    for (const std::uint32_t v : edges_[e]) at_opening_[v] = true;
  }
}

bool Surface::has_vertex(std::uint32_t face, std::uint32_t vertex) const {
  return std::ranges::find(corners_[face], vertex) != corners_[face].end();
}

bool Surface::share_vertex(std::uint32_t face, std::uint32_t other) const {
  return std::ranges::any_of(corners_[other], [&](std::uint32_t v) { return has_vertex(face, v); });
}

}  // namespace tribunal::leak
