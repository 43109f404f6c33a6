// Child processes that have loaded one plugin.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "exact/plugin/fork_server.h"
#include "exact/plugin/host.h"

namespace tribunal {

/// The library is never loaded in this process. May be used from several threads at once.
class PluginChildren {
 public:
  /// Must be made before any thread starts. Fails like load_plugin.
  PluginChildren(std::string file, double time_limit);

  const std::string& file() const { return file_; }
  /// Seconds within which a question must be answered.
  double time_limit() const { return time_limit_; }
  const Introduction& introduction() const { return introduction_; }

  /// A child that waits for questions, and back.
  Child take() const;
  void give_back(const Child& child) const;
  void end(const Child& child) const { server_.end(child, true); }

  /// The child's reply, which must be whole. Otherwise the child is ended, and the call fails with CallFailed.
  Reply ask(const Child& child, const Message& question, double seconds,
            const std::function<bool(const Reply&)>& is_whole) const;

 private:
  Fault fault_of_end(const Child& child, Transfer state, double seconds) const;
  Child start() const;

  std::string file_;
  double time_limit_;
  mutable ForkServer server_;
  mutable std::mutex guard_;
  mutable std::vector<Child> idle_;
  mutable Introduction introduction_{};
};

}  // namespace tribunal
