#include "exact/filtered/batch.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "exact/filtered/batch/batch_target.h"
#include "exact/filtered/filtered.h"

namespace tribunal {
namespace {

constexpr std::size_t block = 512;  ///< pairs whose undecided indices fit on the stack
constexpr const BatchTarget* best_first[] = {&batch_avx512, &batch_avx2, &batch_portable};

const BatchTarget* best_here() {
  return *std::find_if(std::begin(best_first), std::end(best_first),
                       [](const BatchTarget* t) { return t->runs_here(); });
}

const BatchTarget*& chosen() {
  static const BatchTarget* target = best_here();
  return target;
}

std::array<const double*, 15> columns_of(const PointColumns& source, const PointColumns& target,
                                         const TriangleColumns& t) {
  const double* columns[15];
  std::size_t i = 0;
  for (const PointColumns& v : {source, target, t.a, t.b, t.c}) {
    for (const std::span<const double>& column : {v.x, v.y, v.z}) columns[i++] = column.data();
  }
  return std::to_array(columns);
}

void require_lengths(std::size_t n, std::initializer_list<PointColumns> points, std::size_t hits) {
  bool equal = hits == n;
  for (const PointColumns& p : points) equal &= p.x.size() == n && p.y.size() == n && p.z.size() == n;
  if (!equal) throw std::invalid_argument("batch: columns of different lengths");
}

/// Filters block by block, and calls exactly(i) for the undecided ones; the last ones, which do not fill a vector, are
/// asked one by one.
template <class Exactly>
Tally run(FilterPairs filter, std::array<const double*, 15> columns, std::size_t first_moving, std::size_t n,
          std::uint8_t* hit, const Exactly& exactly) {
  Tally tally;
  const auto ask = [&](std::size_t i) {
    const Answer answer = exactly(i);
    hit[i] = answer.hit;
    ++tally[answer.stage];
  };
  const std::size_t lanes = chosen()->lanes, whole = n - n % lanes;
  std::array<std::uint32_t, block> undecided;
  for (std::size_t from = 0; from < whole; from += block) {
    const std::size_t size = std::min(block, whole - from);
    const std::size_t left = filter(columns.data(), size, hit + from, undecided.data());
    tally[Stage::filter] += size - left;
    for (std::size_t k = 0; k < left; ++k) ask(from + undecided[k]);
    for (std::size_t c = first_moving; c < columns.size(); ++c) columns[c] += size;
  }
  for (std::size_t i = whole; i < n; ++i) ask(i);
  return tally;
}

constexpr std::size_t probe_stays = 6, all_move = 0;

PointColumns one(const Point3& p) { return {{&p.x, 1}, {&p.y, 1}, {&p.z, 1}}; }

template <class P>
Tally one_against_many(FilterPairs filter, const P& probe, const TriangleColumns& t, std::span<std::uint8_t> hit,
                       const PointColumns& source, const PointColumns& target) {
  require_lengths(t.size(), {t.a, t.b, t.c}, hit.size());
  return run(filter, columns_of(source, target, t), probe_stays, t.size(), hit.data(),
             [&](std::size_t i) { return intersect(probe, t[i]); });
}

template <class Probes>
Tally each_with_its_own(FilterPairs filter, const Probes& probes, const TriangleColumns& t, std::span<std::uint8_t> hit,
                        const PointColumns& source, const PointColumns& target) {
  require_lengths(t.size(), {source, target, t.a, t.b, t.c}, hit.size());
  return run(filter, columns_of(source, target, t), all_move, t.size(), hit.data(),
             [&](std::size_t i) { return intersect(probes[i], t[i]); });
}

}  // namespace

#if defined(__x86_64__)

bool has_avx2() {
  __builtin_cpu_init();
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0 &&
         __builtin_cpu_supports("bmi") != 0 && __builtin_cpu_supports("bmi2") != 0;
}

bool has_avx512() {
  return has_avx2() && __builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512bw") != 0 &&
         __builtin_cpu_supports("avx512cd") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
         __builtin_cpu_supports("avx512vl") != 0;
}

#else

bool has_avx2() { return false; }
bool has_avx512() { return false; }

#endif

Tally hits(const Segment& s, const TriangleColumns& t, std::span<std::uint8_t> hit) {
  return one_against_many(chosen()->one_segment, s, t, hit, one(s.p), one(s.q));
}

Tally hits(const Ray& r, const TriangleColumns& t, std::span<std::uint8_t> hit) {
  return one_against_many(chosen()->one_ray, r, t, hit, one(r.o), one(r.d.v));
}

Tally hits(const SegmentColumns& s, const TriangleColumns& t, std::span<std::uint8_t> hit) {
  return each_with_its_own(chosen()->segments, s, t, hit, s.p, s.q);
}

Tally hits(const RayColumns& r, const TriangleColumns& t, std::span<std::uint8_t> hit) {
  return each_with_its_own(chosen()->rays, r, t, hit, r.o, r.d);
}

const BatchTarget& batch_target() { return *chosen(); }

std::vector<std::string_view> batch_targets() {
  std::vector<std::string_view> names;
  for (const BatchTarget* t : best_first) {
    if (t->runs_here()) names.emplace_back(t->name);
  }
  return names;
}

void force_batch_target(std::string_view name) {
  if (name.empty()) {
    chosen() = best_here();
    return;
  }
  for (const BatchTarget* t : best_first) {
    if (name != t->name || !t->runs_here()) continue;
    chosen() = t;
    return;
  }
  throw std::invalid_argument("batch: this machine has no target " + std::string(name));
}

}  // namespace tribunal
