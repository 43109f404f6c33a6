// A share of wrong answers with what it leaves open.
#pragma once

#include "exact/base/json_fwd.h"
#include "exact/trial/judge.h"

namespace tribunal {

/// Clopper–Pearson at 95 %: two-sided where something was wrong. Zero wrong of n is known only to be at most `upper`,
/// the one-sided bound, and is drawn there.
struct Rate {
  std::uint64_t wrong = 0, judged = 0;
  double share = 0, lower = 0, upper = 1;

  bool is_bound() const { return wrong == 0; }
  double drawn() const { return is_bound() ? upper : share; }
};

Rate rate_of(std::uint64_t wrong, std::uint64_t judged);
Rate rate_of(const Count& count);

/// "8.33 %"; three digits, of a tiny share with an exponent. The one place that says a share in words.
std::string percent(double share);

/// asked, unsupported, judged, wrong, share, lower, upper, bound, drawn; and what the wrong answers are.
Json to_json(const Count& count);

/// "0.021 %", or "0 (<= 0.006 %)" for none.
std::string to_text(const Count& count);

}  // namespace tribunal
