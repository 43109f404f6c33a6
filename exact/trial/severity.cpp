#include "exact/trial/severity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/format.h"
#include "core/products.h"
#include "exact/cases/families/everyday.h"
#include "exact/trial/coverage.h"

namespace tribunal {
namespace {

using Vec = Vec3<double>;

double longest(const Vec& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }
double longest(const Point3& p) { return longest(lift<double>(p)); }

/// A box parallel to the axes around points, and their largest coordinate.
class Box {
 public:
  void add(const Point3& p) {
    lo_ = {std::min(lo_.x, p.x), std::min(lo_.y, p.y), std::min(lo_.z, p.z)};
    hi_ = {std::max(hi_.x, p.x), std::max(hi_.y, p.y), std::max(hi_.z, p.z)};
  }
  double extent() const { return longest(hi_ - lo_); }
  double largest() const { return std::max(longest(lo_), longest(hi_)); }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  Point3 lo_{infinite}, hi_{-infinite};
};

// --- triangle and polygon alike --------------------------------------------------------------------------------------

template <class Visit>
void for_each_edge(const Triangle& t, const Visit& visit) {
  visit(t.a, t.b);
  visit(t.b, t.c);
  visit(t.c, t.a);
}

template <class Visit>
void for_each_edge(const PolygonData& polygon, const Visit& visit) {
  std::size_t begin = 0;
  for (const std::size_t end : polygon.ends) {
    for (std::size_t i = begin; i < end; ++i) {
      visit(polygon.vertices[i], polygon.vertices[i + 1 == end ? begin : i + 1]);
    }
    begin = end;
  }
}

const Point3& first_vertex(const Triangle& t) { return t.a; }
const Point3& first_vertex(const PolygonData& polygon) { return polygon.vertices.front(); }

/// Newell's normal, from the first vertex: the normal whose length is twice the area.
template <class T>
Vec normal_of(const T& target) {
  const Vec o = lift<double>(first_vertex(target));
  Vec n{0, 0, 0};
  for_each_edge(target, [&](const Point3& a, const Point3& b) {
    const Vec w = cross(arm(o, a), arm(o, b));
    n = {n.x + w.x, n.y + w.y, n.z + w.z};
  });
  return n;
}

// --- clearance -------------------------------------------------------------------------------------------------------

/// Takes the least of many shares, each of a length or of an area.
class Least {
 public:
  Least(double extent, double largest) : extent_(extent), largest_(largest) {}

  void take_area(double x) { take(x / (extent_ * extent_), x / (largest_ * largest_)); }
  /// `further`: how much further away than all points the end lies.
  void take_length(double x, double further = 0) { take(x / (extent_ + further), x / (largest_ + further)); }
  void take_share(double x) { take(x, x); }

  Clearance value() const { return least_; }

 private:
  /// A share that is not a number stays.
  static void keep_less(double& least, double x) {
    if (std::isnan(x) || x < least) least = x;
  }

  void take(double of_extent, double of_coordinates) {
    keep_less(least_.of_extent, of_extent);
    keep_less(least_.of_coordinates, of_coordinates);
  }

  double extent_, largest_;
  Clearance least_{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
};

template <class T>
class Clearances {
 public:
  Clearances(const Probe& probe, const T& target) : Clearances(probe, target, box_of(target)) {}

  Clearance of(const Segment& s) {
    take_end(s.p);
    take_end(s.q);
    take_edges(s.p, arm(lift<double>(s.p), s.q));
    return least_.value();
  }

  Clearance of(const Ray& r, const std::optional<Bounds>& bounds) {
    const Vec d = lift<double>(r.d.v);
    take_end(r.o);
    least_.take_share(std::fabs(along_normal(d)) / (size_ * size_ * longest(d)));
    if (bounds) take_ends(r, *bounds);
    take_edges(r.o, d);
    return least_.value();
  }

 private:
  Clearances(const Probe& probe, const T& target, const Box& box)
      : target_(target), normal_(normal_of(target)), size_(box.extent()), least_(least_for(probe, box)) {}

