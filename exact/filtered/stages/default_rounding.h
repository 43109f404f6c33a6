// Round-to-nearest with gradual underflow, for one scope.
#pragma once

#include <cfenv>

namespace tribunal {

/// Holds the default floating-point environment and puts the caller's back. A few cycles where the caller's is the
/// default one already, else some 20 ns.
class DefaultRounding {
 public:
  DefaultRounding() : foreign_(!is_default()) {
    if (!foreign_) return;
    std::fegetenv(&callers_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultRounding() {
    if (foreign_) std::fesetenv(&callers_);
  }
  DefaultRounding(const DefaultRounding&) = delete;
  DefaultRounding& operator=(const DefaultRounding&) = delete;

 private:
  /// Whether the unit that computes doubles has the default environment. False where this cannot be read cheaply.
  static bool is_default() {
#if defined(__SSE2__)
    constexpr unsigned rounding_mode_and_flushing = 0xe040;
    return (__builtin_ia32_stmxcsr() & rounding_mode_and_flushing) == 0;
#else
    return false;
#endif
  }

  bool foreign_;
  std::fenv_t callers_;
};

}  // namespace tribunal
