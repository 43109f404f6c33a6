// Polygons triangulated by CGAL. The triangle tests run without the checks of their preconditions: all triangles of
// such a triangulation have area, and benchmark segments have length.
#define CGAL_NDEBUG
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/intersections.h>

#include <deque>
#include <map>

#include "exact/filtered/filtered_kernel.h"
#include "tests/bench/polygon/polygon_peers.h"

namespace tribunal::bench {
namespace {

using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<const Point3*, K>;
using Cells = CGAL::Triangulation_data_structure_2<VertexBase, CGAL::Constrained_triangulation_face_base_2<K>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<K, Cells, CGAL::No_constraint_intersection_tag>;
using Face = Triangulation::Face_handle;

K::Point_3 in_space(const Point3& p) { return {p.x, p.y, p.z}; }

/// Dropping a coordinate is exact, and one-to-one along the plane's axis.
K::Point_2 in_plane(const Point3& p, Axis dropped) {
  const Vec2<double> x = project(lift<double>(p), dropped);
  return {x.u, x.v};
}

/// The constrained triangulation with all ring edges as constraints.
Triangulation triangulate(const Polygon& polygon, Axis dropped) {
  Triangulation t;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    std::vector<Triangulation::Vertex_handle> ring;
    for (const Point3& v : polygon.ring(r)) {
      ring.push_back(t.insert(in_plane(v, dropped)));
      ring.back()->info() = &v;
    }
    for (std::size_t i = 0; i < ring.size(); ++i) t.insert_constraint(ring[i], ring[(i + 1) % ring.size()]);
  }
  return t;
}

/// The faces inside by the even–odd rule: those separated from the infinite face by an odd number of ring edges.
std::vector<Face> inner_faces(const Triangulation& t) {
  std::map<Face, bool> inside{{t.infinite_face(), false}};
  std::deque<Face> waiting{t.infinite_face()};
  std::vector<Face> found;
  for (; !waiting.empty(); waiting.pop_front()) {
    const Face f = waiting.front();
    if (inside[f]) found.push_back(f);
    for (int i = 0; i < 3; ++i) {
      const Face next = f->neighbor(i);
      if (inside.emplace(next, inside[f] != f->is_constrained(i)).second) waiting.push_back(next);
    }
  }
  return found;
}

}  // namespace

struct TriangulatedPolygon::Triangles {
  std::vector<K::Triangle_3> all;
};

TriangulatedPolygon::TriangulatedPolygon(const Polygon& polygon) {
  const Triangulation t = triangulate(polygon, spanned_plane(polygon, FilteredKernel()).value().dropped);
  Triangles triangles;
  for (const Face& f : inner_faces(t)) {
    triangles.all.emplace_back(in_space(*f->vertex(0)->info()), in_space(*f->vertex(1)->info()),
                               in_space(*f->vertex(2)->info()));
  }
  triangles_ = std::make_unique<const Triangles>(std::move(triangles));
}

TriangulatedPolygon::TriangulatedPolygon(TriangulatedPolygon&&) noexcept = default;
TriangulatedPolygon::~TriangulatedPolygon() = default;

std::size_t TriangulatedPolygon::triangles() const { return triangles_->all.size(); }

bool TriangulatedPolygon::meets(const Segment& s) const {
  const K::Segment_3 segment(in_space(s.p), in_space(s.q));
  for (const K::Triangle_3& t : triangles_->all) {
    if (CGAL::do_intersect(segment, t)) return true;
  }
  return false;
}

}  // namespace tribunal::bench
