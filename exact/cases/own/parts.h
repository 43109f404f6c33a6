// The points and edges of a question, to be looked at and changed in place.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "exact/cases/polygon_families/vectors.h"

namespace tribunal {

/// The vertices of a target, ring after ring, and its edges as pairs of vertices. The query must outlive it.
class Parts {
 public:
  using Edge = std::array<std::size_t, 2>;

  explicit Parts(Query& query) {
    if (query.operands() == Operands::triangles) {
      Triangle& t = query.triangle();
      vertices_ = {&t.a, &t.b, &t.c};
      edges_ = {{0, 1}, {1, 2}, {2, 0}};
    } else {
      add(query.polygon());
    }
    probe_ = vectors_of(query.probe);
    is_ray_ = is_of_ray(query);
  }

  const std::vector<Point3*>& vertices() const { return vertices_; }
  const std::vector<Edge>& edges() const { return edges_; }
  Point3& vertex(std::size_t i) const { return *vertices_[i]; }
  Point3& source() const { return *probe_[0]; }
  Point3& target() const { return *probe_[1]; }  ///< of a ray, its direction

  /// All vectors but the direction of a ray.
  std::vector<Point3*> points() const {
    std::vector<Point3*> all = vertices_;
    all.push_back(probe_[0]);
    if (!is_ray_) all.push_back(probe_[1]);
    return all;
  }

  /// All vectors.
  std::vector<Point3*> vectors() const {
    std::vector<Point3*> all = vertices_;
    all.insert(all.end(), probe_.begin(), probe_.end());
    return all;
  }

 private:
  void add(PolygonData& polygon) {
    for (Point3& v : polygon.vertices) vertices_.push_back(&v);
    std::size_t begin = 0;
    for (const std::size_t end : polygon.ends) {
      for (std::size_t i = begin; i < end; ++i) edges_.push_back({i, i + 1 < end ? i + 1 : begin});
      begin = end;
    }
  }

  std::vector<Point3*> vertices_;
  std::vector<Edge> edges_;
  std::array<Point3*, 2> probe_{};
  bool is_ray_ = false;
};

}  // namespace tribunal
