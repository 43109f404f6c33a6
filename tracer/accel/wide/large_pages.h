// Memory on large pages, for large arrays that are read in random order: fewer misses of the translation buffer.
#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>

namespace tribunal {

/// Allocates at addresses that are multiples of 64; blocks of 4 MiB and more on 2 MiB pages where the system grants
/// them.
template <class T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <class U>
  LargePages(const LargePages<U>&) {}

  T* allocate(std::size_t n) {
    const std::size_t size = n * sizeof(T);
    void* const block = ::operator new(size, alignment_of(size));
    if (is_large(size)) madvise(block, size, MADV_HUGEPAGE);  // a hint: its failure changes nothing
    return static_cast<T*>(block);
  }
  void deallocate(T* block, std::size_t n) { ::operator delete(block, alignment_of(n * sizeof(T))); }

  template <class U>
  friend bool operator==(const LargePages&, const LargePages<U>&) {
    return true;
  }

 private:
  static constexpr std::size_t page = std::size_t{1} << 21;

  static bool is_large(std::size_t size) { return size >= 2 * page; }
  static std::align_val_t alignment_of(std::size_t size) { return std::align_val_t{is_large(size) ? page : 64}; }
};

}  // namespace tribunal
