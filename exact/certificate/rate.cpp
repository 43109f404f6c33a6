#include "exact/certificate/rate.h"

#include <cstdio>

#include "exact/base/json.h"
#include "exact/certificate/bounds.h"
#include "exact/record/sample_row.h"

namespace tribunal {

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g %%", 100 * share);
  return text;
}

Rate rate_of(std::uint64_t k, std::uint64_t n) {
  if (k == 0) return {0, n, 0, 0, upper_bound(0, n, confidence_alpha)};
  const double tail = confidence_alpha / 2;
  return {k, n, static_cast<double>(k) / static_cast<double>(n), lower_bound(k, n, tail), upper_bound(k, n, tail)};
}

Rate rate_of(const Count& count) { return rate_of(count.wrong, count.judged()); }

Json to_json(const Count& count) {
  const Rate rate = rate_of(count);
  Json object = outcomes_of(count);
  object.update({{"asked", count.asked},
                 {"unsupported", count.unsupported},
                 {"judged", rate.judged},
                 {"wrong", rate.wrong},
                 {"share", rate.share},
                 {"lower", rate.lower},
                 {"upper", rate.upper},
                 {"bound", rate.is_bound()},
                 {"drawn", rate.drawn()}});
  return object;
}

std::string to_text(const Count& count) {
  const Rate rate = rate_of(count);
  if (rate.judged == 0) return "nothing judged";
  return rate.is_bound() ? "0 (<= " + percent(rate.upper) + ")" : percent(rate.share);
}

}  // namespace tribunal
