// Child processes on demand, from a process that was forked before any thread began.
#pragma once

#include <sys/types.h>

#include <functional>
#include <mutex>

namespace tribunal {

/// A child, and our end of the socket to it.
struct Child {
  pid_t pid = -1;
  int socket = -1;
};

/// A process of one thread that forks children when asked to: a program of many threads must not fork itself. It and
/// its children end with this object, and with this process, whichever way that ends. May be used from several threads.
class ForkServer {
 public:
  /// What a child does: serve the socket, and return when it is closed.
  using Body = std::function<void(int socket)>;

  /// Must be made while the process has one thread. Fails with Exit::resources if there can be no more processes.
  ///
  /// Children have no standard input, what they write to standard output goes to standard error, they leave no core
  /// files, and signals from the terminal do not reach them.
  explicit ForkServer(const Body& body);
  ~ForkServer();
  ForkServer(const ForkServer&) = delete;
  ForkServer& operator=(const ForkServer&) = delete;

  /// A new child. Fails with Exit::resources if there can be none.
  Child start();

  /// Ends the child, closes its socket and returns how it ended, as waitpid has it. Without `kill` the child is given a
  /// moment to end by itself.
  int end(const Child& child, bool kill);

 private:
  std::mutex guard_;
  pid_t pid_ = -1;
  int control_ = -1;
};

}  // namespace tribunal
