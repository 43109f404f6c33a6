#include "tests/exact/mesh/allocations.h"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace {

thread_local bool counting = false;
thread_local std::ptrdiff_t held = 0, most = 0;  ///< blocks from before the count make `held` fall when they are freed

void count(std::ptrdiff_t bytes) {
  held += bytes;
  most = std::max(most, held);
}

}  // namespace

void* operator new(std::size_t size) {
  void* const block = std::malloc(std::max<std::size_t>(size, 1));
  if (!block) throw std::bad_alloc();
  if (counting) count(static_cast<std::ptrdiff_t>(malloc_usable_size(block)));
  return block;
}

void operator delete(void* block) noexcept {
  if (counting && block) count(-static_cast<std::ptrdiff_t>(malloc_usable_size(block)));
  std::free(block);
}

void operator delete(void* block, std::size_t) noexcept { operator delete(block); }

namespace tribunal::testing {

AllocationPeak::AllocationPeak() { counting = true, held = most = 0; }
AllocationPeak::~AllocationPeak() { counting = false; }
std::size_t AllocationPeak::bytes() const { return static_cast<std::size_t>(most); }

}  // namespace tribunal::testing
