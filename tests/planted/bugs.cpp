#include "tests/planted/bugs.h"

#include "core/segura_feito.h"
#include "exact/kernels/cgal_kernels.h"

namespace tribunal::planted {

Answer right(const Segment& s, const Triangle& t) { return segura_feito(s, t, EpickKernel{}); }

Method method(const char* name, const char* what, std::function<Answer(const Segment&, const Triangle&)> decide) {
  return {.name = name,
          .number = "as planted",
          .contract = "segment; any triangle",
          .summary = what,
          .reference = "tests/planted",
          .convention = Convention::closed,
          .format = Format::binary64,
          .exact = true,
          .segment = std::move(decide),
          .ray = [](const Ray&, const Triangle&) { return refusal(Status::unsupported); },
          .classify = {},
          .compare_hits = {}};
}

std::vector<Method> bugs() {
  std::vector<Method> all;
  for (const auto rows :
       {sign_bugs, coplanar_bugs, operand_bugs, jimenez_bugs, filter_bugs, contraction_bugs, cgal_bugs}) {
    for (Method& m : rows()) all.push_back(std::move(m));
  }
  return all;
}

std::vector<Method> sound_twins() { return {sound_jimenez(), sound_filter(), sound_expansion()}; }

}  // namespace tribunal::planted
