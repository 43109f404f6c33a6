#include "exact/cases/families/draw.h"

#include <Random123/philox.h>

#include <algorithm>

namespace tribunal {

void Draw::next_block() {
  r123::Philox4x32::key_type key;
  r123::Philox4x32::ctr_type counter;
  std::ranges::copy(key_, key.v);
  std::ranges::copy(counter_, counter.v);
  std::ranges::copy(r123::Philox4x32()(counter, key).v, block_.begin());
  ++counter_[0];
}

}  // namespace tribunal
