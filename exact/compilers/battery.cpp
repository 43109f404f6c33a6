// Every naive method in one library, which is compiled many times: by compilers and flags that CMakeLists.txt lists. It
// is no part of the program, includes core/ alone, and shows one symbol, so that nothing of one build can stand in for
// another's.
#include "exact/compilers/battery.h"

#include <vector>

#include "core/rivals/adapter.h"
#include "core/segura_feito.h"
#include "exact/methods/shelf.h"

namespace {

using namespace tribunal;

Point3 point(const double* x) { return {x[0], x[1], x[2]}; }

/// Test has a static meets(probe, triangle).
template <class Test>
int ask(int ray, const double* q) {
  const Triangle t{point(q + 6), point(q + 9), point(q + 12)};
  if (ray != 0) return Test::meets(Ray{point(q), {point(q + 3)}}, t);
  return Test::meets(Segment{point(q), point(q + 3)}, t);
}

template <class N>
struct SeguraFeito {
  template <class P>
  static bool meets(const P& probe, const Triangle& t) {
    return segura_feito(probe, t, FormulaKernel<N>{}).hit;
  }
};

template <class R>
struct Rival {
  template <class P>
  static bool meets(const P& probe, const Triangle& t) {
    return published::meet<R>(probe, t).has_value();
  }
};

std::vector<tribunal_battery_entry> all_entries() {
  std::vector<tribunal_battery_entry> all = {{"sf", 32, ask<SeguraFeito<float>>}, {"sf", 64, ask<SeguraFeito<double>>}};
  published::visit_shelf([&]<template <class> class R>(const published::ShelfRow<R>& row) {
    all.push_back({row.name, 32, ask<Rival<R<float>>>});
    all.push_back({row.name, 64, ask<Rival<R<double>>>});
  });
  return all;
}

}  // namespace

extern "C" [[gnu::visibility("default")]] const tribunal_battery* tribunal_battery_describe() {
  static const std::vector<tribunal_battery_entry> entries = all_entries();
  static const tribunal_battery battery{TRIBUNAL_BATTERY_COMPILER, TRIBUNAL_BATTERY_FLAGS, entries.size(),
                                        entries.data()};
  return &battery;
}
