// Children that wait for their next question.
#pragma once

#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "exact/plugin/fork_server.h"

namespace tribunal {

/// A stack of them: the last one given back is the first taken. May be used from several threads at once.
class IdleChildren {
 public:
  /// One that is idle, or else whatever `start` makes, which may take its time and is called by many threads at once.
  template <class Start>
  Child take_or(const Start& start) {
    if (const std::optional<Child> child = take()) return *child;
    return start();
  }

  void give_back(const Child& child) {
    const std::scoped_lock lock(guard_);
    idle_.push_back(child);
  }

  /// All of them; none is left.
  std::vector<Child> take_all() {
    const std::scoped_lock lock(guard_);
    return std::exchange(idle_, {});
  }

 private:
  std::optional<Child> take() {
    const std::scoped_lock lock(guard_);
    if (idle_.empty()) return std::nullopt;
    const Child child = idle_.back();
    idle_.pop_back();
    return child;
  }

  std::mutex guard_;
  std::vector<Child> idle_;
};

}  // namespace tribunal
