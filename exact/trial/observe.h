// Asking a method that may throw, or answer differently when it is asked again.
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

/// The method's answer; a fault ends the command with one line that contains the case.
Answer ask_or_fail(const Method& method, const Query& query);

/// The fault that is seen when the method, which answered `first`, is asked the same query again: at once, and after
/// each of two other queries; all of this `times` times. No fault if it answers the same every time.
Fault asked_again(const Method& method, const Query& query, const Answer& first, int times = 1);

/// Asks the method, and then asks it again as asked_again does.
Asked observe(const Method& method, const Query& query, int times = 1);

/// Whether both answers have the same status and the same hit.
inline bool say_the_same(const Answer& a, const Answer& b) { return a.status == b.status && a.hit == b.hit; }

}  // namespace tribunal
