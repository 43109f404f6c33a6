#include "exact/plugin/children.h"

#include <sys/wait.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <utility>

#include "exact/base/failure.h"
#include "exact/base/sudden_end.h"
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
    : file_(std::move(file)),
      time_limit_(time_limit),
      server_([f = file_](int socket) { host_plugin(f, socket); }),
      introduction_(first_introduction()) {}

Child PluginChildren::take() const {
  return idle_.take_or([this] { return start(); });
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
  if (WIFEXITED(status) && WEXITSTATUS(status) == child_lacked_memory) {
    throw Failure(Exit::resources, "out of memory in a plugin's process");
  }
  if (WIFEXITED(status)) return {Status::exited, "status " + std::to_string(WEXITSTATUS(status))};
  const int signal = WTERMSIG(status);
  if (state == Transfer::late && signal == SIGKILL) return {Status::timed_out, seconds_text(seconds)};
  return {Status::crashed, signal_name(signal)};
}

/// What a child says that has loaded the library. Ends a child that has not.
Introduction PluginChildren::introduction_of(const Child& child) const {
  std::vector<char> bytes;
  const double seconds = std::max(time_limit_, seconds_to_load);
  const Transfer state = receive_message(child.socket, bytes, after_seconds(seconds));
  if (state != Transfer::done) {
    throw bad_input(file_, 0, describe(fault_of_end(child, state, time_limit_)) + " as it was loaded");
  }
  const std::optional<Introduction> received = introduction_in(std::move(bytes));
  if (received && received->failed_with == 0) return *received;
  server_.end(child, true);
  if (!received) throw bad_input(file_, 0, describe(garbled()) + " as it was loaded");
  throw Failure(static_cast<Exit>(received->failed_with), received->failure);
}

/// That of a child that is kept.
Introduction PluginChildren::first_introduction() const {
  const Child first = server_.start();
  Introduction introduction = introduction_of(first);
  give_back(first);
  return introduction;
}

/// A later child, which must have loaded the same library as the first.
Child PluginChildren::start() const {
  const Child child = server_.start();
  if (describes_the_same(introduction_of(child), introduction_)) return child;
  server_.end(child, true);
  throw bad_input(file_, 0, "describes itself in another way each time it is loaded, expected the same description");
}

}  // namespace tribunal
