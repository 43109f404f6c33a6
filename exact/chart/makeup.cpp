#include "exact/chart/makeup.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "exact/base/interrupt.h"
#include "exact/base/parallel.h"
#include "exact/methods/methods.h"

namespace tribunal {
namespace {

constexpr std::uint64_t block_size = 256;

double least_normal(Format format) {
  return format == Format::binary32 ? std::numeric_limits<float>::min() : std::numeric_limits<double>::min();
}

std::vector<Point3> points_of(const Query& query) {
  std::vector<Point3> points;
  if (const Segment* s = std::get_if<Segment>(&query.probe)) points = {s->p, s->q};
  if (const Ray* r = std::get_if<Ray>(&query.probe)) points = {r->o, r->d.v};
  if (query.operands() == Operands::polygons) {
    const std::vector<Point3>& vertices = query.polygon().vertices;
    points.insert(points.end(), vertices.begin(), vertices.end());
  } else {
    const Triangle& t = query.triangle();
    points.insert(points.end(), {t.a, t.b, t.c});
  }
  return points;
}

void add(Makeup& sum, const Query& query, Format format) {
  const Answer answer = flagship_method().ask(query);
  ++sum.cases;
  sum.hits += answer.hit;
  sum.subnormal += has_subnormal(query, format);
  ++sum.by_stage[static_cast<std::size_t>(answer.stage)];
}

}  // namespace

Makeup& Makeup::operator+=(const Makeup& other) {
  cases += other.cases;
  hits += other.hits;
  subnormal += other.subnormal;
  for (std::size_t i = 0; i < by_stage.size(); ++i) by_stage[i] += other.by_stage[i];
  return *this;
}

bool has_subnormal(const Query& query, Format format) {
  const double least = least_normal(format);
  const auto is_subnormal = [&](double x) { return x != 0 && std::fabs(x) < least; };
  return std::ranges::any_of(
      points_of(query), [&](const Point3& v) { return is_subnormal(v.x) || is_subnormal(v.y) || is_subnormal(v.z); });
}

Makeup makeup_of(const Population& population, Format format, std::uint64_t seed, std::uint64_t cases,
                 unsigned threads) {
  std::vector<Makeup> sums(threads);
  const auto work = [&](std::size_t block, unsigned worker) {
    const std::uint64_t first = block * block_size;
    for (std::uint64_t k = first; k < std::min(first + block_size, cases); ++k) {
      add(sums[worker], population.family.make(format, seed, k).query, format);
    }
  };
  run_blocks((cases + block_size - 1) / block_size, threads, work);
  fail_if_interrupted("no chart written");
  Makeup total;
  for (const Makeup& sum : sums) total += sum;
  return total;
}

}  // namespace tribunal
