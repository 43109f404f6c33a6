#include "tests/planted/bugs.h"

#include "core/segura_feito.h"
#include "exact/methods/cgal_kernels.h"

namespace tribunal::planted {

Answer right(const Segment& s, const Triangle& t) { return segura_feito(s, t, EpickKernel{}); }
Answer right_of_ray(const Ray& r, const Triangle& t) { return segura_feito(r, t, EpickKernel{}); }

Method method(const char* name, const char* what, Decision decide, RayDecision decide_ray) {
  const bool takes_rays = decide_ray != nullptr;
  if (!takes_rays) decide_ray = [](const Ray&, const Triangle&) { return refusal(Status::unsupported); };
  return {.name = name,
          .card = {.number = "as planted", .summary = what, .reference = "tests/planted"},
          .contract = {.probes = {.rays = takes_rays}, .exact = true},
          .segment = std::move(decide),
          .ray = std::move(decide_ray)};
}

Method ray_method(const char* name, const char* what, RayDecision decide) {
  return method(
      name, what, [](const Segment& s, const Triangle& t) { return right(s, t); }, std::move(decide));
}

std::vector<Method> bugs() {
  std::vector<Method> all;
  for (const auto rows : {sign_bugs, coplanar_bugs, operand_bugs, jimenez_bugs, published_bugs, filter_bugs,
                          contraction_bugs, cgal_bugs, range_bugs, ray_bugs, bounds_bugs}) {
    for (Method& m : rows()) all.push_back(std::move(m));
  }
  return all;
}

std::vector<Method> sound_twins() {
  return {sound_jimenez(), sound_filter(), sound_expansion(), sound_ray(), sound_bounds()};
}

}  // namespace tribunal::planted
