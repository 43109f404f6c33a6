#include "exact/chart/pairs.h"

#include <cmath>

#include "exact/cases/families/affine.h"
#include "exact/classes/class_table.h"
#include "exact/filtered/filtered.h"

namespace tribunal {
namespace {

enum RandomStream : std::uint32_t { random_stream = stream_of("benchmark pairs"), triangle_stream, degenerate_stream };

Point3 unit_point(Draw& draw) {
  Point3 p;
  for (int axis = 0; axis < 3; ++axis) p[axis] = std::ldexp(static_cast<double>(draw.next() >> 11), -53);
  return p;
}

bool segment_hits(const SegmentPair& p) { return hits(p.segment, p.triangle); }
bool ray_hits(const SegmentPair& p) { return hits(ray_of(p), p.triangle); }

/// Deals hits and misses from an endless source so that exactly this share of any 100 in a row hits, in mixed order.
template <class Source>
std::vector<SegmentPair> with_hits(std::size_t n, int percent, const Source& source,
                                   bool (*is_hit)(const SegmentPair&)) {
  std::vector<SegmentPair> pairs;
  std::vector<SegmentPair> waiting[2];
  for (std::uint64_t k = 0; pairs.size() < n;) {
    const bool wanted = static_cast<int>(pairs.size() * 37 % 100) < percent;  // 37: coprime to 100, so no runs
    std::vector<SegmentPair>& stock = waiting[wanted];
    while (stock.empty()) {
      const SegmentPair p = source(k++);
      waiting[is_hit(p)].push_back(p);
    }
    pairs.push_back(stock.back());
    stock.pop_back();
  }
  return pairs;
}

bool is_regular(const ClassRow& row) { return row.triangle == "tri" && row.probe == "seg"; }

/// Small integers: all five volumes are exact, and one is zero iff four of the five points are coplanar.
bool has_zero_volume(const ClassRow& row) {
  const auto [sides, edges] = detail::shared_volumes<Segment>(
      detail::arms_of<double>(row.representative_segment(), row.representative_triangle()));
  return sides.source * sides.target * edges.ab * edges.bc * edges.ac == 0;
}

std::vector<ClassId> degenerate_classes() {
  std::vector<ClassId> ids;
  for (const ClassRow& row : class_table()) {
    if (is_regular(row) && has_zero_volume(row)) ids.push_back(row.id);
  }
  return ids;
}

SegmentPair pair_of(const Trial& t) { return {std::get<Segment>(t.query.probe), t.query.triangle()}; }

}  // namespace

SegmentPair random_pair(std::uint64_t k) {
  Draw draw(random_stream, 1, k);
  Point3 v[5];
  for (Point3& p : v) p = unit_point(draw);
  return {{v[0], v[1]}, {v[2], v[3], v[4]}};
}

std::vector<SegmentPair> random_pairs(std::size_t n, int percent_hits) {
  return with_hits(n, percent_hits, random_pair, segment_hits);
}

std::vector<SegmentPair> random_rays(std::size_t n, int percent_hits) {
  const auto ray = [](std::uint64_t k) {
    SegmentPair p = random_pair(k);
    p.segment.q -= p.segment.p;
    return p;
  };
  return with_hits(n, percent_hits, ray, ray_hits);
}

std::vector<SegmentPair> one_segment_pairs(std::size_t n) {
  const Segment s{{0.25, 0.25, 0.125}, {0.625, 0.75, 0.875}};
  const auto pair = [&](std::uint64_t k) {
    Draw draw(triangle_stream, 1, k);
    Triangle t;
    for (Point3* p : {&t.a, &t.b, &t.c}) *p = unit_point(draw);
    return SegmentPair{s, t};
  };
  return with_hits(n, 7, pair, segment_hits);
}

std::vector<SegmentPair> degenerate_pairs(std::size_t n, int bits) {
  const std::vector<ClassId> ids = degenerate_classes();
  std::vector<SegmentPair> pairs;
  for (std::uint64_t k = 0; pairs.size() < n; ++k) {
    Draw draw(degenerate_stream, static_cast<std::uint64_t>(bits), k);
    const AffineMap map = draw_map(draw, bits);
    pairs.push_back(pair_of(image_of({ids[k % ids.size()], 0}, map, Format::binary64, draw)));
  }
  return pairs;
}

std::vector<SegmentPair> near_pairs(std::size_t n) {
  std::vector<SegmentPair> pairs = degenerate_pairs(n, 50);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    double& x = pairs[i].segment.p[static_cast<int>(i % 3)];
    for (std::size_t ulps = 0; ulps <= i / 3 % 3; ++ulps) x = std::nextafter(x, i % 2 == 0 ? INFINITY : -INFINITY);
  }
  return pairs;
}

std::vector<SegmentPair> mixed_pairs(std::size_t n, int percent_degenerate) {
  std::vector<SegmentPair> pairs = random_pairs(n, 7);
  const std::vector<SegmentPair> degenerate = degenerate_pairs(n, 50);
  for (std::size_t i = 0; i < n; ++i) {
    if (static_cast<int>(i * 61 % 100) < percent_degenerate) pairs[i] = degenerate[i];
  }
  return pairs;
}

}  // namespace tribunal