  static Box box_of(const T& target) {
    Box box;
    for_each_edge(target, [&](const Point3& a, const Point3&) { box.add(a); });
    return box;
  }

  /// `box`: of the target alone, to which the probe's points are added.
  static Least least_for(const Probe& probe, Box box) {
    if (const auto* s = std::get_if<Segment>(&probe)) {
      box.add(s->p);
      box.add(s->q);
    } else {
      box.add(std::get<Ray>(probe).o);
    }
    return {box.extent(), box.largest()};
  }

  double along_normal(const Vec& v) const { return normal_.x * v.x + normal_.y * v.y + normal_.z * v.z; }
  double volume_at(const Point3& p) const { return along_normal(arm(lift<double>(first_vertex(target_)), p)); }

  void take_end(const Point3& p) { least_.take_length(std::fabs(volume_at(p)) / (size_ * size_)); }

  /// Both ends of the part of a ray within bounds.
  void take_ends(const Ray& r, const Bounds& bounds) {
    const Vec d = lift<double>(r.d.v);
    for (const double t : {bounds.tmin, bounds.tmax}) {
      if (std::isinf(t)) continue;
      least_.take_length(std::fabs(volume_at(r.o) + t * along_normal(d)) / (size_ * size_), t * longest(d));
    }
  }

  void take_edges(const Point3& source, const Vec& d) {
    const Vec o = lift<double>(source);
    const double roundness = longest(normal_) / (size_ * size_);
    for_each_edge(target_, [&](const Point3& a, const Point3& b) {
      least_.take_area(roundness * std::fabs(det3(arm(o, a), arm(lift<double>(a), b), d)) / longest(d));
    });
  }

  const T& target_;
  Vec normal_;
  double size_;
  Least least_;
};

// --- severity --------------------------------------------------------------------------------------------------------

/// What is known exactly: no sign vanishes, or no ring edge is met and the polygon is planar.
bool is_exactly_generic(const Truth& truth) {
  if (truth.operands() == Operands::triangles) return is_generic(truth.class_id);
  return truth.planar && !truth.boundary && truth.contact != Contact::coplanar;
}

bool has_vertices(const Query& query) {
  const auto* polygon = std::get_if<PolygonData>(&query.target);
  return polygon == nullptr || !polygon->vertices.empty();
}

/// Whether tests in binary32 may be asked of it.
bool is_exact_in_binary32(const Query& query) {
  const auto exact = [](const Point3& p) { return is_exact_in(p, Format::binary32); };
  const auto* s = std::get_if<Segment>(&query.probe);
  const auto* r = std::get_if<Ray>(&query.probe);
  bool all = s != nullptr ? exact(s->p) && exact(s->q) : exact(r->o) && exact(r->d.v);
  const auto corners = [&](const auto& target) {
    for_each_edge(target, [&](const Point3& a, const Point3&) { all = all && exact(a); });
  };
  std::visit(corners, query.target);
  return all;
}

bool is_clear(const Query& query) {
  constexpr double roundings = 64;
  const double u = is_exact_in_binary32(query) ? 0x1p-24 : 0x1p-53;
  const Clearance c = clearance_of(query);
  return c.of_extent >= least_clearance && c.of_coordinates >= roundings * u;
}

}  // namespace

Clearance clearance_of(const Query& query) {
  return std::visit(
      [&](const auto& target) {
        Clearances clearances(query.probe, target);
        const auto* s = std::get_if<Segment>(&query.probe);
        return s != nullptr ? clearances.of(*s) : clearances.of(std::get<Ray>(query.probe), query.bounds);
      },
      query.target);
}

Severity severity_of(const Query& query, const Truth& truth) {
  if (!is_everyday(query)) return Severity::extreme;
  return has_vertices(query) && is_exactly_generic(truth) && is_clear(query) ? Severity::plain : Severity::boundary;
}

}  // namespace tribunal
