// The part of kill_truths.cpp that is about classes and their table.
#include "tests/mutation/kill_classes.h"

#include <gmpxx.h>

#include <cstdio>
#include <type_traits>
#include <variant>

#include "exact/classes/class_table.h"
#include "exact/classes/classify.h"

using namespace tribunal;
using namespace tribunal::killing;

namespace {

const FormulaKernel<mpq_class> fractions;

// --- the table ------------------------------------------------------------------------------------------------------

void check_table() {
  require(class_table().size() == 163 && ray_class_table().size() == 165, "163 and 165 classes");
  int number = 0;
  each_class([&](const ClassRow& row) {
    ++number;
    require(row.id == number && class_row(row.id).id == row.id && is_ray_class(row.id) == (number > 163),
            "ids in order");
    char name[8];
    std::snprintf(name, sizeof name, "%c%03d", number > 163 ? 'R' : 'C', number > 163 ? number - 163 : number);
    require(class_name(row.id) == name && class_named(name) == row.id, "names");
    const Query q = query_of(row);
    const Answer a =
        std::visit([&](const auto& probe) { return segura_feito(probe, q.triangle(), fractions); }, q.probe);
    require(row.contact() == a.contact && row.hit() == a.hit, "a class's contact");
    require(is_of_ray(q) == is_ray_class(row.id), "a class's probe");
  });
  for (const char* name :
       {"", "C00", "C0001", "D001", "C000", "C164", "R000", "R166", "C1x3", "Cx13", "C-01", "c001", "C 01"}) {
    require(class_named(name) == 0, "no class has this name");
  }
  require(class_name(0).empty(), "no class, no name");
  // Signs that no five points have.
  require(class_of(Chirotope{1, 0}) != 0 && class_of(Chirotope{4, 121}) == 0 && ray_class_of(Chirotope{4, 121}) == 0,
          "chirotopes that do not exist");
}

/// Mirrored, reversed and reordered operands stay in the class.
void check_classes() {
  Draw draw;
  each_class([&](const ClassRow& row) {
    for (int n = 0; n < 3; ++n) {
      Query q = image_of(query_of(row), draw, 3, 0);
      std::swap(q.triangle().a, q.triangle().c);
      if (auto* s = std::get_if<Segment>(&q.probe)) std::swap(s->p, s->q);
      const auto mirror = [](Point3& p) { p.y = -p.y; };
      for (Point3* p : {&q.triangle().a, &q.triangle().b, &q.triangle().c}) mirror(*p);
      std::visit(
          [&](auto& probe) {
            if constexpr (std::is_same_v<std::remove_cvref_t<decltype(probe)>, Segment>) {
              mirror(probe.p), mirror(probe.q);
            } else {
              mirror(probe.o), mirror(probe.d.v);
            }
            require(class_of(probe, q.triangle(), fractions) == row.id, "the class of an image");
          },
          q.probe);
    }
  });
}

/// Turns the signs of one of the five tetrahedra.
struct OneTurned : FormulaKernel<mpq_class> {
  Triangle turned;

  template <class X>
  Sign orient3d(const Point3& a, const Point3& b, const Point3& c, const X& x) const {
    const Sign s = fractions.orient3d(a, b, c, x);
    return a == turned.a && b == turned.b && c == turned.c ? -s : s;
  }
};

/// Signs that no five points have are in no class.
void check_impossible_signs() {
  int impossible = 0;
  each_class([&](const ClassRow& row) {
    const Query q = query_of(row);
    const Triangle& t = q.triangle();
    std::visit(
        [&](const auto& probe) {
          for (const Triangle& turned : {Triangle{t.a, t.b, source(probe)}, Triangle{t.b, t.c, source(probe)}}) {
            const OneTurned k{{}, turned};
            const ClassId id = class_of(probe, t, k);
            require(classify(probe, t, k).class_id == id, "the class of wrong signs");
            impossible += id == 0;
          }
        },
        q.probe);
  });
  require(impossible > 10, "signs in no class");
}

void check_classify() {
  each_class([&](const ClassRow& row) {
    const Query q = query_of(row);
    std::visit(
        [&](const auto& probe) {
          const Answer plain = segura_feito(probe, q.triangle(), fractions),
                       a = classify(probe, q.triangle(), fractions);
          require(a.class_id == row.id && a.hit == plain.hit && a.contact == plain.contact, "classify");
          if (a.contact != Contact::coplanar || row.intersection != "point") {
            require(a.at == plain.at, "the probe's part, as without a class");
            return;
          }
          const auto holds = [&](const Point3& x) { return segura_feito(Segment{x, x}, q.triangle(), fractions).hit; };
          const bool at_source = holds(source(probe));
          bool at_target = false;
          if constexpr (std::is_same_v<std::remove_cvref_t<decltype(probe)>, Segment>) at_target = holds(probe.q);
          require(a.at == (at_source ? At::source : at_target ? At::target : At::between), "the probe's part");
        },
        q.probe);
  });
}

}  // namespace

void check_class_table() {
  check_table();
  check_classes();
  check_classify();
  check_impossible_signs();
}
