#include "exact/shrink/affine_frame.h"

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "exact/cases/families/pair_vectors.h"

namespace tribunal {
namespace {

/// A point (x, y, z, 1) or a direction (x, y, z, 0): linear dependence here is affine dependence there.
using Homogeneous = std::array<mpq_class, 4>;

struct Dependent {
  std::size_t vector;
  std::vector<mpq_class> weights;  ///< the weights of the frame's vectors
};

struct Frame {
  std::vector<std::size_t> basis;
  std::vector<Dependent> dependents;
  mpz_class denominator = 1;  ///< the common denominator of all weights
};

/// Reduced rows, each with a pivot and the combination of basis vectors that makes it.
struct Row {
  Homogeneous v;
  std::vector<mpq_class> made_of;
  std::size_t pivot;
};

Homogeneous homogeneous(const PairVectors& q, std::size_t i) {
  const Point3& p = *q.v[i];
  return {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z), static_cast<int>(i) < q.points ? 1 : 0};
}

/// Subtracts multiples of the rows; `weights` collects what was subtracted, in terms of the basis.
void reduce(Homogeneous& v, std::vector<mpq_class>& weights, const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    const mpq_class factor = v[row.pivot] / row.v[row.pivot];
    if (factor == 0) continue;
    for (std::size_t k = 0; k < 4; ++k) v[k] -= factor * row.v[k];
    for (std::size_t k = 0; k < row.made_of.size(); ++k) weights[k] += factor * row.made_of[k];
  }
}

Frame frame_of(const PairVectors& q) {
  Frame frame;
  std::vector<Row> rows;
  for (std::size_t i = 0; i < 5; ++i) {
    Homogeneous v = homogeneous(q, i);
    std::vector<mpq_class> weights(rows.size());
    reduce(v, weights, rows);
    const auto pivot = std::find_if(v.begin(), v.end(), [](const mpq_class& x) { return x != 0; });
    if (pivot == v.end()) {
      frame.dependents.push_back({i, weights});
      for (const mpq_class& w : weights) frame.denominator = lcm(frame.denominator, w.get_den());
      continue;
    }
    std::vector<mpq_class> made_of(rows.size() + 1, 1);
    for (std::size_t k = 0; k < rows.size(); ++k) made_of[k] = -weights[k];
    rows.push_back({v, made_of, static_cast<std::size_t>(pivot - v.begin())});
    frame.basis.push_back(i);
  }
  return frame;
}

/// The value as a double, if it is exact in the format.
std::optional<double> exact_value(const mpq_class& x, Format format) {
  const double value = x.get_d();
  if (!std::isfinite(value) || mpq_class(value) != x || !is_exact_in(value, format)) return std::nullopt;
  return value;
}

/// Places the dependent vectors; false if one does not fit the format.
bool place_dependents(const PairVectors& q, const Frame& frame, Format format) {
  for (const Dependent& d : frame.dependents) {
    for (int axis = 0; axis < 3; ++axis) {
      mpq_class sum = 0;
      for (std::size_t k = 0; k < d.weights.size(); ++k) sum += d.weights[k] * mpq_class((*q.v[frame.basis[k]])[axis]);
      const std::optional<double> x = exact_value(sum, format);
      if (!x) return false;
      (*q.v[d.vector])[axis] = *x;
    }
  }
  return true;
}

}  // namespace

std::optional<Query> in_smaller_frame(const Query& query, Format format, int bits, FrameRounding round) {
  Query candidate = query;
  const PairVectors q = vectors_of(candidate);
  const Frame frame = frame_of(q);
  if (frame.denominator > 1024) return std::nullopt;
  for (int axis = 0; axis < 3; ++axis) {
    double largest = 0;
    for (const std::size_t i : frame.basis) largest = std::max(largest, std::fabs((*q.v[i])[axis]));
    if (largest == 0) continue;
    const double unit = std::ldexp(frame.denominator.get_d(), std::ilogb(largest) + 1 - bits);
    if (unit == 0 || !std::isfinite(unit)) return std::nullopt;
    for (const std::size_t i : frame.basis) {
      const double x = round((*q.v[i])[axis], unit);
      if (!std::isfinite(x) || !is_exact_in(x, format)) return std::nullopt;
      (*q.v[i])[axis] = x;
    }
  }
  return place_dependents(q, frame, format) ? std::optional(candidate) : std::nullopt;
}

}  // namespace tribunal
