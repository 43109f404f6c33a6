// Kills mutants of what decides the truth about a triangle: classes and their table, the certified class, the
// formulations on integers, and the checks of one against another. The oracles behind these are played here by int64
// and GMP's fractions, and can be made to lie, so that every check is seen to stop the run.
#include <gmpxx.h>

#include <cmath>
#include <optional>
#include <string>
#include <variant>

#include "exact/base/failure.h"
#include "exact/cases/case_line.h"
#include "exact/classes/class_table.h"
#include "exact/methods/cgal_kernels.h"
#include "exact/trial/formulations.h"
#include "exact/trial/formulations_on.h"
#include "exact/trial/quick_truth.h"
#include "exact/trial/truth_rules.h"
#include "tests/mutation/kill_classes.h"

using namespace tribunal;
using namespace tribunal::killing;

void check_class_table();

namespace {

const FormulaKernel<mpq_class> fractions;
Truth told{};  ///< what the oracles say of the next query
int asked_oracles = 0;

}  // namespace

namespace tribunal {

Truth exact_truth_of_triangle(const Query&) {
  ++asked_oracles;
  return told;
}
Truth exact_truth_of_polygon(const Query&) { return told; }
std::string case_line(const std::string& id, const Query&) { return id; }
std::string_view name_of(PolygonPlace) { return "a place"; }

Sign EpickKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const Point3& x) const {
  return fractions.orient3d(a, b, c, x);
}
Sign EpickKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const Direction& x) const {
  return fractions.orient3d(a, b, c, x);
}
Sign EpickKernel::orient3d(const Point3& a, const Point3& b, const Point3& c, const RayPoint& x) const {
  return fractions.orient3d(a, b, c, x);
}
Sign EpickKernel::orient2d(Axis d, const Point3& a, const Point3& b, const Point3& x) const {
  return fractions.orient2d(d, a, b, x);
}
Sign EpickKernel::orient2d(Axis d, const Point3& a, const Point3& b, const Direction& x) const {
  return fractions.orient2d(d, a, b, x);
}
Sign EpickKernel::orient2d(Axis d, const Point3& a, const Point3& b, const RayPoint& x) const {
  return fractions.orient2d(d, a, b, x);
}
Sign EpickKernel::compare(Axis axis, const Point3& a, const RayPoint& x) const { return fractions.compare(axis, a, x); }
Sign EpickKernel::compare_hits(const Ray& r, const Triangle& s, const Triangle& t) const {
  return fractions.compare_hits(r, s, t);
}

}  // namespace tribunal

