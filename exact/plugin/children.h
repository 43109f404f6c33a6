// Child processes that have loaded one plugin.
#pragma once

#include <functional>
#include <string>

#include "exact/plugin/fork_server.h"
#include "exact/plugin/host.h"
#include "exact/plugin/idle_children.h"

namespace tribunal {

/// The library is never loaded in this process. May be used from several threads at once.
class PluginChildren {
 public:
  /// Must be made before any thread starts. Fails like load_plugin.
  PluginChildren(std::string file, double time_limit);

  const std::string& file() const { return file_; }
  /// Seconds within which a question must be answered.
  double time_limit() const { return time_limit_; }
  /// That of the first child. Later ones introduce the library alike, or cannot be taken.
  const Introduction& introduction() const { return introduction_; }

  /// A child that waits for questions, and back. Fails like load_plugin.
  Child take() const;
  void give_back(const Child& child) const { idle_.give_back(child); }
  void end(const Child& child) const { server_.end(child, true); }

  /// The child's reply, which must be whole. Otherwise the child is ended, and the call fails with CallFailed.
  Reply ask(const Child& child, const Message& question, double seconds,
            const std::function<bool(const Reply&)>& is_whole) const;

 private:
  Fault fault_of_end(const Child& child, Transfer state, double seconds) const;
  Introduction introduction_of(const Child& child) const;
  Introduction first_introduction() const;
  Child start() const;

  std::string file_;
  double time_limit_;
  mutable ForkServer server_;
  mutable IdleChildren idle_;
  const Introduction introduction_;  ///< read by many threads at once
};

}  // namespace tribunal
