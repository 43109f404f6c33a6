// Bytes read as coordinates that are often degenerate: copies of earlier ones, small integers, neighbours a few units
// in the last place away, powers of two from the smallest to the largest.
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "core/segura_feito.h"
#include "core/segura_feito_polygon.h"
#include "exact/filtered/batch.h"
#include "exact/filtered/filtered.h"
#include "exact/filtered/filtered_polygon.h"
#include "exact/kernels/rational_kernel.h"
#include "tests/fuzz/targets.h"

namespace tribunal::fuzzing {
namespace {

/// The bytes one after the other; zeros after the last.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : left_(bytes) {}

  std::uint8_t next() {
    if (left_.empty()) return 0;
    const auto byte = static_cast<std::uint8_t>(left_.front());
    left_.remove_prefix(1);
    return byte;
  }

  template <class N>
  N raw() {
    std::array<std::uint8_t, sizeof(N)> bytes;
    for (std::uint8_t& b : bytes) b = next();
    return std::bit_cast<N>(bytes);
  }

 private:
  std::string_view left_;
};

/// So many representable numbers further up, or down. `N` is the format of the coordinates.
template <class N>
N moved(N x, int ulps) {
  const N end = ulps < 0 ? -std::numeric_limits<N>::infinity() : std::numeric_limits<N>::infinity();
  for (int i = 0; i < std::abs(ulps); ++i) x = std::nextafter(x, end);
  return x;
}

template <class N>
N extreme(std::uint8_t which) {
  using Limits = std::numeric_limits<N>;
  const N values[] = {0,
                      -N(0),
                      Limits::denorm_min(),
                      -Limits::denorm_min(),
                      Limits::min(),
                      -Limits::min(),
                      Limits::max(),
                      -Limits::max(),
                      1 + Limits::epsilon(),
                      1 - Limits::epsilon() / 2,
                      std::sqrt(Limits::max()),
                      std::sqrt(Limits::min()),
                      std::ldexp(N(1), Limits::digits),
                      N(1) / 3,
                      Limits::infinity(),
                      Limits::quiet_NaN()};
  return values[which % std::size(values)];
}

/// Coordinates of one format, each of which may refer to those before it.
template <class N>
class Points {
 public:
  explicit Points(Bytes& bytes) : bytes_(bytes), exponent_(bytes.next()) {}

  Point3 next() {
    const std::uint8_t way = bytes_.next();
    Point3 p;
    if (way % 4 == 1 && !points_.empty()) {
      p = earlier();
    } else if (way % 4 == 2 && points_.size() > 1) {
      const Point3 a = earlier(), b = earlier();
      p = on_line(a, b);
    } else {
      p.x = coordinate();
      p.y = coordinate();
      p.z = coordinate();
    }
    points_.push_back(p);
    return p;
  }

 private:
  const Point3& earlier() { return points_[bytes_.next() % points_.size()]; }

  /// a + k/4·(b − a), rounded.
  Point3 on_line(const Point3& a, const Point3& b) {
    const N k = static_cast<N>(static_cast<std::int8_t>(bytes_.next())) / 4;
    Point3 p;
    for (int i = 0; i < 3; ++i)
      p[i] = static_cast<N>(static_cast<N>(a[i]) + k * (static_cast<N>(b[i]) - static_cast<N>(a[i])));
    return p;
  }

  N coordinate() {
    const std::uint8_t way = bytes_.next();
    const N x = coordinate(way % 8, way / 8);
    coordinates_.push_back(x);
    return x;
  }

  N coordinate(int way, std::uint8_t more) {
    const bool any = !coordinates_.empty();
    switch (way) {
      case 0:
      case 1:
        return std::ldexp(static_cast<N>(more % 8) - 3, exponent());
      case 2:
        return any ? coordinates_[more % coordinates_.size()] : 0;
      case 3:
        return any ? moved(coordinates_[more % coordinates_.size()], static_cast<std::int8_t>(bytes_.next()) / 8) : 1;
      case 4:
        return std::ldexp(static_cast<N>(static_cast<std::int8_t>(bytes_.next())), 4 * (more - 16) + exponent());
      case 5:
        return extreme<N>(more);
      case 6:
        return any ? -coordinates_[more % coordinates_.size()] : -1;
      default:
        return bytes_.raw<N>();
    }
  }

  /// Of the whole query: most have none, the others any that the format has.
  int exponent() const {
    constexpr int least = std::numeric_limits<N>::min_exponent - std::numeric_limits<N>::digits;
    constexpr int range = std::numeric_limits<N>::max_exponent - least;
    return exponent_ < 128 ? 0 : least + range * (exponent_ - 128) / 128;
  }

