// Asking a method that may be no function: it may throw, or answer otherwise when it is asked again.
#pragma once

#include "core/method.h"
#include "exact/base/fault.h"

namespace tribunal {

/// An answer, or the fault that there was instead; then the answer is `unsupported`.
struct Asked {
  Answer answer{};
  Fault fault{};
};

Asked try_ask(const Method& method, const Query& query);

/// The method's answer, for those who go no further than a fault: it ends the command with one line that has the case.
Answer ask_or_fail(const Method& method, const Query& query);

/// What shows when the method, which answered thus, is asked the same again: at once, and after each of two other
/// questions; all that `times` over. No fault if it answers the same every time.
Fault asked_again(const Method& method, const Query& query, const Answer& first, int times = 1);

/// Asks, and asks again.
Asked observe(const Method& method, const Query& query, int times = 1);

/// Whether they say the same of a hit.
inline bool say_the_same(const Answer& a, const Answer& b) { return a.status == b.status && a.hit == b.hit; }

}  // namespace tribunal
