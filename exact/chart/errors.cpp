#include "exact/chart/errors.h"

#include <algorithm>

#include "exact/trial/exact_hit.h"
#include "exact/trial/judge.h"

namespace tribunal {
namespace {

/// A ray that has numbers, and what they are.
struct MeasuredRay {
  std::uint64_t k;
  Query query;
  Truth truth;
  ExactHit hit;
};

std::vector<MeasuredRay> rays_of(const Population& population, Format format, std::uint64_t seed, std::uint64_t cases) {
  std::vector<MeasuredRay> rays;
  for (std::uint64_t k = 0; k < cases; ++k) {
    const Query of_segment = population.family.make(format, seed, k).query;
    const Segment& s = std::get<Segment>(of_segment.probe);
    const Ray ray{s.p, {in_format(s.q - s.p, format)}};
    if (!is_finite(ray)) continue;
    const Query query{ray, of_segment.triangle()};
    const Truth truth = exact_truth(query);
    if (has_numbers(query, truth)) rays.push_back({k, query, truth, exact_hit(ray, query.triangle())});
  }
  return rays;
}

HitErrors errors_of(const Method& method, const std::vector<MeasuredRay>& rays) {
  HitErrors errors;
  for (const MeasuredRay& r : rays) {
    const Answer answer = method.ask(r.query);
    if (!answer.hit || judge(method, r.truth, answer) != Outcome::right) continue;
    add_numbers(errors, numbers_of(method, r.query), r.hit, method.contract.format, r.k);
  }
  return errors;
}

}  // namespace

std::vector<HitErrors> errors_on(const Population& population, Format format, std::uint64_t seed, std::uint64_t cases,
                                 const std::vector<Method>& methods) {
  std::vector<HitErrors> errors(methods.size());
  if (std::ranges::none_of(methods, gives_numbers)) return errors;
  const std::vector<MeasuredRay> rays = rays_of(population, format, seed, cases);
  for (std::size_t m = 0; m < methods.size(); ++m) {
    if (gives_numbers(methods[m]) && takes(methods[m], format)) errors[m] = errors_of(methods[m], rays);
  }
  return errors;
}

}  // namespace tribunal
