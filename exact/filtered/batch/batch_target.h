// What one instruction set offers to the batch. Each batch_*.cpp is compiled for its own; batch.cpp chooses one.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tribunal {

/// Filters the first n pairs. `columns` are the coordinates of source, target, a, b, c: x, y, z each; where one probe
/// is asked about many triangles, only the first of its source and target are read. hit[i] is 1 for a certain hit, else
/// 0. The indices of undecided pairs go to `undecided`, which has room for n; their number is returned. n must be a
/// multiple of `lanes`.
using FilterPairs = std::size_t (*)(const double* const* columns, std::size_t n, std::uint8_t* hit,
                                    std::uint32_t* undecided);

struct BatchTarget {
  const char* name;
  bool (*runs_here)();
  std::size_t lanes;
  FilterPairs one_segment, one_ray, segments, rays;
};

/// Whether processor and system have the instructions that batch_avx512.cpp, or batch_avx2.cpp, is compiled for.
bool has_avx512();
bool has_avx2();

extern const BatchTarget batch_avx512, batch_avx2, batch_portable;

/// The target in use.
const BatchTarget& batch_target();

/// The one of the three, compiled for one target each, that belongs to the target in use.
template <class T>
const T& for_target_in_use(const T& avx512, const T& avx2, const T& portable) {
  const BatchTarget* const batch = &batch_target();
  return batch == &batch_avx512 ? avx512 : batch == &batch_avx2 ? avx2 : portable;
}

}  // namespace tribunal
