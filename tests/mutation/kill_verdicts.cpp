// Kills mutants of the verdict: returns 0 iff what a contract owes, what became of an answer, where a wrong one comes
// from and how answers are counted is right. What is owed is computed anew from sets of readings; the facts of a class
// come from its representative, by Carathéodory's theorem on int64; texts are worked out by hand.
#include <string>
#include <variant>

#include "core/due.h"
#include "exact/classes/class_table.h"
#include "exact/oracles/caratheodory.h"
#include "exact/trial/count.h"
#include "exact/trial/judge.h"
#include "exact/trial/outcome.h"
#include "tests/mutation/kill.h"

using namespace tribunal;
using killing::require;

namespace {

// --- what is owed ---------------------------------------------------------------------------------------------------

/// Which of hit and miss a contract allows. Where it allows both it owes nothing.
struct Allowed {
  bool hit, miss;

  /// Both readings have a say: a hit takes both, a miss one.
  constexpr Allowed and_also(const Allowed& o) const { return {hit && o.hit, miss || o.miss}; }
  Due due() const { return hit && miss ? Due::nothing : hit ? Due::hit : Due::miss; }
};
constexpr Allowed hits{true, false}, misses{false, true}, either{true, true};

Allowed of_boundary(Boundary b) {
  switch (b) {
    case Boundary::closed:
      return hits;
    case Boundary::open:
      return misses;
    default:
      return either;
  }
}

/// Of a contact that is known to be at an end, that is known not to be, or of which nothing is known.
Allowed of_end(Ends e, At at) {
  if (at == At::between) return hits;
  const Allowed there = e == Ends::closed ? hits : e == Ends::open ? misses : either;
  return at == At::unsaid && e == Ends::open ? either : there;
}

Allowed of_ends(const Contract& c, const Facts& f) {
  if (!f.bounded) return of_end(c.ends, f.at);
  // At t = 0 the first bound and the ray's own end are one point. Where nothing is promised of bounds, nothing is.
  const bool both_ends = f.at == At::source && f.at_origin;
  if (both_ends && c.bounds == Ends::closed) return of_end(c.bounds, f.at).and_also(of_end(c.ends, f.at));
  return of_end(c.bounds, f.at);
}

Allowed of_facing(const Contract& c, const Facts& f) {
  if (c.culling == Culling::none) return hits;
  return f.facing == Facing::front ? hits : f.facing == Facing::back ? misses : either;
}

bool takes_operands(const Contract& c, const Facts& f) {
  const bool probe = f.bounded ? c.probes.bounds : f.of_ray ? c.probes.rays : c.probes.segments;
  bool target = false;
  if (f.of_polygon) {
    target = c.polygons == Polygons::any || (c.polygons == Polygons::planar && f.planar);
  } else {
    target = c.triangles == Triangles::any || (c.triangles == Triangles::proper && !f.degenerate);
  }
  return probe && target;
}

Due owed(const Contract& c, const Facts& f) {
  const Boundary b = f.of_polygon ? c.polygon_boundary : c.boundary;
  if (!takes_operands(c, f)) return Due::nothing;
  if (f.boundary && b == Boundary::unspecified) return Due::nothing;
  if (f.contact == Contact::none) return Due::miss;
  if (f.contact == Contact::coplanar) {
    if (c.convention != Convention::closed) return c.convention == Convention::transversal ? Due::miss : Due::nothing;
    const bool all_closed = c.ends == Ends::closed && (!f.bounded || c.bounds == Ends::closed) &&
                            (!f.boundary || b == Boundary::closed) && c.culling == Culling::none;
    return all_closed ? Due::hit : Due::nothing;
  }
  const Allowed crossing = of_facing(c, f).and_also(of_ends(c, f));
  const Allowed all = f.boundary ? crossing.and_also(of_boundary(b)) : crossing;
  return all.miss && !all.hit ? Due::miss : all.due();
}

/// A miss that one reading says is a miss, whatever the others allow.
static_assert(!misses.and_also(either).hit && misses.and_also(either).miss);

/// Calls with every value from 0 to n − 1.
template <class E, class Ask>
void each(int n, const Ask& ask) {
  for (int i = 0; i < n; ++i) ask(static_cast<E>(i));
}

void require_due(const Contract& c, const Facts& f) { require(due(c, f) == owed(c, f), "due"); }

/// All operands, with every reading closed.
void check_operands() {
  constexpr Facts plain;
  require(!plain.of_ray && !plain.of_polygon && !plain.bounded && !plain.degenerate && plain.planar &&
              !plain.boundary && !plain.at_origin && plain.contact == Contact::none && plain.at == At::unsaid &&
              plain.facing == Facing::unsaid,
          "nothing is said");
  for (int bits = 0; bits < 256; ++bits) {
    const auto bit = [&](int i) { return (bits >> i & 1) != 0; };
    each<Triangles>(3, [&](Triangles triangles) {
      each<Polygons>(3, [&](Polygons polygons) {
        Contract c{.probes = {bit(0), bit(1), bit(2)}, .triangles = triangles, .polygons = polygons};
        for (const Contact contact : {Contact::none, Contact::interior, Contact::coplanar}) {
          require_due(c, {.of_ray = bit(3),
                          .of_polygon = bit(4),
                          .bounded = bit(5),
                          .degenerate = bit(6),
                          .planar = bit(7),
                          .contact = contact});
        }
      });
    });
  }
}

template <class Ask>
void each_reading(const Ask& ask) {
  Contract c{.probes = {true, true, true}, .polygons = Polygons::any};
  each<Convention>(3, [&](Convention v) {
    each<Boundary>(4, [&](Boundary b) {
      each<Ends>(3, [&](Ends e) {
        each<Ends>(3, [&](Ends bounds) {
          each<Culling>(2, [&](Culling culling) {
            c.convention = v, c.ends = e, c.bounds = bounds, c.culling = culling;
            c.boundary = b, c.polygon_boundary = Boundary::closed;
            ask(c, false);
            c.boundary = Boundary::closed, c.polygon_boundary = b;
            ask(c, true);
            c.boundary = b;
            ask(c, true);
          });
        });
      });
    });
  });
}

void check_readings() {
  each_reading([](const Contract& c, bool of_polygon) {
    for (int bits = 0; bits < 8; ++bits) {
      Facts f{.of_polygon = of_polygon};
      f.bounded = f.of_ray = (bits & 1) != 0, f.boundary = (bits & 2) != 0, f.at_origin = (bits & 4) != 0;
      each<Contact>(5, [&](Contact contact) {
        each<At>(4, [&](At at) {
          each<Facing>(3, [&](Facing facing) {
            f.contact = contact, f.at = at, f.facing = facing;
            require_due(c, f);
          });
        });
      });
    }
  });
}

/// Which way the triangle runs as seen from the probe's source, from its normal and the probe's direction.
void check_facing() {
  const FormulaKernel<std::int64_t> k;
  killing::Draw draw;
  for (int n = 0; n < 4'000; ++n) {
    const Triangle t = draw.triangle(3);
    const Point3 p = draw.point(3), q = draw.point(3);
    const auto crossed = [](const Point3& u, const Point3& v) {
      return Point3(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x);
    };
    const Point3 normal = crossed(t.b - t.a, t.c - t.a), way = q - p;
    const double along = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    const Segment s{p, q};
    if (along == 0 || !meets_by_caratheodory<std::int64_t>(s, t)) continue;
    const Facing seen = along < 0 ? Facing::front : Facing::back;
    require(facing(s, t, k) == seen && facing(Ray{p, {way}}, t, k) == seen, "facing");
  }
}

// --- facts of a class -----------------------------------------------------------------------------------------------

template <class P>
bool meets(const P& probe, const Triangle& t) {
  return meets_by_caratheodory<std::int64_t>(probe, t);
}

template <class P>
bool meets_boundary(const P& probe, const Triangle& t) {
  return meets(probe, {t.a, t.b, t.b}) || meets(probe, {t.b, t.c, t.c}) || meets(probe, {t.c, t.a, t.a});
}

bool has_area(const Triangle& t) {
  const Point3 u = t.b - t.a, v = t.c - t.a;
  return u.y * v.z != u.z * v.y || u.z * v.x != u.x * v.z || u.x * v.y != u.y * v.x;
}

bool holds(const Triangle& t, const Point3& x) { return meets(Segment{x, x}, t); }
bool is_point(const Segment& s) { return s.p == s.q; }
bool is_point(const Ray& r) { return r.d.v == Point3(0); }
bool end_meets(const Segment& s, const Triangle& t) { return holds(t, s.p) || holds(t, s.q); }
bool end_meets(const Ray& r, const Triangle& t) { return holds(t, r.o); }

void check_facts_of(const ClassRow& row) {
  const Triangle t = row.representative_triangle();
  Truth truth{.class_id = row.id, .contact = row.contact(), .of_ray = is_ray_class(row.id), .facing = Facing::back};
  const Facts f = facts_of(truth);
  std::visit(
      [&](const auto& probe) {
        require(f.of_ray == is_ray_class(row.id) && !f.of_polygon && f.planar && !f.bounded && !f.at_origin,
                "operands");
        require(f.degenerate == (!has_area(t) || is_point(probe)), "degenerate");
        require((f.contact != Contact::none) == meets(probe, t) && f.contact == row.contact(), "contact of a class");
        require(f.boundary == meets_boundary(probe, t), "boundary of a class");
        const At at = end_meets(probe, t) ? At::source : At::between;
        require(f.at == (row.intersection == "point" ? at : At::unsaid), "at");
      },
      row.representative_probe());
  require(f.facing == Facing::back, "facing is the truth's");
  truth.bounded = true;
  truth.at = At::target;
  const Facts within = facts_of(truth);
  require(within.bounded && within.contact == row.contact() && within.at == At::target && !within.at_origin,
          "narrowed");
  require(within.boundary == f.boundary && within.degenerate == f.degenerate, "what bounds leave");
  truth.contact = Contact::none;
  truth.at_origin = true;
  const Facts without = facts_of(truth);
  require(!without.boundary && without.contact == Contact::none && without.at_origin, "what bounds cut off");
}

void check_facts() {
  for (const ClassRow& row : class_table()) check_facts_of(row);
  for (const ClassRow& row : ray_class_table()) check_facts_of(row);
  const Facts f = facts_of(
      {.contact = Contact::edge, .planar = false, .boundary = true, .of_ray = true, .at = At::target, .bounded = true});
  require(f.of_polygon && f.of_ray && !f.planar && f.boundary && f.contact == Contact::edge && f.at == At::target,
          "facts of a polygon");
  require(!facts_of(Truth{}).of_ray && facts_of(Truth{}).planar && !f.bounded, "a polygon and a segment");
}

// --- outcomes -------------------------------------------------------------------------------------------------------

Method method_with(const Contract& c) {
  Method m;
  m.contract = c;
  return m;
}

void check_judge_of(const Method& m, const Truth& truth, const Answer& a) {
  const Due is_due = owed(m.contract, facts_of(truth));
  Outcome expected = Outcome::right;
  if (is_fault(a.status)) {
    expected = Outcome::fault;
  } else if (is_due == Due::nothing) {
    expected = Outcome::not_owed;
  } else if (a.status != Status::ok) {
    expected = Outcome::refused;
  } else if (a.hit != (is_due == Due::hit)) {
    expected = a.hit ? Outcome::false_hit : Outcome::false_miss;
  } else {
    const bool planar = m.contract.exact && a.planar != truth.planar;
    const bool side = m.tells_side && a.hit &&
                      ((a.facing == Facing::front && truth.facing == Facing::back) ||
                       (a.facing == Facing::back && truth.facing == Facing::front));
    const bool contact = m.tells_contact && a.hit && a.contact != Contact::unsaid && a.contact != truth.contact;
    if (planar || side || contact) expected = Outcome::wrong_contact;
  }
  require(judge(m, truth, a) == expected, "outcome");
  const Answer kept = within_contract(m, truth, a);
  const bool refuses = a.status == Status::ok && is_due == Due::nothing;
  require(kept == (refuses ? refusal(Status::unsupported) : a), "within the contract");
}

/// A class with this contact, of a segment that crosses a triangle.
ClassId class_with(Contact contact) {
  for (const ClassRow& row : class_table()) {
    if (row.rank == 4 && row.contact() == contact) return row.id;
  }
  return 0;
}

void check_judge() {
  require(judge(Due::nothing, true) == Outcome::not_owed && judge(Due::nothing, false) == Outcome::not_owed,
          "nothing is owed");
  for (int bits = 0; bits < 128; ++bits) {
    const auto bit = [&](int i) { return (bits >> i & 1) != 0; };
    Method m = method_with({.polygons = bit(0) ? Polygons::any : Polygons::none,
                            .boundary = bit(1) ? Boundary::unspecified : Boundary::closed,
                            .exact = bit(2)});
    m.tells_contact = bit(3), m.tells_side = bit(4);
    for (const Contact contact : {Contact::none, Contact::interior, Contact::edge}) {
      each<Facing>(3, [&](Facing exact) {
        const Truth of_polygon{.contact = contact, .planar = bit(5), .boundary = contact == Contact::edge};
        const Truth of_triangle{.class_id = class_with(contact), .contact = contact, .facing = exact};
        each<Status>(5, [&](Status status) {
          each<Facing>(3, [&](Facing told) {
            for (const Contact said : {Contact::none, Contact::interior, Contact::edge, Contact::unsaid}) {
              const Answer a{
                  .hit = said != Contact::none, .contact = said, .status = status, .planar = bit(6), .facing = told};
              check_judge_of(m, of_polygon, a);
              check_judge_of(m, of_triangle, a);
            }
          });
        });
      });
    }
  }
}

void check_promises() {
  for (int bits = 0; bits < 2; ++bits) {
    each<Triangles>(3, [&](Triangles triangles) {
      each<Polygons>(3, [&](Polygons polygons) {
        each<Boundary>(4, [&](Boundary b) {
          Contract c{.triangles = triangles,
                     .polygons = polygons,
                     .boundary = bits == 0 ? b : Boundary::closed,
                     .polygon_boundary = bits == 0 ? Boundary::closed : b};
          require(owes_all(c, Operands::triangles) == (c.boundary == Boundary::closed && triangles != Triangles::none),
                  "promises of triangles");
          require(owes_all(c, Operands::polygons) == (c.boundary == Boundary::closed && polygons == Polygons::any &&
                                                      c.polygon_boundary == Boundary::closed),
                  "promises of polygons");
        });
      });
    });
  }
  each_reading([](const Contract& c, bool) {
    const bool all = c.convention != Convention::unspecified && c.ends == Ends::closed && c.culling == Culling::none;
    require(reads_as_sets(c) == all, "sets");
    require(reads_point_sets(c) == (all && c.boundary == Boundary::closed && c.bounds == Ends::closed), "point sets");
  });
  for (const Format wide : {Format::binary64, Format::binary32}) {
    for (const Format narrow : {Format::binary64, Format::binary32}) {
      const bool rounded = wide == Format::binary32 && narrow == Format::binary64;
      require(takes(method_with({.format = wide}), narrow) == !rounded, "formats");
    }
  }
}

}  // namespace

void check_counts();

int main() {
  check_operands();
  check_readings();
  check_facing();
  check_facts();
  check_judge();
  check_promises();
  check_counts();
}
