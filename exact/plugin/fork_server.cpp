#include "exact/plugin/fork_server.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "exact/base/failure.h"
#include "exact/base/sudden_end.h"

namespace tribunal {
namespace {

/// What the server is asked to do: start a child (pid 0), or end one.
struct Order {
  pid_t pid;
  bool kill;
};

/// The new child's pid, or how a child ended; −1 and errno for failure.
struct Report {
  int value;
  int error;
};

struct Sockets {
  int ours = -1, theirs = -1;
};

[[noreturn]] void fail(int error) {
  throw Failure(Exit::resources, std::string("cannot start a process for a plugin: ") + std::strerror(error));
}

bool make_sockets(int type, Sockets& sockets) {
  int ends[2];
  if (socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends) != 0) return false;
  sockets = {ends[0], ends[1]};
  return true;
}

// --- one message with, perhaps, one file descriptor ----------------------------------------------------------------

union Ancillary {
  cmsghdr head;
  char room[CMSG_SPACE(sizeof(int))];
};

void send_report(int control, const Report& report, int descriptor) {
  Report copy = report;
  iovec body{&copy, sizeof copy};
  Ancillary ancillary{};
  msghdr message{};
  message.msg_iov = &body;
  message.msg_iovlen = 1;
  if (descriptor >= 0) {
    message.msg_control = ancillary.room;
    message.msg_controllen = sizeof ancillary.room;
    cmsghdr* const head = CMSG_FIRSTHDR(&message);
    head->cmsg_level = SOL_SOCKET;
    head->cmsg_type = SCM_RIGHTS;
    head->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(head), &descriptor, sizeof descriptor);
  }
  while (sendmsg(control, &message, MSG_NOSIGNAL) < 0 && errno == EINTR) {
  }
}

Report receive_report(int control, int& descriptor) {
  Report report{-1, 0};
  iovec body{&report, sizeof report};
  Ancillary ancillary{};
  msghdr message{};
  message.msg_iov = &body;
  message.msg_iovlen = 1;
  message.msg_control = ancillary.room;
  message.msg_controllen = sizeof ancillary.room;
  ssize_t received = 0;
  while ((received = recvmsg(control, &message, MSG_CMSG_CLOEXEC)) < 0 && errno == EINTR) {
  }
  if (received != static_cast<ssize_t>(sizeof report)) fail(ESRCH);
  if (const cmsghdr* const head = CMSG_FIRSTHDR(&message)) std::memcpy(&descriptor, CMSG_DATA(head), sizeof descriptor);
  return report;
}

// --- the server's process --------------------------------------------------------------------------------------------

void end_with_parent() {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
}

void redirect_standard_streams() {
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (nothing >= 0) dup2(nothing, STDIN_FILENO);
  dup2(STDERR_FILENO, STDOUT_FILENO);
}

void leave_no_core() {
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
}

/// Waits a moment for the child to end, then kills it.
int wait_for(pid_t pid) {
  constexpr int steps = 1000;
  constexpr useconds_t step = 1000;
  int status = 0;
  for (int i = 0; i < steps; ++i) {
    if (waitpid(pid, &status, WNOHANG) != 0) return status;
    usleep(i < 10 ? step / 10 : step);
  }
  kill(pid, SIGKILL);
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

int end_child(const Order& order) {
  if (order.kill) kill(order.pid, SIGKILL);
  return wait_for(order.pid);
}

/// In the server: forks a child and reports it. In the child: does not return.
pid_t start_child(int control, const ForkServer::Body& body) {
  Sockets sockets;
  if (!make_sockets(SOCK_STREAM, sockets)) {
    send_report(control, {-1, errno}, -1);
    return -1;
  }
  const pid_t pid = fork();
  if (pid == 0) {
    end_with_parent();
    close(control);
    close(sockets.ours);
    redirect_standard_streams();
    leave_no_core();
    body(sockets.theirs);
    _exit(0);
  }
  send_report(control, {pid, pid < 0 ? errno : 0}, pid < 0 ? -1 : sockets.ours);
  close(sockets.ours);
  close(sockets.theirs);
  return pid;
}

[[noreturn]] void serve(int control, const ForkServer::Body& body) {
  std::vector<pid_t> children;
  Order order{};
  for (;;) {
    const ssize_t received = recv(control, &order, sizeof order, 0);
    if (received < 0 && errno == EINTR) continue;
    if (received != static_cast<ssize_t>(sizeof order)) break;  // our process is gone
    if (order.pid == 0) {
      if (const pid_t child = start_child(control, body); child > 0) children.push_back(child);
    } else {
      const int status = end_child(order);
      std::erase(children, order.pid);
      send_report(control, {status, 0}, -1);
    }
  }
  for (const pid_t child : children) kill(child, SIGKILL);
  _exit(0);
}

}  // namespace

ForkServer::ForkServer(const Body& body) {
  Sockets sockets;
  if (!make_sockets(SOCK_SEQPACKET, sockets)) fail(errno);
  std::fflush(nullptr);  // else a child that exits would write again what waits to be written
  pid_ = fork();
  if (pid_ < 0) fail(errno);
  if (pid_ == 0) {
    become_child();
    setsid();
    close(sockets.ours);
    serve(sockets.theirs, body);
  }
  close(sockets.theirs);
  control_ = sockets.ours;
}

ForkServer::~ForkServer() {
  close(control_);
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
}

Child ForkServer::start() {
  const std::scoped_lock lock(guard_);
  const Order order{0, false};
  if (send(control_, &order, sizeof order, MSG_NOSIGNAL) < 0) fail(errno);
  Child child;
  const Report report = receive_report(control_, child.socket);
  if (report.value < 0) fail(report.error);
  child.pid = report.value;
  return child;
}

int ForkServer::end(const Child& child, bool kill) {
  close(child.socket);
  const std::scoped_lock lock(guard_);
  const Order order{child.pid, kill};
  if (send(control_, &order, sizeof order, MSG_NOSIGNAL) < 0) fail(errno);
  int none = -1;
  return receive_report(control_, none).value;
}

}  // namespace tribunal
