// The Segura–Feito test that also says the class of its operands.
#pragma once

#include "core/segura_feito.h"
#include "exact/classes/class_table.h"

namespace tribunal {

/// The answer with its class. Where a coplanar contact is a single point, the class says so, and whether the source
/// is that point is itself a query: the source as a segment against the triangle.
template <Kernel K, class P>
Answer classify(const P& probe, const Triangle& t, const K& k) {
  Answer answer = segura_feito(probe, t, k);
  answer.class_id = class_of(probe, t, k);
  if (answer.class_id == 0 || answer.contact != Contact::coplanar) return answer;
  const ClassRow& row = class_row(answer.class_id);
  if (row.intersection != "point") return answer;
  if (row.touches.starts_with("int")) {
    answer.at = At::between;
  } else {
    answer.at = segura_feito(Segment{source(probe), source(probe)}, t, k).hit ? At::source : At::target;
  }
  return answer;
}

}  // namespace tribunal
