#include "exact/trial/quick_truth.h"

#include <array>
#include <optional>

#include "exact/classes/class_table.h"
#include "exact/filtered/stages/exact_stages.h"
#include "exact/kernels/expansion_bound.h"
#include "exact/kernels/product_sum.h"
#include "exact/trial/truth_rules.h"

namespace tribunal {
namespace {

/// A good mixture of the bits of x. Source: Steele, Lea & Flood, "Fast splittable pseudorandom number generators",
/// OOPSLA 2014, doi:10.1145/2660193.2660195 (SplitMix64, its finalizer by Stafford).
constexpr std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
  x = (x ^ x >> 27) * 0x94d049bb133111eb;
  return x ^ x >> 31;
}

constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;  // 2⁶⁴ over the golden ratio

std::array<Truth, all_class_count + 1> truths_of_classes() {
  std::array<Truth, all_class_count + 1> truths{};
  for (ClassId id = 1; id <= all_class_count; ++id) truths[id] = truth_of_class(id);
  return truths;
}

/// The chirotope, where the error bound makes all five volumes certain; they are nonzero then, and span space.
template <class P>
std::optional<Chirotope> chirotope_by_bound(const P& probe, const Triangle& t) {
  using detail::volume_by_bound;
  const Point3& p = source(probe);
  const auto& q = target(probe);
  ChirotopeCode code;
  const auto append = [&code](const std::optional<Sign>& s) {
    if (s) code.append(*s);
    return s.has_value();
  };
  if (!append(volume_by_bound(t.a, t.b, t.c, p)) || !append(volume_by_bound(t.a, t.b, t.c, q)) ||
      !append(volume_by_bound(t.a, t.b, p, q)) || !append(volume_by_bound(t.a, t.c, p, q)) ||
      !append(volume_by_bound(t.b, t.c, p, q))) {
    return std::nullopt;
  }
  return code.of_rank(4);
}

/// By the bound; on a grid of machine words, where nothing but the operands is rounded, and they are not; by
/// expansions.
template <class P>
Chirotope certified_chirotope(const P& probe, const Triangle& t) {
  if (const auto certain = chirotope_by_bound(probe, t)) return *certain;
  if (Pair<P> moved{probe, t}; moved.move_to_grid(grid_bits<3>)) {
    return chirotope(moved.probe, moved.triangle, GridKernel{});
  }
  return chirotope(probe, t, ProductSumKernel{});
}

}  // namespace

ClassId certified_class(const Query& query) {
  const auto chirotope_of = [&](const auto& probe) { return certified_chirotope(probe, query.triangle()); };
  const Chirotope signs = std::visit(chirotope_of, query.probe);
  return is_of_ray(query) ? ray_class_of(signs) : class_of(signs);
}

namespace {

std::uint64_t hash_of_stream(std::uint64_t seed, std::uint64_t stream) {
  return mixed(mixed(seed + golden) + golden * (stream + 1));
}

std::uint64_t hash_in_stream(std::uint64_t of_stream, std::uint64_t k) { return mixed(of_stream + golden * (k + 1)); }

}  // namespace

std::uint64_t hash_of_case(std::uint64_t seed, std::uint64_t stream, std::uint64_t k) {
  return hash_in_stream(hash_of_stream(seed, stream), k);
}

bool is_audited(std::uint64_t seed, std::uint64_t stream, std::uint64_t k) {
  return hash_of_case(seed, stream, k) % audit_period == 0;
}

std::uint64_t audited_among(std::uint64_t seed, std::uint64_t stream, std::uint64_t n) {
  const std::uint64_t of_stream = hash_of_stream(seed, stream);
  std::uint64_t audited = 0;
  for (std::uint64_t k = 0; k < n; ++k) audited += hash_in_stream(of_stream, k) % audit_period == 0;
  return audited;
}

Truth quick_truth(const Trial& trial, ClassBy quick) {
  static const auto by_class = truths_of_classes();
  const ClassId id = trial.class_id != 0 ? trial.class_id : quick(trial.query);
  if (id == 0) contradiction(trial.query, "the certified signs are in no class", "five elements always are");
  return trial.query.bounds ? narrowed(by_class[id], trial.query, ProductSumKernel{}) : by_class[id];
}

Truth quick_truth_with_facing(const Trial& trial, ClassBy quick) {
  Truth truth = quick_truth(trial, quick);
  truth.facing = facing_in(truth.contact, trial.query, ProductSumKernel{});
  return truth;
}

Truth audited_truth(const Trial& trial, ClassBy quick) {
  const Truth truth = exact_truth(trial.query);
  if (trial.class_id != 0 && trial.class_id != truth.class_id) {
    contradiction(trial.query, "construction says " + class_name(trial.class_id),
                  "the oracles say " + class_name(truth.class_id));
  }
  const Truth by_quick = quick_truth_with_facing(trial, quick);
  const ClassId certified = quick(trial.query);
  if (certified != truth.class_id || by_quick.facing != truth.facing) {
    contradiction(trial.query, "the certified class is " + class_name(certified),
                  "the oracles say " + class_name(truth.class_id));
  }
  if (by_quick.contact != truth.contact || by_quick.at != truth.at) {
    contradiction(trial.query, "within the bounds certified signs say " + std::string(name_of(by_quick.contact)),
                  "the oracles say " + std::string(name_of(truth.contact)));
  }
  return truth;
}

}  // namespace tribunal