  Bytes& bytes_;
  int exponent_;
  std::vector<Point3> points_{};
  std::vector<N> coordinates_{};
};

bool same(const Answer& a, const Answer& b) {
  return a.hit == b.hit && a.contact == b.contact && a.at == b.at && a.status == b.status && a.planar == b.planar;
}

std::string in_words(const Answer& a) {
  return std::string(a.hit ? "hit " : "miss ") + std::string(name_of(a.contact)) + " " + std::string(name_of(a.at)) +
         (a.planar ? "" : " not planar") + " by " + std::string(name_of(a.stage));
}

std::string both(const Answer& given, const Answer& due) {
  return ": " + in_words(given) + ", due is " + in_words(due);
}

bool same_with_side(const Answer& a, const Answer& b) { return same(a, b) && a.facing == b.facing; }

/// The class tells of a coplanar contact in one point where on the probe it lies; the signs alone do not.
bool same_but_for_place(Answer classified, const Answer& due) {
  if (due.contact == Contact::coplanar && due.at == At::unsaid) classified.at = At::unsaid;
  return same_with_side(classified, due);
}

/// Nine copies, so that lanes and the rest after them are asked.
template <class P, class Columns>
void demand_same_in_batch(const P& probe, const Point3& p, const Point3& q, const Triangle& t, bool hit) {
  constexpr std::size_t n = 9;
  std::array<std::array<double, n>, 15> columns;
  const Point3 points[] = {p, q, t.a, t.b, t.c};
  for (std::size_t i = 0; i < columns.size(); ++i) columns[i].fill(points[i / 3][static_cast<int>(i % 3)]);
  const auto of = [&](std::size_t i) { return PointColumns{columns[i], columns[i + 1], columns[i + 2]}; };
  const TriangleColumns triangles{of(6), of(9), of(12)};
  std::array<std::uint8_t, n> hits_all{}, hits_one{};
  hits(Columns{of(0), of(3)}, triangles, hits_all);
  hits(probe, triangles, hits_one);
  for (std::size_t i = 0; i < n; ++i) {
    demand((hits_all[i] != 0) == hit, "a batch of pairs answers otherwise");
    demand((hits_one[i] != 0) == hit, "a batch of one probe answers otherwise");
  }
}

template <class P, class Columns>
void ask_triangle(const P& probe, const Point3& p, const Point3& q, const Triangle& t) {
  const Answer given = intersect(probe, t);
  if (!is_finite(p) || !is_finite(q) || !is_finite(t)) {
    demand(given.status == Status::nonfinite && !hits(probe, t), "an operand that is not finite gets an answer");
    return;
  }
  const Answer due = segura_feito(probe, t, RationalKernel{});
  demand(same_with_side(given, due), "intersect differs from the reference" + both(given, due));
  demand(hits(probe, t) == due.hit, "hits differs from the reference");
  demand(hits_exactly(probe, t) == due.hit, "hits_exactly differs from the reference");
  const Answer classified = classify(probe, t);
  demand(same_but_for_place(classified, due) && classified.class_id != 0, "classify differs from the reference");
  demand_same_in_batch<P, Columns>(probe, p, q, t, due.hit);
  std::array<TrianglePair, 3> pairs{TrianglePair{probe, t}, TrianglePair{probe, t}, TrianglePair{probe, t}};
  std::array<Answer, 3> answers;
  intersect(pairs, answers);
  for (const Answer& a : answers) demand(same_with_side(a, due), "a batch differs from the reference");
}

void ask_within(const Ray& ray, const Bounds& bounds, const Triangle& t) {
  const Answer given = intersect(ray, bounds, t), due = segura_feito(ray, bounds, t, RationalKernel{});
  demand(same_with_side(given, due), "within bounds, intersect differs from the reference");
  demand(hits(ray, bounds, t) == due.hit, "within bounds, hits differs from the reference");
}

template <class P>
void ask_polygon(const P& probe, const PolygonData& polygon) {
  const FilteredPolygon prepared{Polygon(polygon)};
  const RationalKernel exact;
  const Answer given = prepared.meet(probe), due = segura_feito(probe, cover(Polygon(polygon), exact), exact);
  const Answer unprepared = segura_feito(probe, Polygon(polygon), exact);
  demand(unprepared.hit == due.hit,
         "of a polygon, the reference differs from its prepared form" + both(unprepared, due));
  demand(same(given, due), "of a polygon, the certified test differs from the reference" + both(given, due));
  demand(prepared.hits(probe) == due.hit, "of a polygon, hits differs from the reference");
  const std::optional<bool> certain = prepared.filter_hits(probe);
  demand(!certain || *certain == due.hit, "the polygon's filter is certain and wrong");
}

template <class N>
PolygonData polygon_of(Bytes& bytes, Points<N>& points) {
  PolygonData polygon;
  const std::uint8_t shape = bytes.next();
  for (int ring = 0; ring <= shape % 3; ++ring) {
    const int n = 1 + bytes.next() % 7;
    for (int i = 0; i < n; ++i) polygon.vertices.push_back(points.next());
    polygon.ends.push_back(polygon.vertices.size());
  }
  return polygon;
}

template <class N>
void ask(Bytes& bytes, std::uint8_t kind) {
  Points<N> points(bytes);
  const Point3 p = points.next(), q = points.next();
  const bool of_ray = kind % 2 == 1;
  if (kind / 2 % 4 == 3) {
    const PolygonData polygon = polygon_of(bytes, points);
    if (!is_finite(p) || !is_finite(q) || !is_finite(Polygon(polygon))) return;
    of_ray ? ask_polygon(Ray{p, {q}}, polygon) : ask_polygon(Segment{p, q}, polygon);
    return;
  }
  const Triangle t{points.next(), points.next(), points.next()};
  if (!of_ray) return ask_triangle<Segment, SegmentColumns>({p, q}, p, q, t);
  const Ray ray{p, {q}};
  ask_triangle<Ray, RayColumns>(ray, p, q, t);
  const Point3 ends = points.next();
  const Bounds bounds{.tmin = std::fabs(ends.x), .tmax = std::fabs(ends.y)};
  const bool possible = std::isfinite(bounds.tmin) && bounds.tmax >= bounds.tmin;
  if (possible && is_finite(p) && is_finite(q) && is_finite(t)) ask_within(ray, bounds, t);
}

}  // namespace

void query(std::string_view text) {
  Bytes bytes(text);
  const std::uint8_t kind = bytes.next();
  kind & 0x80 ? ask<float>(bytes, kind & 0x7f) : ask<double>(bytes, kind);
}

}  // namespace tribunal::fuzzing
