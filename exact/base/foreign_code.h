// Whose code runs: ours, or a plugin's.
#pragma once

#include "exact/base/plain_locale.h"

namespace tribunal {

/// Held while a thread runs code that is not ours. What fails there is that code's own affair: it gets the null pointer
/// or the error number that it asked for, where a call of ours would have ended the program. The thread has the plain
/// locale again at the end.
class ForeignCode {
 public:
  ForeignCode() { ++depth_; }
  ~ForeignCode() {
    --depth_;
    use_plain_locale();
  }
  ForeignCode(const ForeignCode&) = delete;
  ForeignCode& operator=(const ForeignCode&) = delete;

  static bool runs_here() { return depth_ > 0; }

 private:
  static inline constinit thread_local int depth_ = 0;
};

}  // namespace tribunal
