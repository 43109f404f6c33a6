#include "exact/cases/families/draw.h"

#include <Random123/philox.h>

#include <algorithm>

namespace tribunal {

void Draw::refill() {
  constexpr std::size_t words_a_block = 2;
  r123::Philox4x32::key_type key;
  r123::Philox4x32::ctr_type counter;
  std::ranges::copy(key_, key.v);
  std::ranges::copy(counter_, counter.v);
  for (std::size_t i = 0; i < words_.size(); i += words_a_block) {
    const r123::Philox4x32::ctr_type block = r123::Philox4x32()(counter, key);
    for (std::size_t w = 0; w < words_a_block; ++w) {
      words_[i + w] = (std::uint64_t{block.v[2 * w]} << 32) | block.v[2 * w + 1];
    }
    ++counter.v[0];
  }
  counter_[0] = counter.v[0];
  at_ = 0;
}

}  // namespace tribunal
