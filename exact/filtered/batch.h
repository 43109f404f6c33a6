// The certified test on many operands at once, in structure-of-arrays form, by the widest vectors the machine has.
// Needs the standard library and GLM, no CGAL, GMP or Highway.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/answer.h"
#include "core/operands.h"
#include "exact/filtered/tally.h"

namespace tribunal {

/// Points by columns: point i is (x[i], y[i], z[i]). All columns have the same length.
struct PointColumns {
  std::span<const double> x, y, z;

  std::size_t size() const { return x.size(); }
  Point3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
};

struct TriangleColumns {
  PointColumns a, b, c;

  std::size_t size() const { return a.size(); }
  Triangle operator[](std::size_t i) const { return {a[i], b[i], c[i]}; }
};

struct SegmentColumns {
  PointColumns p, q;

  std::size_t size() const { return p.size(); }
  Segment operator[](std::size_t i) const { return {p[i], q[i]}; }
};

/// `d` holds the directions.
struct RayColumns {
  PointColumns o, d;

  std::size_t size() const { return o.size(); }
  Ray operator[](std::size_t i) const { return {o[i], {d[i]}}; }
};

// Laws of the batch: those of filtered.h, and hit[i] = hits(probe i, triangle i), on every machine and for every
// length. hit has the length of the triangles, else std::invalid_argument is thrown. The tally says how many each
// stage decided. Nothing is allocated. For all pairs of m probes and n triangles, ask m times one against n.

/// One probe against many triangles. About 2 ns a triangle with AVX-512, on random operands.
Tally hits(const Segment& s, const TriangleColumns& t, std::span<std::uint8_t> hit);
Tally hits(const Ray& r, const TriangleColumns& t, std::span<std::uint8_t> hit);

/// Probe i against triangle i, for all i.
Tally hits(const SegmentColumns& s, const TriangleColumns& t, std::span<std::uint8_t> hit);
Tally hits(const RayColumns& r, const TriangleColumns& t, std::span<std::uint8_t> hit);

/// One answer for each pair, as `intersect` gives it. Costs a transposition into columns more.
void intersect(std::span<const TrianglePair> pairs, std::span<Answer> answers);

/// The instruction sets that this machine can run the batch on, best first: "AVX-512", "AVX2", "portable".
std::vector<std::string_view> batch_targets();

/// Makes all later batches run on that target, for tests and benchmarks; an empty name lets the machine choose again.
/// Throws std::invalid_argument where it cannot. No batch may be running.
void force_batch_target(std::string_view name);

}  // namespace tribunal
