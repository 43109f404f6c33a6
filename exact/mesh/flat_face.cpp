#include "exact/mesh/flat_face.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>

#include "exact/kernels/dyadic.h"
#include "exact/kernels/product_sum.h"

namespace tribunal {
namespace {

using IndexRing = std::vector<std::uint32_t>;

/// The exponent of the greatest coordinate of the ring on each axis: each is below 2^e. 0 where all are zero.
std::array<int, 3> exponents(const IndexRing& ring, const std::vector<Point3>& points) {
  Point3 greatest(0);
  for (const std::uint32_t i : ring) greatest = glm::max(greatest, glm::abs(points[i]));
  std::array<int, 3> e{};
  for (int axis = 0; axis < 3; ++axis) std::frexp(greatest[axis], &e[static_cast<std::size_t>(axis)]);
  return e;
}

/// A positive number m·2^e that no exponent is too great for, or zero.
struct Size {
  int e;
  double m;

  friend auto operator<=>(const Size&, const Size&) = default;
};

/// How great the ring's area is along each axis, rounded.
std::array<Size, 3> areas(const IndexRing& ring, const std::vector<Point3>& points) {
  const std::array<int, 3> e = exponents(ring, points);
  const auto unit = [&](std::uint32_t i) {
    const Point3& p = points[i];
    return Point3(std::ldexp(p.x, -e[0]), std::ldexp(p.y, -e[1]), std::ldexp(p.z, -e[2]));
  };
  Point3 sum(0);
  const Point3 o = unit(ring[0]);
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += glm::cross(unit(ring[i]) - o, unit(ring[i + 1]) - o);
  std::array<Size, 3> sizes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    int exponent = 0;
    const double m = std::frexp(std::fabs(sum[static_cast<int>(axis)]), &exponent);
    sizes[axis] =
        m > 0 ? Size{exponent + e[(axis + 1) % 3] + e[(axis + 2) % 3], m} : Size{std::numeric_limits<int>::min(), 0};
  }
  return sizes;
}

/// The two axes that are kept.
struct View {
  int u, v;

  Point3 operator()(const Point3& p) const { return {p[u], p[v], 0.0}; }
};

/// Which way the ring runs in the view, by its exact area.
Sign direction(const IndexRing& ring, const std::vector<Point3>& points, const View& view) {
  Dyadic area;
  Dyadic u(points[ring.back()][view.u]), v(points[ring.back()][view.v]);
  for (const std::uint32_t i : ring) {
    Dyadic next_u(points[i][view.u]), next_v(points[i][view.v]);
    area = area + (u * next_v - v * next_u);
    u = std::move(next_u);
    v = std::move(next_v);
  }
  return sign_of(area);
}

bool turns(const IndexRing& ring, const std::vector<Point3>& points, const View& view) {
  const auto at = [&](std::size_t i) { return view(points[ring[i % ring.size()]]); };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (ProductSumKernel().orient2d(Axis::z, at(i), at(i + 1), at(i + 2)) != Sign::zero) return true;
  }
  return false;
}

/// The view along the axis in which the outer ring has the most area, from the side where it runs counter-clockwise;
/// if it has none, one in which a ring turns somewhere. If the face is planar, all such views show the same face.
View best_view(const Rings& face, const std::vector<Point3>& points) {
  const auto sizes = areas(face[0], points);
  std::array<int, 3> axes = {0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) {
    return sizes[static_cast<std::size_t>(a)] > sizes[static_cast<std::size_t>(b)];
  });
  const auto along = [](int axis) { return View{(axis + 1) % 3, (axis + 2) % 3}; };
  for (const int axis : axes) {
    const View view = along(axis);
    const Sign turn = direction(face[0], points, view);
    if (turn == Sign::positive) return view;
    if (turn == Sign::negative) return View{view.v, view.u};
  }
  const auto found = std::ranges::find_if(axes, [&](int axis) {
    return std::ranges::any_of(face, [&](const IndexRing& ring) { return turns(ring, points, along(axis)); });
  });
  return along(found == axes.end() ? axes[0] : *found);
}

/// All corners of the rings, one ring after the other.
std::vector<std::uint32_t> corners_of(const Rings& face) {
  std::vector<std::uint32_t> corners;
  for (const IndexRing& ring : face) corners.insert(corners.end(), ring.begin(), ring.end());
  return corners;
}

bool is_left_of(const Point3& a, const Point3& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// Numbers the places, and returns the place of each corner.
std::vector<std::uint32_t> number_places(const std::vector<std::uint32_t>& corners, const std::vector<Point3>& points,
                                         const View& view, FlatFace& flat) {
  std::vector<Point3> seen(corners.size());
  std::ranges::transform(corners, seen.begin(), [&](std::uint32_t i) { return view(points[i]); });
  std::vector<std::uint32_t> order(corners.size()), place(corners.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    return is_left_of(seen[a], seen[b]) || (!is_left_of(seen[b], seen[a]) && a < b);
  });
  for (const std::uint32_t i : order) {
    if (flat.places.empty() || is_left_of(flat.places.back(), seen[i])) {
      flat.places.push_back(seen[i]);
      flat.corners.push_back(corners[i]);
    }
    place[i] = static_cast<std::uint32_t>(flat.places.size() - 1);
  }
  return place;
}

}  // namespace

FlatFace flattened(const Rings& face, const std::vector<Point3>& points) {
  const View view = best_view(face, points);
  FlatFace flat;
  const std::vector<std::uint32_t> place = number_places(corners_of(face), points, view, flat);
  std::size_t first = 0;
  for (const IndexRing& ring : face) {
    const bool reversed = &ring != &face[0] && direction(ring, points, view) == Sign::positive;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      std::uint32_t from = place[first + i], to = place[first + (i + 1) % ring.size()];
      if (reversed) std::swap(from, to);
      if (from != to) flat.edges.push_back({from, to});
    }
    first += ring.size();
  }
  return flat;
}

}  // namespace tribunal