namespace {

/// Whether the run is stopped because two contradict each other.
template <class Ask>
bool contradicts(const Ask& ask) {
  try {
    ask();
  } catch (const Failure& f) {
    require(f.exit() == Exit::oracles_contradict, "the exit code of a contradiction");
    return true;
  }
  return false;
}

// --- the certified class, and what is checked against it ------------------------------------------------------------

void check_certified() {
  Draw draw;
  for (const int exponent : {0, -1060, 900}) {
    each_class([&](const ClassRow& row) {
      for (const int entries : {1, 40, 1 << 20}) {
        const Query q = image_of(query_of(row), draw, entries, exponent);
        require(certified_class(q) == row.id, "the certified class");
      }
    });
  }
  // Where no grid of machine words holds the operands.
  const Triangle t{{0, 0, 0}, {0x1p80, 0, 0}, {0, 0x1p80, 0}};
  const Segment s{{0x1p-80, 1, 1}, {0x1p-80, 1, -1}}, on_edge{{0, 0x1p-80, 1}, {0, 0x1p-80, -1}};
  const auto due = [&](const Segment& probe) { return class_of(probe, t, fractions); };
  require(certified_class({s, t}) == due(s) && certified_class({on_edge, t}) == due(on_edge), "far apart");
}

void check_hash() {
  int audited = 0;
  for (std::uint64_t k = 0; k < 60'000; ++k) {
    require(is_audited(7, 2, k) == (hash_of_case(7, 2, k) % 256 == 0), "audited by the hash");
    audited += is_audited(7, 2, k);
  }
  require(audited > 180 && audited < 290, "one in 256");
  require(audited_among(7, 2, 60'000) == static_cast<std::uint64_t>(audited) && audited_among(7, 2, 0) == 0, "counted");
  // SplitMix64 from its published constants.
  require(hash_of_case(1, 2, 3) == 0x8568f7c4e53b5a35 && hash_of_case(0, 0, 0) == 0x238275bc38fcbe91, "a hash");
  require(hash_of_case(1, 2, 3) != hash_of_case(2, 2, 3) && hash_of_case(1, 2, 3) != hash_of_case(1, 3, 3) &&
              hash_of_case(1, 2, 3) != hash_of_case(1, 2, 4) && hash_of_case(0, 0, 1) != hash_of_case(0, 1, 0),
          "each of the three counts");
}

ClassId in_no_class(const Query&) { return 0; }
ClassId in_class_two(const Query&) { return 2; }

/// The truth about a query of this class, by signs of fractions.
Truth truth_by_fractions(const ClassRow& row, const Query& q) {
  Truth truth{.class_id = row.id, .contact = row.contact(), .of_ray = is_ray_class(row.id)};
  if (truth.hit() && truth.contact != Contact::coplanar) {
    const Point3& o = std::visit([](const auto& probe) -> const Point3& { return source(probe); }, q.probe);
    const Triangle& t = q.triangle();
    Sign side = fractions.orient3d(t.a, t.b, t.c, o);
    if (side == Sign::zero) {
      side = -std::visit([&](const auto& probe) { return fractions.orient3d(t.a, t.b, t.c, target(probe)); }, q.probe);
    }
    truth.facing = side == Sign::positive ? Facing::front : Facing::back;
  }
  return truth;
}

bool same(const Truth& a, const Truth& b) {
  return a.class_id == b.class_id && a.contact == b.contact && a.of_ray == b.of_ray && a.facing == b.facing &&
         a.at == b.at && a.bounded == b.bounded && a.at_origin == b.at_origin;
}

/// The first case of a file that is audited, or is not.
std::uint64_t first_own(bool audited) {
  std::uint64_t k = 0;
  while (is_audited(0, 0, k) != audited) ++k;
  return k;
}

void check_truths() {
  each_class([&](const ClassRow& row) {
    const Query q = query_of(row);
    const Trial known{.query = q, .class_id = row.id}, unknown{.query = q};
    const Truth due = truth_by_fractions(row, q);
    Truth faceless = due;
    faceless.facing = Facing::unsaid;
    require(same(truth_of_class(row.id), faceless) && same(truth_in_class(row.id, q), due), "the truth of a class");
    require(same(quick_truth(known, in_class_two), faceless) && same(quick_truth(unknown, certified_class), faceless),
            "quick");
    require(same(quick_truth_with_facing(unknown, certified_class), due), "quick, with facing");
    told = due;
    require(same(audited_truth(unknown, certified_class), due) && same(audited_truth(known, certified_class), due),
            "audited");
    require(same(truth_by_formulations(q), due), "by formulations");
    require(same(audited_by_oracles(known, truth_by_formulations), due), "formulations, audited");
    const int before = asked_oracles;
    require(same(truth_of(known, 256), due) && asked_oracles == before, "by construction");
    require(same(truth_of(known, 257), due) && same(truth_of(unknown, 256), due) && asked_oracles == before + 2,
            "by oracles");
    require(same(truth_of_own(q, first_own(false)), due) && asked_oracles == before + 2, "own, by formulations");
    require(same(truth_of_own(q, first_own(true)), due) && asked_oracles == before + 3, "own, audited");
    require(same(formulated_truth(known, 1, true, truth_by_formulations), due), "by its class, with facing");
    require(same(formulated_truth(known, 1, false, truth_by_formulations), faceless), "by its class");
    require(same(formulated_truth(known, 0, false, truth_by_formulations), due), "by formulations, one in 257");
    require(same(formulated_truth(unknown, 1, false, truth_by_formulations), due), "by formulations");
  });
}

Truth lying(const Query&) { return {.class_id = 2, .contact = Contact::none}; }

/// A query of class 1 about which one says something else than the others.
void check_contradictions() {
  const ClassRow& row = class_row(1);
  const Query q = query_of(row);
  const Trial known{.query = q, .class_id = 1}, unknown{.query = q}, wrong{.query = q, .class_id = 2};
  told = truth_by_fractions(row, q);
  require(contradicts([&] { quick_truth(unknown, in_no_class); }), "signs in no class");
  require(contradicts([&] { audited_truth(wrong, certified_class); }), "a wrong construction");
  require(contradicts([&] { audited_truth(unknown, in_class_two); }), "a wrong certified class");
  require(contradicts([&] { require_fit(wrong, told); }) && !contradicts([&] { require_fit(known, told); }), "fit");
  require(contradicts([&] { audited_by_oracles(unknown, lying); }), "formulations that lie");
  require(contradicts([&] { formulated_truth(wrong, 0, false, truth_by_formulations); }), "a construction that lies");
  for (int n = 0; n < 3; ++n) {
    told = truth_by_fractions(row, q);
    if (n == 0) told.facing = Facing::front;
    if (n == 1) told.contact = Contact::edge;
    if (n == 2) told.at = At::target;
    require(contradicts([&] { audited_truth(unknown, certified_class); }), "oracles that differ");
  }
  told = truth_by_fractions(row, q);
  told.facing = Facing::back;
  require(contradicts([&] { audited_by_oracles(unknown, truth_by_formulations); }), "another facing");
  require(contradicts([&] { truth_of_own(q, first_own(true)); }), "own, audited, another facing");
  bool refused = false;
  try {
    exact_truth({Segment{{not_a_number, 0, 0}, {0, 0, 1}}, q.triangle()});
  } catch (const Failure& f) {
    refused = f.exit() == Exit::bad_input;
  }
  require(refused, "no truth about what is not finite");
}

/// The construction of a polygon against the truth about it.
void check_constructions() {
  const auto fits = [](PolygonPlace place, const Truth& truth) {
    const Trial trial{.query = {Segment{}, PolygonData{}}, .construction = Construction{0, place, Approach::through}};
    return !contradicts([&] { require_fit(trial, truth); });
  };
  for (int p = 0; p < place_count; ++p) {
    const auto place = static_cast<PolygonPlace>(p);
    const bool vertex = p <= 8, edge = p > 8 && p <= 13, inside = p > 13 && p <= 18;
    for (const Contact c : {Contact::none, Contact::interior, Contact::edge, Contact::vertex, Contact::coplanar}) {
      const bool due = (c == Contact::none && p > 18) || (c == Contact::interior && inside) ||
                       (c == Contact::edge && edge) || (c == Contact::vertex && vertex) ||
                       (c == Contact::coplanar && (vertex || edge));
      require(fits(place, {.contact = c}) == due, "a construction and its contact");
      require(!fits(place, {.contact = c, .planar = false}), "constructions are planar");
    }
  }
  const Trial free{.query = {Segment{}, PolygonData{}}};
  require(!contradicts([&] { require_fit(free, {.contact = Contact::edge}); }), "nothing is known of it");
  told = {.contact = Contact::edge, .planar = false};
  require(!exact_truth({Segment{}, PolygonData{}.add(std::vector<Point3>{{0, 0, 0}})}).planar,
          "the truth about a polygon");
  require(!truth_of_own({Segment{}, PolygonData{}.add(std::vector<Point3>{{0, 0, 0}})}, 1).planar, "own polygons");
}

/// Integers whose n-th sign is turned.
int until_turned = 0;

template <int Bits>
struct Turning : BoundedInteger<Bits> {
  using BoundedInteger<Bits>::BoundedInteger;
  explicit Turning(const BoundedInteger<Bits>& x) : BoundedInteger<Bits>(x) {}

  friend Sign sign_of(const Turning& a) {
    const Sign s = sign_of(static_cast<const BoundedInteger<Bits>&>(a));
    return --until_turned == 0 ? (s == Sign::zero ? Sign::positive : -s) : s;
  }
};
template <int A, int B>
auto operator+(const Turning<A>& a, const Turning<B>& b) {
  return Turning(static_cast<const BoundedInteger<A>&>(a) + static_cast<const BoundedInteger<B>&>(b));
}
template <int A, int B>
auto operator-(const Turning<A>& a, const Turning<B>& b) {
  return Turning(static_cast<const BoundedInteger<A>&>(a) - static_cast<const BoundedInteger<B>&>(b));
}
template <int A, int B>
auto operator*(const Turning<A>& a, const Turning<B>& b) {
  return Turning(static_cast<const BoundedInteger<A>&>(a) * static_cast<const BoundedInteger<B>&>(b));
}

/// Which of the three it is that contradicts, wherever one sign is wrong: each of them is caught.
void check_formulations() {
  bool in_no_class = false, segura_feito_differs = false, caratheodory_differs = false;
  each_class([&](const ClassRow& row) {
    const Query q = query_of(row);
    for (int n = 1; n < 60; ++n) {
      until_turned = n;
      try {
        truth_by_formulations_on<Turning>(q);
      } catch (const Failure& f) {
        const std::string what = f.what();
        in_no_class |= what.find("are in no class") != std::string::npos;
        segura_feito_differs |= what.find("Segura-Feito") != std::string::npos;
        caratheodory_differs |= what.find("Caratheodory") != std::string::npos;
      }
    }
  });
  until_turned = 0;
  require(in_no_class && segura_feito_differs && caratheodory_differs, "each way of contradicting");
}

/// What bounds leave of a ray, by the parameter of its hit.
void check_bounds() {
  Draw draw;
  for (int n = 0; n < 6'000; ++n) {
    const Triangle t = draw.triangle(3);
    const Ray r{draw.point(3), {draw.point(3)}};
    const double tmin = draw.below(3) * 0.5, tmax = draw.below(4) == 0 ? infinity : tmin + draw.below(4) * 0.5;
    const Query q{r, t, Bounds{tmin, tmax}}, whole{r, t};
    const ClassRow& row = class_row(class_of(r, t, fractions));
    const Truth ray = truth_by_fractions(row, whole);
    const Truth part = quick_truth_with_facing({.query = q}, certified_class);
    require(part.bounded && part.class_id == row.id && part.of_ray, "a part of a ray");
    require(same(truth_in_class(row.id, q), part), "the same by another kernel");
    if (ray.contact == Contact::none) {
      require(part.contact == Contact::none && part.facing == Facing::unsaid && !part.at_origin, "a miss stays one");
    } else if (ray.contact != Contact::coplanar) {
      const HitParameter<mpq_class> hit = hit_parameter<mpq_class>(r, t);
      const mpq_class at = hit.num / hit.den, lo(tmin);
      const bool ends = std::isfinite(tmax);
      const bool before = at < lo, after = ends && at > mpq_class(ends ? tmax : 0);
      require(part.hit() == (!before && !after) && (!part.hit() || part.contact == ray.contact), "within bounds");
      require(part.facing == (part.hit() ? ray.facing : Facing::unsaid), "facing within bounds");
      const At due = at == lo ? At::source : ends && at == mpq_class(tmax) ? At::target : At::between;
      require(part.at == (part.hit() ? due : At::unsaid), "the part of the ray");
      require(part.at_origin == (part.hit() && at == 0 && tmin == 0), "at the origin");
    }
    told = part;
    require(same(audited_truth({.query = q}, certified_class), part), "audited within bounds");
    require(same(truth_by_formulations(q), part) && same(formulated_truth({.query = q}, 1, true, lying), part),
            "by oracles");
    require(same(audited_by_oracles({.query = q}, lying), part), "formulations are not asked within bounds");
    require(same(truth_of_own(q, first_own(false)), part), "own, within bounds");
    told.at = told.at == At::target ? At::source : At::target;
    require(contradicts([&] { audited_truth({.query = q}, certified_class); }), "another part of the ray");
  }
}

void check_words() {
  const auto describes = [](Operands operands, bool constructs, const char* begins, const char* ends) {
    Family f{};
    f.operands = operands;
    f.constructs = constructs;
    const std::string text = oracle_of(f);
    return text.starts_with(begins) && text.ends_with(ends);
  };
  require(describes(Operands::triangles, true, "construction, 1 case in 257", "CGAL where defined"),
          "constructed triangles");
  require(describes(Operands::triangles, false, "class table, Segura-Feito", "CGAL where defined"), "triangles");
  require(describes(Operands::polygons, true, "construction, rational kernel", "Caratheodory"), "constructed polygons");
  require(describes(Operands::polygons, false, "rational kernel", "Caratheodory"), "polygons");
  require(std::string(oracles_of(Operands::triangles)).starts_with("class table, rational kernel"), "oracles");
  require(std::string(judges_of_own(Operands::triangles)).starts_with("class table, Segura-Feito"), "own triangles");
  require(std::string(judges_of_own(Operands::polygons)) == oracles_of(Operands::polygons), "own polygons");
  require(std::string(formulations_in_words()).starts_with("class table, Segura-Feito and Caratheodory"),
          "formulations");
}

}  // namespace

int main() {
  check_class_table();
  check_certified();
  check_hash();
  check_truths();
  check_contradictions();
  check_constructions();
  check_formulations();
  check_bounds();
  check_words();
}
