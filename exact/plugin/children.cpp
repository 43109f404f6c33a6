#include "exact/plugin/children.h"

#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <utility>

#include "exact/base/failure.h"
#include "exact/plugin/calls.h"

namespace tribunal {
namespace {

constexpr double seconds_to_load = 10;  ///< or the time limit, if that is longer

std::string signal_name(int signal) {
  constexpr std::pair<int, const char*> names[] = {
      {SIGSEGV, "SIGSEGV"}, {SIGABRT, "SIGABRT"}, {SIGFPE, "SIGFPE"},   {SIGILL, "SIGILL"},   {SIGBUS, "SIGBUS"},
      {SIGKILL, "SIGKILL"}, {SIGTRAP, "SIGTRAP"}, {SIGTERM, "SIGTERM"}, {SIGPIPE, "SIGPIPE"}, {SIGALRM, "SIGALRM"},
      {SIGSYS, "SIGSYS"},   {SIGXCPU, "SIGXCPU"}, {SIGHUP, "SIGHUP"},   {SIGINT, "SIGINT"}};
  for (const auto& [number, name] : names) {
    if (number == signal) return name;
  }
  return "signal " + std::to_string(signal);
}

std::string seconds_text(double seconds) {
  char text[40];
  std::snprintf(text, sizeof text, "after %g s", seconds);
  return text;
}

Fault garbled() { return {Status::gave_no_answer, "wrote to our socket"}; }

}  // namespace

PluginChildren::PluginChildren(std::string file, double time_limit)
    : file_(std::move(file)), time_limit_(time_limit), server_([f = file_](int socket) { host_plugin(f, socket); }) {
  give_back(start());
}

Child PluginChildren::take() const {
  {
    const std::scoped_lock lock(guard_);
    if (!idle_.empty()) {
      const Child child = idle_.back();
      idle_.pop_back();
      return child;
    }
  }
  return start();
}

void PluginChildren::give_back(const Child& child) const {
  const std::scoped_lock lock(guard_);
  idle_.push_back(child);
}

Reply PluginChildren::ask(const Child& child, const Message& question, double seconds,
                          const std::function<bool(const Reply&)>& is_whole) const {
  std::vector<char> bytes;
  const Deadline deadline = after_seconds(seconds);
  Transfer state = send_message(child.socket, question, deadline);
  if (state == Transfer::done) state = receive_message(child.socket, bytes, deadline);
  if (state != Transfer::done) throw CallFailed{fault_of_end(child, state, seconds)};
  const std::optional<Reply> reply = reply_in(std::move(bytes));
  const bool good = reply && (reply->fault || is_whole(*reply));
  if (good && !reply->fault) return *reply;
  server_.end(child, true);
  throw CallFailed{good ? reply->fault : garbled()};
}

/// The fault of a child that did not answer, by how it ended.
Fault PluginChildren::fault_of_end(const Child& child, Transfer state, double seconds) const {
  const int status = server_.end(child, state != Transfer::closed);
  if (state == Transfer::garbled) return garbled();
  if (WIFEXITED(status)) return {Status::exited, "status " + std::to_string(WEXITSTATUS(status))};
  const int signal = WTERMSIG(status);
  if (state == Transfer::late && signal == SIGKILL) return {Status::timed_out, seconds_text(seconds)};
  return {Status::crashed, signal_name(signal)};
}

/// A child that has loaded the library.
Child PluginChildren::start() const {
  const Child child = server_.start();
  std::vector<char> bytes;
  const double seconds = std::max(time_limit_, seconds_to_load);
  const Transfer state = receive_message(child.socket, bytes, after_seconds(seconds));
  if (state != Transfer::done) {
    throw bad_input(file_, 0, describe(fault_of_end(child, state, time_limit_)) + " as it was loaded");
  }
  const auto received = introduction_in(std::move(bytes));
  if (received && received->failed_with == 0) {
    const std::scoped_lock lock(guard_);
    introduction_ = *received;
    return child;
  }
  server_.end(child, true);
  if (!received) throw bad_input(file_, 0, describe(garbled()) + " as it was loaded");
  throw Failure(static_cast<Exit>(received->failed_with), received->failure);
}

}  // namespace tribunal
