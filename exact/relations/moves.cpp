// Relations between one query and another: moves of space, other orders of the points, larger operands.
#include <array>
#include <cmath>
#include <limits>

#include "exact/cases/case_io.h"
#include "exact/cases/families/shapes.h"
#include "exact/kernels/dyadic.h"
#include "exact/relations/rows.h"

namespace tribunal {
namespace {

/// The probe with `point` applied to its points and `vector` to its direction.
template <class F, class G>
Segment moved(const Segment& s, const F& point, const G&) {
  return {point(s.p), point(s.q)};
}

template <class F, class G>
Ray moved(const Ray& r, const F& point, const G& vector) {
  return {point(r.o), {vector(r.d.v)}};
}

bool fits(const Segment& s, Format format) { return fits(s.p, format) && fits(s.q, format); }
bool fits(const Ray& r, Format format) { return fits(r.o, format) && fits(r.d.v, format); }
bool fits(const Triangle& t, Format format) { return fits(t.a, format) && fits(t.b, format) && fits(t.c, format); }

/// The query under x ↦ point(x), whose linear part is `vector`; nothing if a coordinate is not exact in the format.
template <class F, class G>
Changed under(const Query& query, Format format, const F& point, const G& vector) {
  const Triangle& t = query.triangle();
  const Triangle placed{point(t.a), point(t.b), point(t.c)};
  if (!fits(placed, format)) return {};
  return std::visit(
      [&](const auto& probe) -> Changed {
        const auto p = moved(probe, point, vector);
        return fits(p, format) ? Query{p, placed} : Changed{};
      },
      query.probe);
}

template <class F>
Changed under_linear(const Query& query, Format format, const F& map) {
  return under(query, format, map, map);
}

bool is_exact_sum(double x, double y) {
  return std::isfinite(x + y) && sign_of(Dyadic(x) + Dyadic(y) - Dyadic(x + y)) == Sign::zero;
}

constexpr double lost = std::numeric_limits<double>::infinity();  // fits nothing

}  // namespace

bool fits(const Point3& p, Format format) { return is_finite(p) && is_exact_in(p, format); }

double exact_sum(double x, double y) {
  return std::isfinite(x) && std::isfinite(y) && is_exact_sum(x, y) ? x + y : lost;
}

double exact_scale(double x, int e) {
  const double y = std::ldexp(x, e);
  return std::isfinite(y) && std::ldexp(y, -e) == x ? y : lost;
}

Point3 exact_sum(const Point3& x, const Point3& y) {
  return {exact_sum(x.x, y.x), exact_sum(x.y, y.y), exact_sum(x.z, y.z)};
}

Point3 exact_midpoint(const Point3& x, const Point3& y) {
  const Point3 sum = exact_sum(x, y);
  return {exact_scale(sum.x, -1), exact_scale(sum.y, -1), exact_scale(sum.z, -1)};
}

Changed vertex_order(const Query& query, Format, Draw& draw) {
  constexpr std::size_t orders[5][3] = {{0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
  const Triangle& t = query.triangle();
  const std::array<Point3, 3> v{t.a, t.b, t.c};
  const auto& order = orders[draw.below(5)];
  return Query{query.probe, Triangle{v[order[0]], v[order[1]], v[order[2]]}};
}

Changed reversal(const Query& query, Format, Draw&) {
  const auto* s = std::get_if<Segment>(&query.probe);
  return s != nullptr ? Query{Segment{s->q, s->p}, query.triangle()} : Changed{};
}

Changed axis_map(const Query& query, Format format, Draw& draw) {
  const std::uint64_t first = draw.below(3), turn = draw.below(2), negatives = draw.below(8);
  const int axis[3] = {static_cast<int>(first), static_cast<int>((first + 1 + turn) % 3),
                       static_cast<int>((first + 2 - turn) % 3)};
  return under_linear(query, format, [&](const Point3& p) {
    Point3 r;
    for (int i = 0; i < 3; ++i) r[i] = (negatives >> i & 1U) != 0 ? -p[axis[i]] : p[axis[i]];
    return r;
  });
}

Changed uniform_scale(const Query& query, Format format, Draw& draw) {
  const int e = static_cast<int>(draw.between(-40, 40));
  return under_linear(query, format, [&](const Point3& p) {
    return Point3(exact_scale(p.x, e), exact_scale(p.y, e), exact_scale(p.z, e));
  });
}

Changed axis_scale(const Query& query, Format format, Draw& draw) {
  int e[3];
  for (int& x : e) x = static_cast<int>(draw.between(-20, 20));
  return under_linear(query, format, [&](const Point3& p) {
    return Point3(exact_scale(p.x, e[0]), exact_scale(p.y, e[1]), exact_scale(p.z, e[2]));
  });
}

Changed translation(const Query& query, Format format, Draw& draw) {
  const Point3 by = draw.below(2) == 0 ? -query.triangle().a : draw_lattice_point(draw, 20, 1);
  return under(
      query, format, [&](const Point3& p) { return exact_sum(p, by); }, [](const Point3& v) { return v; });
}

Changed shear(const Query& query, Format format, Draw& draw) {
  const std::uint64_t first = draw.below(3);
  const int to = static_cast<int>(first), from = static_cast<int>((first + 1 + draw.below(2)) % 3);
  const double sign = draw.below(2) == 0 ? 1 : -1;
  return under_linear(query, format, [&](Point3 p) {
    p[to] = exact_sum(p[to], sign * p[from]);
    return p;
  });
}

Changed zero_signs(const Query& query, Format format, Draw& draw) {
  bool any = false;
  const Changed changed = under_linear(query, format, [&](Point3 p) {
    for (int i = 0; i < 3; ++i) {
      if (p[i] != 0) continue;
      any = true;
      p[i] = draw.below(2) == 0 ? 0.0 : -0.0;
    }
    return p;
  });
  return any ? changed : Changed{};
}

/// The ray with the direction λ·d, where λ is a power of two, times 3 where that is exact.
Changed direction_scale(const Query& query, Format format, Draw& draw) {
  const auto* r = std::get_if<Ray>(&query.probe);
  if (r == nullptr || query.bounds) return {};  // bounds count in lengths of the direction
  const int e = static_cast<int>(draw.between(-40, 40));
  const Point3& v = r->d.v;
  const Point3 once(exact_scale(v.x, e), exact_scale(v.y, e), exact_scale(v.z, e));
  const Point3 thrice = exact_sum(once, exact_sum(once, once));
  if (fits(thrice, format)) return Query{Ray{r->o, {thrice}}, query.triangle()};
  return fits(once, format) ? Query{Ray{r->o, {once}}, query.triangle()} : Changed{};
}

/// The query written to the text of a case file in its format, and read back as binary64.
Changed read_as_binary64(const Query& query, Format format, Draw&) {
  Json line = from_case({.id = "x", .format = format, .query = query});
  line["fmt"] = name_of(Format::binary64);
  return to_case(parse_json(line.dump(), {"relation"}), {"relation"}).query;
}

/// The segment from p to q + (q − p), which is beyond q; nothing if that is not exact.
Changed longer_segment(const Query& query, Format format, Draw&) {
  const auto* s = std::get_if<Segment>(&query.probe);
  if (s == nullptr) return {};
  const Point3 r = exact_sum(s->q, exact_sum(s->q, -s->p));
  return fits(r, format) ? Query{Segment{s->p, r}, query.triangle()} : Changed{};
}

Changed larger_triangle(const Query& query, Format format, Draw&) {
  Triangle t = query.triangle();
  t.b = exact_sum(t.b, exact_sum(t.b, -t.a));
  return fits(t.b, format) ? Query{query.probe, t} : Changed{};
}

Changed ray_of_segment(const Query& query, Format format, Draw&) {
  const auto* s = std::get_if<Segment>(&query.probe);
  if (s == nullptr) return {};
  const Point3 d = exact_sum(s->q, -s->p);
  return fits(d, format) ? Query{Ray{s->p, {d}}, query.triangle()} : Changed{};
}

}  // namespace tribunal
