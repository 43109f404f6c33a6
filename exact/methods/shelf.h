// The shelf of rivals: one row each. All that has a row is a method, in both formats, with its exact twin
// (methods.cpp), and is compiled again by other compilers and flags (exact/compilers/).
#pragma once

#include <tuple>

#include "core/rivals/arenberg.h"
#include "core/rivals/badouel.h"
#include "core/rivals/baldwin_weber.h"
#include "core/rivals/chirkov.h"
#include "core/rivals/embree_pluecker.h"
#include "core/rivals/fixed_edges.h"
#include "core/rivals/havel_herout.h"
#include "core/rivals/jimenez.h"
#include "core/rivals/kensler_shirley.h"
#include "core/rivals/moeller_trumbore.h"
#include "core/rivals/pluecker.h"
#include "core/rivals/shevtsov.h"
#include "core/rivals/simulation_of_simplicity.h"
#include "core/rivals/wald.h"
#include "core/rivals/woop.h"

namespace tribunal::published {

/// A rival on any number type N, and the first part of its methods' names. `charted`: it stands for the others where
/// all of them could not be read. `yardstick`: times are divided by that of its method in binary64.
template <template <class> class Rival>
struct ShelfRow {
  const char* name;
  bool charted = false;
  bool yardstick = false;

  template <class N>
  using On = Rival<N>;
};

inline constexpr std::tuple shelf{
    ShelfRow<MoellerTrumbore>{"mt", true, true},
    ShelfRow<MoellerTrumborePrinted>{"mt-eps"},
    ShelfRow<MoellerTrumboreCulling>{"mt-cull"},
    ShelfRow<Arenberg>{"arenberg"},
    ShelfRow<Badouel>{"badouel"},
    ShelfRow<Pluecker>{"pluecker"},
    ShelfRow<TripleProducts>{"triple"},
    ShelfRow<Wald>{"wald"},
    ShelfRow<ChirkovUnprepared>{"chirkov2"},
    ShelfRow<ChirkovPrepared>{"chirkov3"},
    ShelfRow<KenslerShirley>{"kensler-shirley"},
    ShelfRow<Shevtsov>{"shevtsov"},
    ShelfRow<HavelHerout>{"havel-herout"},
    ShelfRow<Jimenez>{"jimenez"},
    ShelfRow<Woop>{"woop"},
    ShelfRow<EmbreePluecker>{"embree"},
    ShelfRow<BaldwinWeber>{"baldwin-weber"},
    ShelfRow<FixedEdges>{"edges"},
    ShelfRow<SimulationOfSimplicity>{"sos"},
};

/// Calls visit(row) for each row.
template <class Visit>
void visit_shelf(const Visit& visit) {
  std::apply([&](const auto&... rows) { (visit(rows), ...); }, shelf);
}

}  // namespace tribunal::published
